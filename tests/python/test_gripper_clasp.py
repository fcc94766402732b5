# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clasps with a parallel gripper: curves without corners in the palm, pinches, thick handles."""

import json

import numpy as np
import pytest
import yaml

import graspless
from graspless import clasp
from graspless.cli import main
from inspect_common import gripper

FINGERS = {
    "fingers": {
        "left": [{"link": "left", "point": [0, 0.005, z]} for z in (0.01, 0.075)],
    },
    "thumb": [{"link": "right", "point": [0, -0.005, z]} for z in (0.01, 0.075)],
}
LIGHT = {"force": 0.2, "torque": 0.004}  # what fingers of 12.5 N withstand
HAND = {"frame": "palm", "forward": [0, 0, 1], "sideways": [1, 0, 0], **FINGERS}


def ring(thickness, radius=0.1):
    """Points on an upright torus in the plane y = 0."""
    around = np.linspace(0, 2 * np.pi, 120, endpoint=False)
    count = max(12, round(640 * thickness))  # spread evenly
    across = np.linspace(0, 2 * np.pi, count, endpoint=False)
    a, b = (angles.ravel() for angles in np.meshgrid(around, across))
    r = radius + thickness / 2 * np.cos(b)
    return np.column_stack([r * np.cos(a), thickness / 2 * np.sin(b), r * np.sin(a)]).round(5)


@pytest.fixture
def task(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.urdf").write_text(gripper())

    def write(thickness=0.02, **changes):
        fields = {
            "kind": "clasp",
            "robot": {"urdf": "mine.urdf"},
            "hand": HAND,
            "object": {
                "points": ring(thickness).tolist(),
                "pose": {"position": [0.4, 0.05, 0.2], "rpy": [0, 0, 0.5]},
            },
            "options": {"stability": LIGHT},
            "budget": {"seconds": 120, "iterations": 60, "seed": 1},
        } | changes
        (tmp_path / "task.yaml").write_text(yaml.safe_dump(fields))
        return "task.yaml"

    return write


@pytest.fixture
def plan(task):
    with pytest.warns(UserWarning, match="no SRDF"):
        found = graspless.plan(task())
    assert found, found.reason
    return found


def test_a_hand_without_corners_in_the_palm_holds_a_bar(plan):
    assert graspless.check(plan) == []
    hand = plan.task.problem.hand
    for finger in (*hand.fingers, hand.thumb):
        assert [node.link for node in finger.nodes][0] == "palm"
    assert plan.stability.secure == (plan.pinch is None)
    if plan.pinch is not None:
        assert plan.pinch.press == pytest.approx(12.5, rel=0.01)  # half of 50 N, on two fingers
        assert plan.pinch.load >= 1
    q = plan.segments[-1].positions[-1]
    assert clasp.test_pinch(plan.task.problem, q).gap < 0.003


def test_plan_files_keep_the_pinch(plan, tmp_path):
    plan.save("plan.json")
    again = graspless.load_plan("plan.json")
    assert again == plan
    fields = json.loads((tmp_path / "plan.json").read_text())
    assert (fields["pinch"] is None) == (plan.pinch is None)


def test_command_says_how_the_bar_is_held(task, capsys):
    path = task(options={"stability": {"moves": 2000, "penetration": 0.001} | LIGHT})
    assert main(["plan", path, "-o", "plan.json"]) == 0
    shown = capsys.readouterr().out
    plan = graspless.load_plan("plan.json")
    assert ("pinched: friction 0.5 holds it" in shown) == (plan.pinch is not None)
    assert main(["check", "plan.json"]) == 0


def test_a_pinch_that_is_too_weak_for_the_load_is_refused_with_both(task, capsys):
    budget = {"seconds": 60, "iterations": 10, "seed": 1}
    load = {"force": 20, "torque": 0.1}
    assert main(["plan", task(options={"stability": load}, budget=budget), "-o", "plan.json"]) == 1
    shown = capsys.readouterr().out
    assert "not_secure" in shown
    assert "pinched with 12.5" in shown
    assert "friction resists 0.0" in shown


def test_check_refuses_a_plan_whose_load_has_grown(plan, tmp_path):
    plan.save("plan.json")
    fields = json.loads((tmp_path / "plan.json").read_text())
    fields["task"]["options"]["stability"] |= {"force": 20, "torque": 0.1}
    (tmp_path / "heavy.json").write_text(json.dumps(fields))
    assert main(["check", "heavy.json"]) == 1


def test_a_weight_beyond_the_tests_is_refused(task):
    ball = {"points": ring(0.02).tolist(), "mass": 150}
    with (
        pytest.warns(UserWarning, match="no SRDF"),
        pytest.raises(graspless.TaskError, match=r"object.mass: 150.*: a hand of two .* 100 kg"),
    ):
        graspless.load_task(task(object=ball, options={}))


def test_the_load_is_the_weight_of_the_object(task):
    ball = {"points": ring(0.02).tolist(), "mass": 3.0}
    with pytest.warns(UserWarning, match="no SRDF"):
        loaded = graspless.load_task(task(object=ball, options={}))
    with pytest.warns(UserWarning, match="no SRDF"):
        given = graspless.load_task(task(object=ball))
    assert loaded.options.stability.force == pytest.approx(29.43)
    assert loaded.options.stability.torque == clasp.StabilityOptions().torque
    assert given.options.stability.force == LIGHT["force"]


def test_a_hand_without_effort_limits_is_refused(task, tmp_path, capsys):
    path = task()
    urdf = tmp_path / "mine.urdf"
    urdf.write_text(urdf.read_text().replace('effort="50"', 'effort="0"'))
    assert main(["plan", path, "-o", "plan.json"]) == 2
    shown = capsys.readouterr().err.strip().splitlines()[-1]
    assert "'slide_left' of the hand has no effort limit" in shown


def test_a_handle_that_is_too_thick_is_refused_with_both_lengths(task, capsys):
    assert main(["plan", task(thickness=0.075), "-o", "plan.json"]) == 1
    shown = capsys.readouterr().out
    assert "too_thick" in shown
    assert " mm thick, the hand opens 60 mm" in shown


def test_a_failure_tells_what_the_arm_reaches(task, capsys):
    budget = {"seconds": 60, "iterations": 2, "seed": 1}
    assert main(["plan", task(options={"friction": 0}, budget=budget), "-o", "plan.json"]) == 1
    assert "of 96 palm poses around the loops" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"thumb": [{"link": "right"}, {"link": "wing"}]}, "wing"),
        ({"frame": "tail"}, "tail"),
        ({"thumb": [{"link": "right"}]}, "thumb"),
    ],
)
def test_refusals(task, capsys, change, message):
    assert main(["plan", task(hand=HAND | change), "-o", "plan.json"]) == 2
    shown = capsys.readouterr().err.strip().splitlines()[-1]
    assert message in shown
    assert "hand" in shown


