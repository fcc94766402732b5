# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Proposals in tasks: what is given, what is proposed, and what the note says of it."""

import warnings

import numpy as np
import pytest
import yaml

import graspless
import inspect_common as small
from graspless import TaskError, load_task, report, robot
from tasks_common import run

CARD = """
kind: slide
robot:   {urdf: mine.urdf}
object:  {rectangle: {size: [0.1, 0.06]}, thickness: 0.003, pose: {x: 0.42, y: 0.05, yaw: 0.3}}
support: {rectangle: {center: [0.45, 0.0], size: [0.4, 0.5]}}
"""


@pytest.fixture(scope="module")
def found():
    return robot.inspect(robot.Robot.from_urdf(small.gripper()), name="mine")


@pytest.fixture
def folder(tmp_path, found):
    found.write(tmp_path)
    (tmp_path / "card.yaml").write_text(CARD)
    return tmp_path


def loaded(folder):
    """Returns the task, and the notes of what was proposed."""
    with warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        task = load_task(folder / "card.yaml")
    return task, [str(note.message) for note in notes]


def test_a_pitch_in_the_task_replaces_that_of_the_file(folder):
    (folder / "card.yaml").write_text(CARD + "hand: {pitch: 1.1, pad_width: 0.011}\n")
    task, _ = loaded(folder)
    assert (task.options.pitch, task.problem.hand.pad_width) == (1.1, 0.011)


def test_friction_and_force_are_proposed_and_doubtful(found):
    unsure = {finding.field for finding in found.unsure}
    assert {"pad_friction", "press_force"} <= unsure & set(found.hand)


@pytest.mark.parametrize("field", ["flexure_length", "flexure_stiffness"])
def test_a_flexure_has_no_default(folder, field):
    hand = {"finger_model": "flexure", "flexure_length": 0.1, "flexure_stiffness": 4.0}
    (folder / "card.yaml").write_text(CARD + yaml.safe_dump({"hand": hand}))
    assert loaded(folder)[0].problem.hand.flexure_length == 0.1
    del hand[field]
    (folder / "card.yaml").write_text(CARD + yaml.safe_dump({"hand": hand}))
    with pytest.raises(TaskError, match=rf"hand\.{field}: must be given with finger_model flexure"):
        loaded(folder)


def test_the_note_says_what_is_used(folder):
    (folder / "mine.srdf").unlink()
    hand = yaml.safe_load((folder / "mine.hand.yaml").read_text())
    hand |= {"finger_model": "impedance", "wrist_stiffness": 900.0}
    (folder / "mine.hand.yaml").write_text(yaml.safe_dump(hand))
    task, (note,) = loaded(folder)
    assert task.problem.hand.wrist_stiffness == 900
    assert "no SRDF: proposed arm of 6 joints; fingertip left_fingertip; open slide_left" in note
    assert "finger_model" not in note


CHAIN = """
kind: chain
robot: {urdf: mine.urdf}
object:
  name: card
  rectangle: {size: [0.1, 0.06]}
  thickness: 0.003
  pose: {x: 0.42, y: 0.05, yaw: 0.3}
support: {rectangle: {center: [0.45, 0.0], size: [0.4, 0.5]}}
stages:
  - {name: to the edge, kind: slide}
"""


@pytest.mark.parametrize("text", [CARD, CHAIN])
def test_the_note_is_printed_once(folder, capsys, monkeypatch, text):
    """The plan file keeps it."""
    monkeypatch.chdir(folder)
    (folder / "mine.srdf").unlink()
    (folder / "card.yaml").write_text(text)
    code, out, err = run(capsys, "plan", "card.yaml", "--seed", "1")
    assert code == 0, out
    note = "no SRDF: proposed arm of 6 joints"
    assert (out.count(note), err.count(note)) == (0, 1)
    written = graspless.load_plan("plan.json")
    (stage,) = getattr(written, "stages", [written])
    assert stage.warnings[0].startswith(note)
    told = report.as_text(written, stage.warnings[:1])
    assert (report.as_text(written).count(note), told.count(note)) == (1, 0)
    assert set(told.splitlines()) < set(report.as_text(written).splitlines())


def test_a_clasp_is_told_of_its_own_hand(found):
    assert "palm palm; curves of left against right; graspless" in found.summary("clasp")
    assert "fingertip" not in found.summary("clasp")


def test_a_hand_file_needs_no_proposal_of_a_hand(folder):
    """Three fingers have no proposal for a slide, but two of them may press."""
    proposal = robot.inspect(
        robot.Robot.from_urdf(small.gripper(hand=small.three_fingers())), name="mine"
    )
    (folder / "mine.urdf").write_text(proposal.urdf)
    (folder / "mine.srdf").unlink()
    hand = yaml.safe_load((folder / "mine.hand.yaml").read_text())
    hand |= {"sliding_finger": ["opposed_far"], "fingers": ["opposed_far", "index_far"]}
    (folder / "mine.hand.yaml").write_text(yaml.safe_dump(hand | {"fingertip": "none"}))
    with pytest.raises(TaskError, match="fingertip: none: "):
        loaded(folder)


@pytest.fixture
def parts(tmp_path):
    """An arm and a gripper in files of their own, and the gripper's hand."""
    (tmp_path / "arm.urdf").write_text(small.robot("arm", small.base(), small.arm()))
    grip = small.robot("grip", small.link("grip_base"), small.prismatic(parent="grip_base"))
    (tmp_path / "grip.urdf").write_text(grip)
    hand = {"finger_model": "rigid_guarded", "fingertip": "left_fingertip", "tip_radius": 0.004}
    (tmp_path / "grip.hand.yaml").write_text(yaml.safe_dump(hand))
    return tmp_path


@pytest.mark.parametrize(
    ("prefix", "clash", "fingertip", "radius"),
    [
        ("", False, "left_fingertip", 0.004),
        ("my_", False, "my_left_fingertip", 0.005),
        ("", True, "gripper_left_fingertip", 0.005),
    ],
)
def test_the_file_of_a_gripper_is_for_its_own_names(parts, prefix, clash, fingertip, radius):
    if clash:
        arm = parts / "arm.urdf"
        more = small.link("left") + small.joint("mark", "fixed", "base", "left")
        arm.write_text(arm.read_text().replace("</robot>", more + "</robot>"))
    given = {
        "arm": "arm.urdf",
        "gripper": {"file": "grip.urdf", "mount": "wrist", "prefix": prefix},
    }
    card = yaml.safe_load(CARD) | {"robot": given}
    (parts / "card.yaml").write_text(yaml.safe_dump(card))
    hand = loaded(parts)[0].problem.hand
    assert (hand.fingertip, hand.tip_radius) == (fingertip, pytest.approx(radius))


def test_elements_with_prefixes_are_read(folder):
    more = '<gazebo><controller:force name="x"/></gazebo></robot>'
    for name in ("mine.urdf", "mine.srdf"):
        path = folder / name
        path.write_text(path.read_text().replace("</robot>", more))
    task, notes = loaded(folder)
    assert notes == []
    plan = graspless.plan(task)
    assert plan
    assert graspless.time(plan, max_velocity={"joint_0": 0.5}).duration > 0
    again = robot.inspect(task.problem.robot)
    np.testing.assert_allclose(again.robot.upper, task.problem.robot.upper)
