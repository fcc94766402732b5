# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields in plain types, part by part, and what is left undone with a time limit."""

import gc
import json

import numpy as np
import pytest

from graspless import _commands, _data, limits, load_task
from graspless.errors import OutOfTimeError
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
