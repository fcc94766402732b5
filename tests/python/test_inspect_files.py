# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What inspect takes from a given SRDF and URDF, and what it adds."""

import numpy as np
import pytest
from matplotlib.text import Text

import inspect_common as small
from graspless import cli, robot


def inspected(urdf, srdf="", **options):
    return robot.inspect(robot.Robot.from_urdf(urdf, srdf=srdf), **options)


def group(name, joints):
    return f'<group name="{name}">' + "".join(f'<joint name="{j}"/>' for j in joints) + "</group>"


def state(name, of, values):
    inner = "".join(f'<joint name="{joint}" value="{v}"/>' for joint, v in values.items())
    return f'<group_state name="{name}" group="{of}">{inner}</group_state>'


def names(made, of):
    return [made.joint_names[column] for column in made.group(of)]


def test_the_names_of_another_arm_are_not_taken():
    two = small.robot(
        "two", small.base(), small.arm("a_"), small.arm("b_"),
        small.prismatic("a_", "a_wrist"), small.prismatic("b_", "b_wrist"),
    )  # fmt: skip
    joints = [f"a_joint_{i}" for i in range(6)]
    srdf = small.robot(
        "two",
        group("arm", joints), group("hand", ["a_slide_left"]),
        state("open", "hand", {"a_slide_left": 0.01}), state("home", "arm", {"a_joint_0": 0.4}),
    )  # fmt: skip
    found = inspected(two, srdf, palm="b_palm")
    made = found.robot
    assert names(made, found.hand["arm"]) == [f"b_joint_{i}" for i in range(6)]
    assert names(made, found.clasp["hand"]) == ["b_slide_left"]
    assert names(made, "arm") == joints
    opened, former, home = (made.state(name) for name in (found.hand["open"], "open", "home"))
    assert opened[made.joint("b_slide_left")] == pytest.approx(0.03)
    assert opened[made.joint("a_slide_left")] == 0  # the other hand stays
    assert former[made.joint("a_slide_left")] == pytest.approx(0.01)
    assert former[made.joint("b_slide_left")] == 0
    assert home[made.joint("a_joint_0")] == pytest.approx(0.4)
    assert np.abs(home[made.group(found.hand["arm"])]).max() > 0.1
    other = inspected(two, srdf, palm="a_palm")
    assert (other.hand["arm"], other.clasp["hand"]) == ("arm", "hand")


def test_faulty_names_are_taken_names():
    srdf = small.robot(
        "gripper", group("arm", ["none"]), group("x", ["joint_0"]),
        state("open", "x", {"joint_0": 9}), state("home", "x", {"joint_0": 9}),
    )  # fmt: skip
    found = inspected(small.gripper(), srdf)
    assert "arm of 6 joints" in found.summary()
    assert len(found.robot.group(found.hand["arm"])) == 6
    opened = found.robot.state(found.hand["open"])
    assert opened[found.robot.joint("slide_left")] == pytest.approx(0.03)
    titles = [text.get_text() for text in found.plot().findobj(Text)]
    assert found.hand["open"] == "open_2"
    assert any("open_2" in title for title in titles)
    home = next(finding for finding in found.unsure if finding.field == "state home")
    assert home.reason == "that of the SRDF is faulty"


def test_the_title_of_a_picture_names_only_frames_that_are_drawn():
    for hand, title in {
        small.prismatic(): "mine: F left_fingertip, H grasp; X red, Y green, Z blue",
        small.three_fingers(): "mine",
    }.items():
        found = inspected(small.gripper(hand=hand), name="mine")
        shown = [text.get_text() for text in found.plot().findobj(Text)]
        assert title in shown
        assert [shown.count(letter) for letter in "FH"] == [3 if found.hand else 0] * 2


def test_hands_are_seen_from_the_side_of_the_fingers():
    plain = small.gripper(hand=small.three_fingers())
    mount = '<joint name="mount" type="fixed"><origin xyz="0 0 0.03"'
    assert mount in plain
    turned = plain.replace(mount, f'{mount} rpy="0 0 1.5707963267948966"')
    first, second = (
        inspected(urdf).plot().axes[0].images[0].get_array() for urdf in (plain, turned)
    )
    assert np.abs(first - second).mean() < 1e-3  # but for pixels on edges


def test_an_srdf_without_elements_is_completed():
    assert inspected(small.gripper(), '<robot name="x"/>').robot.group("arm")


@pytest.mark.parametrize("hand", [small.prismatic(), small.three_fingers()])
def test_frames_are_added_once(hand):
    first = inspected(small.gripper(hand=hand))
    again = inspected(first.urdf)
    assert list(again.robot.frame_names) == list(first.robot.frame_names)
    assert (again.hand, again.clasp) == (first.hand, first.clasp)


def test_frames_elsewhere_are_kept():
    first = inspected(small.gripper())
    moved = first.urdf.replace('<origin xyz="0 0 0.12"', '<origin xyz="0 0 0.1"')
    assert moved != first.urdf
    found = inspected(moved)
    assert found.hand["grasp_frame"] == "grasp_2"
    assert found.hand["fingertip"] == first.hand["fingertip"]


def test_the_users_own_file_is_not_replaced(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    mine = tmp_path / "mine.urdf"
    mine.write_text(small.gripper())
    assert cli.main(["robot", "inspect", "mine.urdf", "-o", "."]) == 2
    assert "--output: .: would replace mine.urdf; choose another folder" in capsys.readouterr().err
    assert mine.read_text() == small.gripper()
    assert [path.name for path in tmp_path.iterdir()] == ["mine.urdf"]
    (tmp_path / "p.csv").write_text("")
    assert cli.main(["robot", "inspect", "mine.urdf", "-o", "p.csv"]) == 2
    assert "p.csv: cannot be written: is a file, not a folder" in capsys.readouterr().err


def test_visual_meshes_of_unknown_packages_keep_their_names():
    visual = '<visual><geometry><mesh filename="package://nowhere/a.dae"/></geometry></visual>'
    urdf = small.gripper().replace('<link name="left">', f'<link name="left">{visual}')
    found = inspected(urdf)
    assert '<mesh filename="package://nowhere/a.dae"/>' in found.files()[f"{found.name}.urdf"]


@pytest.mark.parametrize("name", ["../panda", "..", "ur/ur5e"])
def test_a_name_leads_to_no_other_folder(tmp_path, name):
    found = inspected(small.gripper().replace('name="gripper"', f'name="{name}"', 1))
    assert found.name == name
    written = found.write(tmp_path / "out")
    assert len(written) > 2
    assert {path.parent for path in written} == {tmp_path / "out"}
    assert sorted(written) == sorted((tmp_path / "out").iterdir())
