# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fingertip plans and clasps that go on from measured states."""

import json

import numpy as np
import pytest

import clasp_common
import graspless
from fingertip_common import PUSH, TUMBLE, changed
from graspless import TaskError, clasp, fingertip, frames, planning, slide
from graspless.tasks import read_task
from tasks_common import reread

START = changed("friction: 0.7}", "friction: 0.7, start: [[0, -0.05, 0], [0, 0.05, 0.005]]}")


def planned(text):
    plan = graspless.plan(read_task(text, "block.yaml"))
    assert plan, plan.reason
    return plan


def test_a_task_file_says_where_the_fingers_start(tmp_path):
    plan = planned(START)
    first = plan.segments[0].rows[0].fingers
    np.testing.assert_allclose([f.p_OC for f in first], [[0, -0.05, 0], [0, 0.05, 0.005]])
    again = reread(json.loads(plan.to_json()), tmp_path / "plan.json")
    assert again == plan
    assert graspless.check(again) == []


@pytest.mark.parametrize(
    ("start", "words"),
    [
        ("[[0, -0.05, 0]]", "fingers.start: must hold a place for each of 2 fingers"),
        ("[[0, -0.05, 0], [0, 0.04, 0]]", r"fingers.start\[1\]: must lie on the object's surface"),
        ("[[0, -0.05, 0], [0, 0.05]]", "fingers.start.1"),
    ],
)
def test_a_start_where_no_finger_can_be_is_refused(start, words):
    text = changed("friction: 0.7}", f"friction: 0.7, start: {start}}}")
    with pytest.raises(ValueError, match=words):
        graspless.plan(read_task(text, "block.yaml"))


@pytest.mark.parametrize("text", [PUSH, TUMBLE])
def test_a_plan_goes_on_from_where_the_object_is(text, tmp_path):
    plan = planned(text)
    for index, segment in enumerate(plan.segments):
        X_WO = segment.X_WO[len(segment.X_WO) // 2]
        rest = fingertip.resume(plan, index, X_WO)
        assert rest, f"{rest.status}: {rest.reason}"
        assert graspless.check(rest) == []
        saved = reread(json.loads(rest.to_json()), tmp_path / "plan.json")
        assert graspless.check(saved) == []
        assert saved.segments[0].X_WO[0] == pytest.approx(X_WO, abs=1e-6)
        further = fingertip.resume(rest, 0, rest.segments[0].X_WO[-1])
        assert further or further.status == "at_goal"


def test_a_plan_does_not_go_on_from_anywhere_else():
    plan = planned(PUSH)
    X_WO = plan.segments[0].X_WO[3]
    assert fingertip.resume(plan, 0, frames.translation([0, 0.05, 0]) @ X_WO).status == "off_path"
    with pytest.raises(ValueError, match="segment must be 0 to"):
        fingertip.resume(plan, 7, X_WO)
    with pytest.raises(ValueError, match="X_WO"):
        fingertip.resume(plan, 0, np.full((4, 4), np.nan))


def test_a_clasp_is_planned_anew_while_the_hand_is_on_its_way():
    plan = clasp.plan(clasp_common.problem(), budget=planning.Budget(seconds=20, seed=3))
    assert plan, plan.reason
    reach = plan.segments[0]
    q = reach.positions[len(reach) // 2]
    X_WO = frames.translation([0.01, -0.008, 0.005]) @ plan.task.problem.X_WO
    anew = clasp.resume(plan, q, X_WO)
    assert anew, f"{anew.status}: {anew.reason}"
    assert graspless.check(anew) == []
    np.testing.assert_array_equal(anew.task.problem.X_WO, X_WO)
    arm = anew.task.problem.robot.group(anew.task.problem.hand.arm)
    np.testing.assert_array_equal(anew.segments[0].positions[0][arm], q[arm])
    with pytest.raises(ValueError, match="q_start"):
        clasp.resume(plan, q[:3], X_WO)


@pytest.mark.parametrize(
    ("room", "given", "words"),
    [
        (slide, [5, [0.0], np.eye(4)], "problem: 5: should be a graspless.slide.Problem or "),
        (clasp, [None, [0.0], np.eye(4)], "problem: None: should be a graspless.clasp.Problem or "),
        (fingertip, [None, 0, np.eye(4)], "plan: None: should be a graspless.fingertip.Plan"),
    ],
)
def test_what_is_no_plan_is_not_resumed(room, given, words):
    with pytest.raises(TaskError, match=words):
        room.resume(*given)
