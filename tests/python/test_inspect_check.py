# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Faults of descriptions: none in what inspect proposes, and those that hide behind others."""

import re

import pytest
import trimesh

import inspect_common as small
from graspless import cli, robot, scene
from graspless.inspection.check import clasp_faults, faults
from graspless.tasks.clasp.hand import Hand as ClaspHand
from graspless.tasks.clasp.hand import build_hand as build_clasp_hand
from graspless.tasks.slide.build import build_hand
from graspless.tasks.slide.model import Hand
from graspless.tasks.source import Source

# Two knobs that touch only where the last three joints of the arm are near 0.
KNOB = '<collision><origin xyz="{}"/><geometry><box size="{}"/></geometry></collision></link>'


def with_knobs(urdf):
    for name, xyz, size in (
        ("link_2", "0.045 0 0.42", "0.02 0.02 0.3"),
        ("wrist", "0.045 0 0.02", "0.04 0.02 0.02"),
    ):
        before, start, after = urdf.partition(f'<link name="{name}">')
        inner, _, rest = after.partition("</link>")
        urdf = before + start + inner + KNOB.format(xyz, size) + rest
    return urdf


def found_in(made, fields):
    hand = build_hand(Hand(**fields), made, Source("test", {}))
    return faults(made, hand, fields.get("pitch"))


def found_in_clasp(made, fields):
    hand = build_clasp_hand(ClaspHand(**fields), made, Source("test", {}), ())
    return clasp_faults(made, hand)


def first_pair(made):
    return scene.Scene(made).collision(made.state("open"))


@pytest.fixture(scope="module")
def knobs():
    return robot.inspect(robot.Robot.from_urdf(with_knobs(small.gripper())))


def test_an_arm_may_touch_itself_at_zero(knobs):
    made = knobs.robot
    assert set(first_pair(made)) == {"link_2", "wrist"}
    assert found_in(made, knobs.hand) == []
    assert found_in_clasp(made, knobs.clasp) == []


def test_touching_fingers_are_found_behind_a_touching_arm(knobs):
    made = robot.Robot.from_urdf(
        knobs.urdf.replace('lower="0"', 'lower="-0.004"'),
        srdf=knobs.srdf.replace(
            '<joint name="slide_left" value="0.03"/>', '<joint name="slide_left" value="-0.004"/>'
        ),
    )
    assert set(first_pair(made)) == {"link_2", "wrist"}
    assert "open: left and right touch" in found_in(made, knobs.hand)
    assert "open: left and right touch" in found_in_clasp(made, knobs.clasp)


def test_a_home_that_cannot_be_used_or_touches_is_told(knobs):
    made, srdf = knobs.robot, knobs.srdf
    joint, value = next(iter(zip(made.joint_names, made.state("home"), strict=True)))
    text = f'<joint name="{joint}" value="{value:.9g}"/>'
    assert text in srdf
    faulty = srdf.replace(text, f'<joint name="{joint}" value="99"/>')
    (fault,) = found_in(robot.Robot.from_urdf(knobs.urdf, srdf=faulty), knobs.hand)
    assert fault.startswith("home: state 'home' cannot be used: ")
    assert f"joint '{joint}': 99 is outside its limits" in fault
    assert fault.endswith("set robot.home in tasks, or mend or remove this state")
    zeros = re.sub(r'value="[^"]*"', 'value="0"', srdf.split('name="home" group="arm"')[1])
    touching = srdf.split('name="home" group="arm"')[0] + 'name="home" group="arm"' + zeros
    given = robot.Robot.from_urdf(knobs.urdf, srdf=touching)
    (fault,) = found_in(given, knobs.hand)
    assert fault == "home: link_2 and wrist touch"
    rows = {finding.field: finding for finding in robot.inspect(given).findings}
    assert rows["state home"].reason == "link_2 and wrist touch there"
    assert not rows["state home"].is_sure


def test_what_the_planner_refuses_is_told():
    """A knuckle that is lower than the fingertip at 45 degrees, where the proposal is steeper."""
    knuckle = small.box("knuckle", "0 0 0", "0.01 0.03 0.004")
    knuckle += small.joint("bump", "fixed", "left", "knuckle", "0 0.035 0.058")
    hand = small.prismatic() + knuckle
    found = robot.inspect(robot.Robot.from_urdf(small.gripper(hand=hand)))
    assert found_in(found.robot, found.hand) == []
    flat = {field: value for field, value in found.hand.items() if field != "pitch"}
    (fault,) = found_in(found.robot, flat)
    assert fault.startswith("fingertip 'left_fingertip': at pitch ")
    assert "the sliding finger is 18 mm below the contact" in fault


def test_check_of_a_bare_arm_says_how_it_gets_a_hand(tmp_path, capsys):
    (tmp_path / "arm.urdf").write_text(small.robot("arm", small.base(), small.arm()))
    assert cli.main(["robot", "check", str(tmp_path / "arm.urdf")]) == 2
    said = capsys.readouterr().err
    assert "no joint moves a finger" in said
    assert "`graspless robot join ARM GRIPPER --mount LINK` adds a gripper" in said


@pytest.mark.parametrize(
    ("shape", "more"),
    [
        ('<mesh filename="part.stl"/>', ': a mesh in millimetres needs scale="0.001 0.001 0.001"'),
        ('<box size="24 46 23"/>', ""),
        ('<mesh filename="part.stl" scale="0.001 0.001 0.001"/>', None),
    ],
)
def test_links_in_millimetres_are_told(tmp_path, capsys, shape, more):
    trimesh.creation.box((24, 46, 23)).export(tmp_path / "part.stl")
    arm = small.base() + small.arm() + small.link("tool", shape=shape)
    arm += small.joint("flange", "fixed", "wrist", "tool")
    (tmp_path / "arm.urdf").write_text(small.robot("arm", arm))
    assert cli.main(["robot", "check", str(tmp_path / "arm.urdf")]) == 2
    told = "link 'tool' has a collision shape of 24 x 46 x 23 m; lengths are in metres"
    said = capsys.readouterr().err
    assert (f"{told}{more}\n" in said) if more is not None else told not in said


def test_a_finger_without_shapes_is_named():
    found = robot.inspect(robot.Robot.from_urdf(small.gripper()))
    bare = found.urdf.replace(
        small.box("left", "0 0.005 0.04", "0.02 0.01 0.08"), small.link("left")
    )
    assert bare != found.urdf
    made = robot.Robot.from_urdf(bare, srdf=found.srdf)
    assert found_in(made, found.hand) == ["sliding_finger: no link of it has a collision shape"]
