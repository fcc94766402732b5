# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Search for the palm: what is no hand, and what may be one."""

import re

import numpy as np
import pytest

import inspect_common as small
from graspless import robot
from graspless.inspection.linkage import without_linkage
from graspless.inspection.palm import find_palm
from graspless.inspection.tree import Tree


def read(urdf, **options):
    return robot.Robot.from_urdf(urdf, **options)


def finding(found, field):
    return next(finding for finding in found.findings if finding.field == field)


def with_head():
    """A torso on a lift, with a head and an arm that has no hand."""
    return small.robot(
        "mobile",
        small.base(),
        small.box("torso", "0 0 0.2", "0.2 0.2 0.4"),
        small.joint("lift", "prismatic", "base", "torso", "0 0 0.1", limits=(0, 0.3)),
        small.arm("a_", "torso"),
        small.box("head", "0 0 0.05", "0.1 0.1 0.1"),
        small.joint("neck", "revolute", "torso", "head", "0.1 0 0.5"),
    )


def test_an_arm_is_no_finger():
    message = (
        "torso carries a_wrist by 6 joints, more than the 5 of a finger.*robot join ARM GRIPPER"
    )
    with pytest.raises(ValueError, match=message):
        robot.inspect(read(with_head()))


def test_a_hand_by_its_name_has_fingers_of_many_joints():
    hand = small.palm() + "".join(
        small.arm(prefix, "palm").replace("0 0 0.1", f"0 {y} 0.1", 1)
        for prefix, y in (("left_", 0.1), ("right_", -0.1))
    )
    tree = Tree(read(small.gripper(hand=hand)))
    assert [finger.name(tree) for finger in find_palm(tree).fingers] == [
        "left_wrist",
        "right_wrist",
    ]


def test_a_part_of_the_palm_that_another_finger_moves_is_no_palm():
    found = robot.inspect(read(small.gripper(hand=small.split_palm("opposed_near_joint"))))
    made = found.robot
    names = [made.joint_names[column] for column in made.group("arm")]
    assert names == [f"joint_{i}" for i in range(6)]
    assert list(found.clasp["fingers"]) == ["index_near", "middle_near", "ring", "little"]
    assert len(made.group("hand")) == 8


def test_a_short_chain_behind_a_long_one_is_asked_about():
    made = read(small.gripper(hand=small.split_palm()))
    with pytest.raises(ValueError, match="2 links may be the palm of a hand: palm, part; choose"):
        robot.inspect(made)
    found = robot.inspect(made, palm="palm")
    assert len(found.robot.group("arm")) == 6
    assert len(found.robot.group("hand")) == 9  # with the joint of the part


def test_a_thumb_behind_the_origin_of_the_palm_is_no_bar():
    """As in a LEAP hand, whose palm has its origin between the fingers and the thumb."""
    hand = small.palm()
    places = ["-0.03 0 0.05", "0 0 0.05", "0.03 0 0.05", "0 -0.05 -0.14"]
    for i, at in enumerate(places):
        hand += small.box(f"finger_{i}", "0 0 0.045", "0.02 0.01 0.09")
        hand += small.joint(f"bend_{i}", "revolute", "palm", f"finger_{i}", at, "1 0 0")
    tree = Tree(read(small.gripper(hand=hand)))
    assert len(without_linkage(tree, find_palm(tree)).fingers) == 4


def test_mounts_without_fingers_are_named():
    hand = small.prismatic()
    for side in ("left", "right"):
        hand = re.sub(rf'<link name="{side}">.*?</link>', f'<link name="{side}"/>', hand)
    with pytest.raises(ValueError, match="left and right move, but have no shape; add the fingers"):
        robot.inspect(read(small.gripper(hand=hand)))


@pytest.mark.parametrize(
    ("palm", "left", "is_sure"),
    [("palm", "left", True), ("body", "left", False), ("body", "left_finger", True)],
)
def test_a_hand_without_a_name_is_doubtful(palm, left, is_sure):
    hand = small.prismatic().replace('"palm"', f'"{palm}"').replace('"left"', f'"{left}"')
    found = robot.inspect(read(small.gripper(hand=hand)))
    assert finding(found, "palm").is_sure == is_sure