def test_friction_is_an_option(task, capsys):
    assert main(["plan", task(options={"friction": -1}), "-o", "plan.json"]) == 2
    assert "options.friction" in capsys.readouterr().err


def test_another_pre_shape_clasps_what_is_too_thick_for_the_first(task, tmp_path):
    arm = "".join(f'<joint name="joint_{k}"/>' for k in range(6))
    home = arm.replace("/>", ' value="0"/>')
    states = "".join(
        f'<group_state name="{name}" group="hand"><joint name="slide_left" value="{value}"/>'
        "</group_state>"
        for name, value in (("open", 0.03), ("ajar", 0.005), ("closed", 0.0))
    )
    (tmp_path / "mine.srdf").write_text(
        f'<robot name="gripper"><group name="arm">{arm}</group>'
        f'<group name="hand"><joint name="slide_left"/></group>{states}'
        f'<group_state name="home" group="arm">{home}</group_state></robot>'
    )
    robot = {"urdf": "mine.urdf", "srdf": "mine.srdf"}
    alone = graspless.plan(task(robot=robot, hand=HAND | {"open": "ajar"}))
    assert str(alone.status) == "too_thick"
    assert "the hand opens 10 mm" in alone.reason
    both = graspless.plan(task(robot=robot, hand=HAND | {"open": ["ajar", "open"]}))
    assert both, both.reason
    assert both.pre_shape == "open"
    assert graspless.check(both) == []
