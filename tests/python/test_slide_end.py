# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slides that leave the object at a given pose: plans, files, pictures, chains and mistakes."""

import copy
import json

import numpy as np
import pytest

import graspless
from graspless import following, view
from graspless.cli import main
from graspless.errors import TaskError
from graspless.plan_files import plan_of
from graspless.plan_files.text import document_of

TASK = {
    "kind": "slide",
    "robot": {"urdf": "wam_t42"},
    "object": {
        "rectangle": {"size": [0.12, 0.08]},
        "thickness": 0.004,
        "pose": {"x": 0.62, "y": -0.32, "yaw": 1.57},
    },
    "support": {"rectangle": {"center": [0.65, 0.0], "size": [0.7, 0.7]}},
    "end": {"x": 0.58, "y": -0.12, "yaw": 1.0},
}


@pytest.fixture(scope="module")
def plan():
    found = graspless.plan(TASK, seed=1)
    assert found, found.reason
    return found


def changed(**fields):
    return {**copy.deepcopy(TASK), **fields}


def test_the_object_is_left_at_its_end(plan):
    assert [segment.name for segment in plan.segments] == ["approach", "press", "slide", "lift"]
    assert plan.X_WO_goal[:2, 3] == pytest.approx([0.58, -0.12], abs=1e-4)
    assert np.arctan2(plan.X_WO_goal[1, 0], plan.X_WO_goal[0, 0]) == pytest.approx(1.0, abs=1e-3)
    assert graspless.check(plan) == []


def test_a_file_keeps_it(plan, tmp_path):
    plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert graspless.check(again) == []
    assert again.task.problem.X_WO_end == pytest.approx(plan.task.problem.X_WO_end)
    assert graspless.plan(again.task).X_WO_goal == pytest.approx(plan.X_WO_goal)
    of_problem = graspless.slide.plan(plan.task.problem, plan.task.options, plan.task.budget)
    assert of_problem.task.to_dict()["end"] == pytest.approx(TASK["end"])


def test_check_finds_another_end(plan):
    document = document_of(plan)
    document["task"]["end"]["x"] += 0.001
    faults = graspless.check(plan_of(json.loads(json.dumps(document)), "plan"))
    assert any("the object is not at its end" in fault for fault in faults)


def test_check_finds_an_end_that_the_task_of_a_chain_does_not_ask_for():
    shared = {key: value for key, value in TASK.items() if key not in ("kind", "end")}
    stage = {"name": "slide", "kind": "slide", "end": TASK["end"]}
    found = graspless.plan({"kind": "chain", **shared, "stages": [stage]}, seed=1)
    assert found, found.reason
    document = document_of(found)
    del document["task"]["stages"][0]["end"]
    faults = graspless.check(plan_of(json.loads(json.dumps(document)), "plan"))
    assert faults == ["stage 0 'slide': end is not what the chain's task says"]


@pytest.mark.parametrize("model", ["flexure", "rigid_guarded"])
def test_it_is_executed(model):
    plan = graspless.plan(changed(hand={"finger_model": model}), seed=1)
    assert plan, plan.reason
    done = graspless.simulate(plan, trials=3)
    assert done, [trial.failures for trial in done.trials]
    assert done.trials[0].measures["position_error"] < 0.01


def test_the_simulation_notices_an_object_that_is_elsewhere(plan):
    document = document_of(plan)
    for segment in document["segments"]:
        if segment["name"] == "slide":  # the commands alone stop early
            rows = len(segment["positions"])
            stop = segment["positions"][rows // 2]
            segment["positions"][rows // 2 :] = [stop] * (rows - rows // 2)
        if segment["name"] == "lift":
            segment["positions"] = [stop] * len(segment["positions"])
    early = plan_of(json.loads(json.dumps(document)), "plan")
    assert "off_target" in graspless.simulate(early).trials[0].failures


def test_it_is_drawn_and_timed(plan, tmp_path):
    view.write_png(plan, tmp_path / "plan.png")
    view.write_html(plan, tmp_path / "plan.html")
    assert (tmp_path / "plan.png").stat().st_size > 20_000
    assert graspless.time(plan).duration > 1


def test_a_follower_does_not_take_it(plan):
    with pytest.raises(TaskError, match="leaves the object at an `end` cannot be followed"):
        following.Follower(plan)


def test_what_is_in_the_way_is_named():
    jug = {"name": "jug", "box": [0.06, 0.06, 0.2], "pose": {"position": [0.58, -0.12, 0.1]}}
    found = graspless.plan(changed(obstacles=[jug]), seed=1, iterations=300)
    assert not found
    assert "jug" in found.reason


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"end": {"x": 2.0}}, r"end: object 'object' is off the support"),
        ({"end": {"x": 0.6, "z": 0.1}}, r"end\.z: unknown field"),
        ({"end": "here"}, r"end: .*here"),
        ({"options": {"search": "paper"}}, r"options\.search: paper: must be fast"),
    ],
)
def test_mistakes_name_the_field(fields, words):
    with pytest.raises(TaskError, match=words):
        graspless.plan(changed(**fields))


def test_a_pinch_has_no_end():
    with pytest.raises(TaskError, match="end: unknown field"):
        graspless.plan(changed(kind="pinch"))


def test_the_command(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "task.yaml").write_text(json.dumps(TASK))
    assert main(["plan", "task.yaml", "-o", "plan.json", "--seed", "1"]) == 0
    assert "and is left there" in capsys.readouterr().out
    assert main(["check", "plan.json", "--certify"]) == 0
    (tmp_path / "task.yaml").write_text(json.dumps(changed(end={"x": 0.6, "y": -0.345})))
    assert main(["plan", "task.yaml"]) == 1
    assert "options.com_margin asks for 10 mm" in capsys.readouterr().out
    (tmp_path / "task.yaml").write_text(json.dumps(changed(end={"x": 2.0})))
    assert main(["plan", "task.yaml"]) == 2


def test_a_slide_or_a_pinch_follows_it():
    first = {"name": "aside", "kind": "slide", "end": TASK["end"]}
    shared = {key: value for key, value in TASK.items() if key not in ("kind", "end")}
    chain = {"kind": "chain", **shared, "stages": [first, {"name": "take", "kind": "slide"}]}
    found = graspless.plan(chain, seed=1)
    assert found, found.reason
    assert graspless.check(found) == []
    assert found.joins[0].how == "arm"
    lift = {"name": "lift", "kind": "carry", "line": {"direction": [0, 0, 1], "distance": 0.1}}
    chain["stages"][1] = lift
    with pytest.raises(TaskError, match="nothing is held after 'aside'"):
        graspless.plan(chain)
    thing = {"cloud": "x.ply"}
    chain["stages"][1] = {"name": "take", "kind": "clasp", "object": thing}
    with pytest.raises(TaskError, match="'aside' leaves the object on its support"):
        graspless.plan(chain)


def test_a_search_that_cannot_do_it_is_told_with_its_flag(tmp_path, capsys):
    (tmp_path / "task.yaml").write_text(json.dumps(TASK))
    assert main(["plan", str(tmp_path / "task.yaml"), "--search", "paper"]) == 2
    assert capsys.readouterr().err.startswith("--search: options.search: must be fast for a slide")