def test_axes_do_not_depend_on_where_the_hand_is_mounted():
    straight, aside = (
        robot.inspect(read(small.gripper(hand=hand)))
        for hand in (
            small.prismatic(),
            small.prismatic().replace("0 0 0.03", "0.1 0 0.03", 1),
        )
    )
    X_PH, X_PH_aside = (
        np.linalg.inv(found.robot.pose("palm", q)) @ found.robot.pose("grasp", q)
        for found in (straight, aside)
        for q in [found.robot.state("open")]
    )
    np.testing.assert_allclose(X_PH_aside, X_PH, atol=1e-6)


def test_rounding_errors_of_a_home_are_shown_as_0():
    shown = finding(robot.inspect(read(small.gripper())), "state home").value.split(", ")
    assert (shown[0], shown[3]) == ("0", "0")


def test_a_joint_without_a_range_leaves_a_home():
    urdf = small.gripper().replace(
        '<child link="link_0"/><axis xyz="0 0 1"/><limit lower="-2.9" upper="2.9"',
        '<child link="link_0"/><axis xyz="0 0 1"/><limit lower="0" upper="0"',
    )
    made = read(urdf)
    assert made.lower[0] == made.upper[0]
    with np.errstate(invalid="raise", divide="raise"):
        found = robot.inspect(made)
    assert finding(found, "state home").is_sure


def test_joints_may_be_in_front_of_the_tips():
    """Fingers that hang on rails at their far ends."""
    hand = small.palm() + "".join(
        small.box(side, f"0 {0.005 * sign} -0.06", "0.02 0.01 0.08")
        + small.joint(
            f"slide_{side}", "prismatic", "palm", side, "0 0 0.15", f"0 {sign} 0", (0, 0.03)
        )
        for side, sign in (("left", 1), ("right", -1))
    )
    found = robot.inspect(read(small.gripper(hand=hand)))
    assert found.robot.state("open")[-2:] == pytest.approx([0.03, 0.03])


@pytest.mark.parametrize(
    ("size", "field", "value"),
    [("0.02 0.0004 0.08", "tip_radius", "0.5 mm"), ("0.4 0.01 0.08", "pad_width", "200.0 mm")],
)
def test_sizes_at_their_limits_are_doubtful(size, field, value):
    hand = small.prismatic().replace("0.02 0.01 0.08", size)
    limited = finding(robot.inspect(read(small.gripper(hand=hand))), field)
    assert (limited.value, limited.is_sure) == (value, False)
    assert "limited to 0.5 mm and" in limited.reason


def test_the_finger_called_left_slides():
    for prefix in ("", "left_", "my_"):
        hand = robot.inspect(read(small.gripper(hand=small.prismatic(prefix)))).hand
        assert hand["sliding_finger"] == [f"{prefix}left"]


def test_a_pitch_without_room_says_so():
    wide = small.prismatic().replace("0.04 0.1 0.04", "0.04 0.9 0.04", 1)
    pitch = finding(robot.inspect(read(small.gripper(hand=wide))), "pitch")
    assert not pitch.is_sure
    assert pitch.reason.startswith(
        "at no pitch of the finger is the rest of the hand 10.0 mm above"
    )


def test_states_of_another_hand_are_not_used():
    sides = ("left_", "right_")
    urdf = small.robot(
        "two", small.base(),
        *(small.arm(side) + small.prismatic(side, f"{side}wrist") for side in sides),
    )  # fmt: skip
    first = robot.inspect(read(urdf), palm="left_palm")
    for _ in range(2):  # the states of the second hand are found again
        second = robot.inspect(read(first.urdf, srdf=first.srdf), palm="right_palm")
        assert (second.hand["open"], second.hand["closed"]) == ("open_2", "closed_2")
        made, q = second.robot, np.full(second.robot.dof, 0.01)
        for field in ("open", "closed"):
            moved = np.flatnonzero(made.state(second.hand[field], q) != q)
            assert [made.joint_names[i] for i in moved] == ["right_slide_left"]
        first = second


def test_frames_and_rods_beside_an_arm_do_not_cut_it():
    rod = small.box("rod", "0.05 0 0.1", "0.01 0.01 0.2")
    rod += small.joint("rod_joint", "revolute", "link_1", "rod", axis="0 1 0", mimic="joint_2")
    rod += small.link("marker") + small.joint("marker_joint", "revolute", "link_2", "marker")
    found = robot.inspect(
        read(small.robot("mine", small.base(), small.arm(), small.prismatic(), rod))
    )
    assert [found.robot.joint_names[i] for i in found.robot.group("arm")] == [
        f"joint_{i}" for i in range(6)
    ]
