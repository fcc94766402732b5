# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields in plain types, part by part, and what is left undone with a time limit."""

import gc
import json
import types

import numpy as np
import pytest
import yaml

from graspless import _commands, _data, limits, load_task, picking, robot
from graspless._load import as_task
from graspless.errors import OutOfTimeError, TaskError
from graspless.picking.place_fields import place_of
from graspless.tasks import documents

EXAMPLES = sorted(_data.directory("examples").glob("*.yaml"))


def dumped(fields):
    return fields.model_dump(mode="json", exclude_none=True)


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_documents_are_those_of_pydantic(path, monkeypatch):
    monkeypatch.setattr(documents, "PART", 2)  # so that most lists are long
    fields = load_task(path).fields
    assert json.dumps(documents.document_of(fields)) == json.dumps(dumped(fields))


def test_rows_are_those_of_numpy():
    for count in (0, 1, documents.PART, 2 * documents.PART + 3):
        array = np.random.default_rng(1).normal(size=(count, 3))
        assert documents.rows_of(array) == array.tolist()


def of_numpy(value):
    """The same document as callers of numpy have it."""
    if isinstance(value, dict):
        return {key: of_numpy(item) for key, item in value.items()}
    try:
        array = np.array(value)
    except ValueError:  # rows of several lengths
        array = np.array(None)
    if array.size and array.dtype.kind in "bif":
        return array[()]
    return tuple(map(of_numpy, value)) if isinstance(value, list) else value


@pytest.mark.parametrize("name", ["01_slide_card", "06_push_block", "13_clasp_purse", "24_carry"])
def test_a_dict_may_hold_arrays_numbers_and_tuples_of_numpy(name):
    task = load_task(next(path for path in EXAMPLES if path.stem.startswith(name)))
    document = of_numpy(task.to_dict())
    assert isinstance(document["budget"]["seed"], np.int64)
    assert as_task(document) == task


def test_a_dict_may_hold_paths_and_small_floats():
    path, least = robot.builtin("kr5_t42"), np.float32(0.03)
    given = yaml.safe_load(EXAMPLES[0].read_text())
    given = given | {"robot": {"urdf": path}, "options": {"min_overhang": least}}
    task = as_task(types.MappingProxyType(given))
    assert task.options.min_overhang == float(least)
    assert task.with_options(min_overhang=np.float32(0.02)).options.min_overhang < float(least)
    assert task.with_changes(seed=np.int64(3), seconds=np.float32(2.5)).budget.seconds == 2.5
    given["robot"]["home"] = np.array([[0.0]])
    with pytest.raises(TaskError, match=r"^task: robot.home.* valid number"):
        as_task(given)
    given["robot"] = given
    with pytest.raises(TaskError, match="^task: nested too deeply$"):
        as_task(given)


def test_a_pick_takes_what_a_dict_may_hold():
    given = {"urdf": robot.builtin("wam_t42"), "home": np.array([0.0, 0.2])}
    assert picking.labelled(given) == {"wam_t42": {"urdf": str(given["urdf"]), "home": [0.0, 0.2]}}
    assert place_of({"pose": {"x": np.float32(0.5), "y": np.int64(0)}}).pose.x == 0.5


def test_another_time_limit_leaves_the_rest_of_a_task_as_it_is():
    task = load_task(EXAMPLES[0])
    changed = task.with_changes(seconds=3.5, seed=7)
    assert (changed.budget.seconds, changed.budget.seed) == (3.5, 7)
    assert changed.fields.object is task.fields.object  # neither written nor read anew
    assert changed.to_dict() == task.to_dict() | {
        "budget": task.to_dict()["budget"] | {"seconds": 3.5, "seed": 7}
    }


def test_an_alarm_that_a_library_turns_into_an_error_is_an_alarm():
    said = r"^budget.seconds: 0.01 s were over"
    with pytest.raises(OutOfTimeError, match=said), limits.reading(0.01, alarm=True):
        try:
            while True:
                pass
        except BaseException:
            raise RuntimeError("Error building a validator") from None


@pytest.mark.parametrize("ends", [False, True])
def test_a_command_that_ends_does_not_visit_its_tree_again(monkeypatch, ends):
    monkeypatch.setattr(_commands, "ends_with_command", ends)
    monkeypatch.setattr(limits, "_left", [])
    try:
        interrupted = pytest.raises(KeyboardInterrupt)
        with interrupted, limits.reading(alarm=True), limits.without_collector():
            raise KeyboardInterrupt
        assert gc.isenabled() is not ends
        assert len(limits._left) == ends
    finally:
        gc.enable()
