# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""graspless.robot.inspect: laws of what it proposes, and robots whose description is known."""

import json
import warnings

import numpy as np
import pytest
import yaml
from PIL import Image

import inspect_common as small
from graspless import cli, geometry, load_task, plan, robot, scene
from graspless.inspection.check import clasp_faults, faults
from graspless.tasks.clasp.hand import Hand as ClaspHand
from graspless.tasks.clasp.hand import build_hand as build_clasp_hand
from graspless.tasks.slide.build import build_hand
from graspless.tasks.slide.model import Hand
from graspless.tasks.source import Source

HANDS = {
    "prismatic": small.prismatic(),
    "independent": small.prismatic(mimic=False),
    "revolute": small.revolute(),
    "one_jaw": small.one_jaw(),
    "linkage": small.linkage(),
}


def read(urdf, **options):
    return robot.Robot.from_urdf(urdf, **options)


@pytest.fixture(scope="module", params=HANDS)
def found(request):
    return robot.inspect(read(small.gripper(request.param, HANDS[request.param])))


def frame(proposal, field, state="open"):
    made = proposal.robot
    return np.asarray(made.pose(proposal.hand[field], made.state(state)))


def corners(made, links, q):
    points = []
    for index, placed in made.shapes:
        if made.frame_names[index] in links:
            size = np.asarray(placed.shape.size)
            signs = np.array(np.meshgrid(*[[-0.5, 0.5]] * 3)).reshape(3, -1)
            X = np.asarray(made.pose(index, q)) @ np.asarray(placed.X_BG)
            points.append((X[:3, :3] @ (size[:, None] * signs)).T + X[:3, 3])
    return np.vstack(points)


def ends(made, links, out):
    """Corners of the open fingers that are farthest out of the hand, within 1 mm."""
    points = corners(made, links, made.state("open"))
    return points[points @ out > (points @ out).max() - 1e-3]


def test_arm_and_hand_are_split(found):
    made = found.robot
    assert [made.joint_names[i] for i in made.group("arm")] == [f"joint_{i}" for i in range(6)]
    assert not set(made.group("arm")) & set(made.group("hand"))
    assert len(made.group("arm")) + len(made.group("hand")) == made.dof


def test_fingertip_is_on_the_surface_and_its_axes_are_right(found):
    made, hand = found.robot, found.hand
    q = made.state("open")
    X_WF = frame(found, "fingertip")
    own = corners(made, hand["sliding_finger"], q)
    other = corners(
        made, [link for link in hand["fingers"] if link not in hand["sliding_finger"]], q
    )
    seen = (own - X_WF[:3, 3]) @ X_WF[:3, :3]
    assert -1e-6 < seen[:, 2].max() < 0.0025  # at the end of the finger
    assert seen[seen[:, 2] > -1e-3, 1].min() == pytest.approx(0, abs=1e-6)  # at its outer edge
    pitch = hand.get("pitch", np.pi / 4)
    down = np.array([0, -np.cos(pitch), np.sin(pitch)])
    assert -1e-6 < (seen @ down).max() < 0.003  # where it touches a surface first
    assert (other.mean(axis=0) - X_WF[:3, 3]) @ X_WF[:3, 1] > 0  # Y towards the other finger
    np.testing.assert_allclose(X_WF[:3, :3].T @ X_WF[:3, :3], np.eye(3), atol=1e-9)


def test_grasp_is_between_the_tips(found):
    X_WF, X_WH = frame(found, "fingertip"), frame(found, "grasp_frame")
    assert X_WF[:3, 2] @ X_WH[:3, 2] == pytest.approx(1)
    assert abs(X_WF[:3, 1] @ X_WH[:3, 1]) == pytest.approx(1)
    made, hand, Y = found.robot, found.hand, X_WF[:3, 1]
    others = [link for link in hand["fingers"] if link not in hand["sliding_finger"]]
    own, other = (ends(made, links, X_WH[:3, 2]) @ Y for links in (hand["sliding_finger"], others))
    middle = (own.min() + own.max() + other.min() + other.max()) / 4
    if hand["sliding_finger"] == ["fixed_jaw"]:
        middle = own.max() + 0.006  # the object does not move while the other jaw closes
    assert X_WH[:3, 3] @ Y == pytest.approx(middle, abs=1e-4)


def test_hand_opens_and_closes(found):
    made, hand = found.robot, found.hand
    others = [link for link in hand["fingers"] if link not in hand["sliding_finger"]]

    def gap(state):
        Y = frame(found, "fingertip", "open")[:3, 1]
        q = made.state(state)
        own, other = (corners(made, links, q) @ Y for links in (hand["sliding_finger"], others))
        return other.max() - own.min()

    assert gap("open") > gap("closed") + 0.02
    assert scene.Scene(made).collision(made.state("open")) is None


def test_home_is_free_away_from_limits_and_points_down(found):
    made = found.robot
    q = made.state("home")
    arm = made.group("arm")
    assert scene.Scene(made).is_free(q)
    span = made.upper[arm] - made.lower[arm]
    assert (np.minimum(q[arm] - made.lower[arm], made.upper[arm] - q[arm]) > 0.04 * span).all()
    assert frame(found, "grasp_frame", "home")[2, 2] == pytest.approx(-1, abs=1e-6)
    np.testing.assert_allclose(q[made.group("hand")], made.state("open")[made.group("hand")])


def test_home_has_the_elbow_up_even_if_down_is_farther_from_the_limits():
    """A table would be where the elbow is down, and a slide would find no start."""
    urdf = small.gripper().replace('lower="-2.9" upper="2.9"', 'lower="-6.2" upper="6.2"')
    for i, axis, (lower, upper) in ((0, "0 0 1", (-1, 1)), (2, "0 1 0", (-6.2, 2))):
        start = f'<child link="link_{i}"/><axis xyz="{axis}"/><limit '
        wide, narrow = 'lower="-6.2" upper="6.2"', f'lower="{lower}" upper="{upper}"'
        assert start + wide in urdf
        urdf = urdf.replace(start + wide, start + narrow)
    made = robot.inspect(read(urdf)).robot
    q = made.state("home")
    shoulder, elbow, wrist = (made.pose(f"link_{i}", q)[:3, 3] for i in (1, 2, 3))
    assert elbow[2] > (shoulder[2] + wrist[2]) / 2 + 0.05


def test_nothing_is_wrong_with_a_proposal(found):
    source = Source("test", {})
    hand = build_hand(Hand(**found.hand), found.robot, source)
    assert faults(found.robot, hand, found.hand.get("pitch")) == []
    clasp = build_clasp_hand(ClaspHand(**found.clasp), found.robot, source, ())
    assert clasp_faults(found.robot, clasp) == []


def test_states_of_a_prismatic_gripper():
    found = robot.inspect(read(small.gripper()))
    made, column = found.robot, found.robot.joint("slide_left")
    assert made.state("open")[column] == pytest.approx(0.03)
    assert made.state("closed")[column] == pytest.approx(0.00025, abs=2e-5)
    assert found.hand["pad_width"] == pytest.approx(0.02)
    # F: 35 to 40 mm beside the middle; fingers end 120 mm in front of the palm.
    X_PF = np.asarray(made.pose("left_fingertip", made.state("open")))
    X_PF = np.linalg.inv(made.pose("palm", made.state("open"))) @ X_PF
    np.testing.assert_allclose(X_PF[:3, 3], [0, 0.04, 0.12], atol=1e-6)


def test_bars_of_a_linkage_are_no_fingers():
    found = robot.inspect(read(small.gripper(hand=small.linkage())))
    assert found.hand["sliding_finger"] == ["left_pad"]
    assert found.hand["fingers"] == ["left_pad", "right_pad"]
    palm = next(finding for finding in found.findings if finding.field == "palm")
    assert "left_inner, right_inner are its linkage" in palm.reason
    assert found.robot.state("open")[found.robot.joint("left_outer_joint")] == pytest.approx(0)


@pytest.mark.parametrize("name", ["wam_t42", "kr5_t42"])
def test_our_own_descriptions_are_found_again(name):
    given = robot.Robot.from_urdf_file(str(robot.builtin(name)))
    found = robot.inspect(read(given.urdf))  # without the SRDF
    made, q = found.robot, given.state("open")
    np.testing.assert_allclose(made.state("open")[-1], given.state("open")[-1], atol=1e-6)
    np.testing.assert_allclose(made.state("closed")[-1], given.state("closed")[-1], atol=3e-3)
    assert made.group("arm") == given.group("arm")
    F, H = (np.asarray(made.pose(found.hand[f], q)) for f in ("fingertip", "grasp_frame"))
    np.testing.assert_allclose(
        F[:3, :3], np.asarray(given.pose("left_fingertip", q))[:3, :3], atol=1e-6
    )
    # Ours is at the middle of the tip, the one that is found at its outer edge.
    radius = yaml.safe_load(robot.builtin(name).with_name(f"{name}.hand.yaml").read_text())[
        "tip_radius"
    ]
    outer = np.asarray(given.pose("left_fingertip", q)) @ [0, -radius, 0, 1]
    np.testing.assert_allclose(F[:3, 3], outer[:3], atol=1e-4)
    np.testing.assert_allclose(H, given.pose("grasp", q), atol=1e-6)
    ignored = {
        tuple(sorted((given.frame_names[a], given.frame_names[b]))) for a, b in given.ignored_pairs
    }
    proposed = {
        tuple(sorted((made.frame_names[a], made.frame_names[b]))) for a, b in made.ignored_pairs
    }
    assert ignored <= proposed


def test_sampled_pairs():
    made = read(small.gripper())
    always, never = scene.sample_contacts(made, samples=2000)
    names = made.frame_names
    assert ("base", "wrist") not in {(names[a], names[b]) for a, b in never}
    assert scene.sample_contacts(made, samples=2000) == (always, never)
    with pytest.raises(ValueError, match=r"samples must lie in \[1, 1000000\], not 0"):
        scene.sample_contacts(made, samples=0)


def test_fingers_may_always_meet():
    found = robot.inspect(read(small.gripper("independent", small.prismatic(mimic=False))))
    made = found.robot
    pair = tuple(sorted((made.frame("left"), made.frame("right"))))
    assert pair not in made.ignored_pairs


def test_a_wheel_that_no_group_turns_may_touch_its_rail():
    """As in Interbotix grippers: the wheel turns at the motor, the fingers slide by themselves."""
    wheel = (
        small.box("rail", "0.03 0.03 0.02", "0.02 0.02 0.02")
        + small.joint("rail_mount", "fixed", "palm", "rail")
        + small.box("wheel", "0 0 0.02", "0.06 0.01 0.01")
        + small.joint("motor", "continuous", "palm", "wheel", "0.03 0 0")
    )
    made = robot.inspect(read(small.gripper(hand=small.prismatic() + wheel))).robot
    pair = tuple(sorted((made.frame("rail"), made.frame("wheel"))))
    assert pair in made.ignored_pairs


def test_three_fingers_close_against_a_thumb():
    found = robot.inspect(read(small.gripper(hand=small.three_fingers())))
    assert found.hand == {}  # a slide needs two fingers
    assert list(found.clasp["fingers"]) == ["index_near", "middle_near"]
    assert found.clasp["thumb"][0]["link"] == "palm"
    np.testing.assert_allclose(found.clasp["forward"], [0, 0, 1], atol=0.1)
    np.testing.assert_allclose(np.abs(found.clasp["sideways"]), [1, 0, 0], atol=1e-6)
    made = found.robot
    hand = made.group("hand")
    assert (made.state("open")[hand] < 0.2).all()
    assert (made.state("closed")[hand] > 1.2).all()
    build_clasp_hand(ClaspHand(**found.clasp), made, Source("test", {}), ())
    values = {finding.field: finding for finding in found.findings}
    assert values["state open"].value.startswith("index_near_joint -0.02, index_far_joint 0.16, ")
    assert not values["grip force"].is_sure  # 50 Nm at 5 cm
    assert "few grippers are as strong" in values["grip force"].reason


@pytest.mark.parametrize("name", ["kr5_sdh", "kr5_dlr", "kr5_icub", "kr5_armar"])
def test_our_own_hands_are_found_again(name):
    path = robot.builtin(name)
    found = robot.inspect(read(path.read_text()))
    given = yaml.safe_load(path.with_name(f"{name}.clasp.yaml").read_text())
    for field, most in (("forward", 5), ("sideways", 5)):
        a, b = (np.array(fields[field]) for fields in (given, found.clasp))
        cosine = a @ b / np.linalg.norm(a) / np.linalg.norm(b)
        cosine = abs(cosine) if field == "sideways" else cosine
        assert np.degrees(np.arccos(min(cosine, 1))) < most, field
    assert found.clasp["frame"] == given["frame"]
    assert len(found.clasp["fingers"]) == len(given["fingers"])
    assert all("thumb" in node["link"] for node in found.clasp["thumb"][1:])


def test_two_fingers_have_a_curve(found):
    hand = build_clasp_hand(ClaspHand(**found.clasp), found.robot, Source("test", {}), ())
    assert len(hand.fingers) == 1
    assert hand.forward_H[2] == pytest.approx(1)


def test_clasp_with_a_proposed_hand(tmp_path):
    (tmp_path / "mine.urdf").write_text(robot.builtin("kr5_armar").read_text())
    (tmp_path / "task.yaml").write_text(
        "kind: clasp\nrobot: {urdf: mine.urdf}\n"
        "object: {sample: purse, pose: {position: [0.62, 0.05, 0], rpy: [0, 0, 0.3]}}\n"
    )
    with pytest.warns(UserWarning, match="no SRDF and no description of the hand: proposed"):
        found = plan(tmp_path / "task.yaml", seed=1)
    assert found, found.reason
    assert found.warnings[0].startswith("no SRDF")


def test_two_hands_are_asked_about():
    urdf = small.robot(
        "two", small.base(), small.arm("a_"), small.arm("b_"),
        small.prismatic("a_", "a_wrist"), small.prismatic("b_", "b_wrist"),
    )  # fmt: skip
    with pytest.raises(
        ValueError, match="2 links may be the palm of a hand: a_palm, b_palm; choose"
    ):
        robot.inspect(read(urdf))
    found = robot.inspect(read(urdf), palm="b_palm")
    assert all(found.robot.joint_names[i].startswith("b_") for i in found.robot.group("arm"))
    with pytest.raises(ValueError, match="palm: unknown link 'c_palm'"):
        robot.inspect(read(urdf), palm="c_palm")


def test_a_horn_that_spins_is_no_finger():
    found = robot.inspect(read(small.gripper(hand=small.spinning_horn())))
    assert found.hand["fingers"] == ["left", "right"]
    assert found.robot.group("hand") == [found.robot.joint("slide_left")]


def test_legs_are_no_fingers():
    urdf = small.robot("dog", small.legs(), small.base(), small.arm(), small.one_jaw())
    found = robot.inspect(read(urdf))
    assert found.hand["fingers"] == ["fixed_jaw", "moving_jaw"]
    assert len(found.robot.group("arm")) == 6


def test_a_hand_with_visual_shapes_only_is_named():
    hand = small.one_jaw().replace("collision>", "visual>")
    with pytest.raises(ValueError, match="fixed_jaw and moving_jaw can be seen, but have no coll"):
        robot.inspect(read(small.gripper(hand=hand)))


def test_grasp_is_where_tips_on_arcs_meet():
    """Fingers of 90 mm open by 0.2 rad; they reach farther when they are parallel."""
    found = robot.inspect(read(small.gripper(hand=small.revolute())))
    made = found.robot
    depth = {
        state: (np.linalg.inv(made.pose("palm", q)) @ made.pose("grasp", q))[2, 3]
        for state in ("open", "closed")
        if len(q := made.state(state))
    }
    assert depth["open"] == pytest.approx(depth["closed"])  # H is fixed in the palm
    assert depth["open"] >= 0.04 + 0.09 - 1e-3
    assert depth["open"] <= 0.04 + 0.0975  # with the corner of a finger


def test_finger_with_a_knuckle_is_pitched_until_its_end_touches_first():
    """A knuckle 20 mm behind the end, 40 mm outside of it: at 45 degrees it is lower."""
    knuckle = small.box("knuckle", "0 0 0", "0.01 0.03 0.004")
    knuckle += small.joint("bump", "fixed", "left", "knuckle", "0 0.035 0.058")
    found = robot.inspect(read(small.gripper(hand=small.prismatic() + knuckle)))
    made, q = found.robot, found.robot.state("open")
    X_WF = np.asarray(made.pose(found.hand["fingertip"], q))
    seen = (corners(made, found.hand["sliding_finger"], q) - X_WF[:3, 3]) @ X_WF[:3, :3]
    for pitch in (found.hand["pitch"] - 0.1, found.hand["pitch"] + 0.1):
        down = np.array([0, -np.cos(pitch), np.sin(pitch)])
        assert (seen @ down).max() < 0.005  # the limit of slide.validate()


def test_home_of_an_arm_on_a_torso_is_below_it():
    """With elbow and shoulder stretched forwards, the hand points down below the base only."""
    urdf = small.gripper().replace(
        '<origin xyz="0 0 0.1"/>', '<origin xyz="0 0 0.1" rpy="3.14159265 0 0"/>'
    )
    found = robot.inspect(read(urdf))
    q = found.robot.state("home")
    assert found.robot.pose("grasp", q)[2, 2] == pytest.approx(-1, abs=1e-6)
    assert "state home" not in [finding.field for finding in found.unsure]


@pytest.mark.parametrize(
    ("urdf", "message"),
    [
        (small.robot("bare", small.link("base"), small.link("tip"),
                     small.joint("j", "revolute", "base", "tip")), "no link has a collision shape"),
        (small.robot("arm", small.base(), small.arm()),
         "no hand was found: no joint moves a finger .*robot join ARM GRIPPER --mount LINK` adds"),
        (small.gripper(hand=small.revolute().replace('type="revolute"', 'type="fixed"')),
         "no joint moves left_finger, right_finger .*robot join ARM GRIPPER"),
        (small.gripper(hand=small.prismatic().replace('upper="0.03"', 'upper="0.0002"')),
         "no joint moves left and right together"),
    ],
)  # fmt: skip
def test_refusals(urdf, message):
    with pytest.raises(ValueError, match=message):
        robot.inspect(read(urdf))


def test_a_refusal_names_the_robot(tmp_path, capsys):
    (tmp_path / "arm.urdf").write_text(small.robot("arm", small.base(), small.arm()))
    (tmp_path / "card.yaml").write_text(CARD.replace("ROBOT", "arm.urdf"))
    assert cli.main(["robot", "inspect", str(tmp_path / "arm.urdf")]) == 2
    assert capsys.readouterr().err.startswith("arm: no hand was found: ")
    assert cli.main(["plan", str(tmp_path / "card.yaml"), "-o", str(tmp_path / "p.json")]) == 2
    assert "card.yaml:3: robot: no hand was found: " in capsys.readouterr().err


def test_frames_are_not_added_to_a_comment():
    found = robot.inspect(read(small.gripper() + "<!-- </robot> -->"))
    assert "left_fingertip" in found.robot.frame_names


def test_a_hand_without_an_arm_says_so():
    found = robot.inspect(read(small.robot("alone", small.base("wrist"), small.prismatic())))
    assert found.hand == {}
    assert "group arm" in [finding.field for finding in found.unsure]


def test_fingers_that_stay_apart_are_doubtful():
    apart = small.prismatic().replace('lower="0"', 'lower="0.01"')
    found = robot.inspect(read(small.gripper(hand=apart)))
    closed = next(finding for finding in found.findings if finding.field == "state closed")
    assert not closed.is_sure
    assert "thinner than 20.0 mm cannot be held" in closed.reason


CARD = """
kind: slide
robot:   {urdf: ROBOT}
object:  {rectangle: {size: [0.1, 0.06]}, thickness: 0.003, pose: {x: 0.42, y: 0.05, yaw: 0.3}}
support: {rectangle: {center: [0.45, 0.0], size: [0.4, 0.5]}}
"""


def test_fields_that_are_given_have_precedence(tmp_path):
    (tmp_path / "mine.urdf").write_text(small.gripper())
    text = CARD.replace("ROBOT", "mine.urdf") + "hand: {pad_width: 0.011, pitch: 1.1}\n"
    (tmp_path / "card.yaml").write_text(text)
    with pytest.warns(UserWarning, match="no SRDF: proposed"):
        task = load_task(tmp_path / "card.yaml")
    assert task.problem.hand.pad_width == 0.011
    assert task.options.pitch == 1.1
    assert task.problem.hand.fingertip == "left_fingertip"


def test_srdf_that_is_given_stays():
    home = "".join(f'<joint name="joint_{i}" value="0.1"/>' for i in range(6))
    srdf = (
        '<robot name="gripper"><group name="mine"><joint name="joint_0"/></group>'
        '<group name="hand"><joint name="slide_left"/></group>'
        f'<group_state name="home" group="mine">{home}</group_state>'
        '<group_state name="open" group="hand"><joint name="slide_left" value="0.02"/>'
        "</group_state></robot>"
    )
    made = robot.inspect(read(small.gripper(), srdf=srdf)).robot
    column = made.joint("slide_left")
    assert made.state("open")[column] == pytest.approx(0.02)
    assert made.state("home")[column] == pytest.approx(0.02)  # the arm's home opens the hand
    np.testing.assert_allclose(made.state("home")[made.group("arm")], 0.1)
    assert made.group("mine") == [made.joint("joint_0")]


def test_command_writes_what_plan_takes(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.urdf").write_text(small.gripper())
    assert cli.main(["robot", "inspect", "mine.urdf", "-o", "made"]) == 0
    said = capsys.readouterr().out
    assert "fingertip" in said
    assert "written: made/mine.srdf" in said
    with Image.open(tmp_path / "made" / "mine.png") as picture:
        rows = np.asarray(picture.convert("RGB"))[100:].astype(int)  # below titles and captions
    blue = rows[..., 2] - rows[..., :2].max(axis=-1) > 60
    assert blue.any()
    assert not blue[:12].any()  # no axis is cut off at the top
    (tmp_path / "made" / "card.yaml").write_text(CARD.replace("ROBOT", "mine.urdf"))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        task = load_task(tmp_path / "made" / "card.yaml")
    assert task.fields.proposed is None
    assert plan(task)
    assert cli.main(["robot", "check", "made/mine.urdf"]) == 0
    hand = tmp_path / "made" / "mine.hand.yaml"
    hand.write_text(hand.read_text() + "# mine\n")
    capsys.readouterr()
    assert cli.main(["robot", "inspect", "mine.urdf", "-o", "made"]) == 0
    said = capsys.readouterr().out
    assert said.endswith("kept: made/mine.hand.yaml~, as it was before\n")
    assert (tmp_path / "made" / "mine.hand.yaml~").read_text().endswith("# mine\n")
    assert "# mine" not in hand.read_text()


def test_command_tells_faults_of_its_own_files(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    hand = small.three_fingers().replace(
        "0.09 0.1 0.04", "0.02 0.1 0.04"
    )  # smaller than its joints
    (tmp_path / "mine.urdf").write_text(small.gripper(hand=hand))
    assert cli.main(["robot", "inspect", "mine.urdf"]) == 1
    said = capsys.readouterr().out.splitlines()
    told = [line.removeprefix("fault: ") for line in said if line.startswith("fault: ")]
    assert "fingers.index_near[0]: lies outside the collision shapes of palm" in told[0]
    assert cli.main(["robot", "check", "mine/mine.urdf"]) == 1
    assert capsys.readouterr().out.splitlines() == told
    assert cli.main(["robot", "inspect", "mine.urdf", "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["faults"] == told


@pytest.mark.parametrize(
    "hand",
    [
        small.three_fingers().replace("0.09 0.1 0.04", "0.05 0.1 0.04"),
        small.split_palm("opposed_near_joint").replace("0.02 0.02 0.04", "0.02 0.05 0.04"),
    ],
)
def test_corners_of_joints_beside_the_palm_lie_in_it(tmp_path, capsys, monkeypatch, hand):
    """Of the second one, a part of the palm moves, and its fingers begin 10 mm above it."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.urdf").write_text(small.gripper(hand=hand))
    assert cli.main(["robot", "inspect", "mine.urdf"]) == 0, capsys.readouterr().out
    assert cli.main(["robot", "check", "mine/mine.urdf"]) == 0


def test_command_as_json(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.urdf").write_text(small.gripper())
    assert cli.main(["robot", "inspect", "mine.urdf", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["hand"]["fingertip"] == "left_fingertip"
    assert all((tmp_path / path).is_file() for path in document["files"])
    assert document["kept"] == document["faults"] == []
    (tmp_path / "mine" / "mine.srdf").write_text("mine")
    assert cli.main(["robot", "inspect", "mine.urdf", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["kept"] == ["mine/mine.srdf~"]
    assert cli.main(["robot", "inspect"]) == 2
    assert "give either FILE or --name" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        (
            ('<origin xyz="0 0.01 0.08"', '<origin xyz="0 0.01 0.06"'),
            "behind the end of the finger",
        ),
        (("open: open", "open: closed"), "closed: the tips are not nearer"),
    ],
)
def test_check_tells_what_is_wrong(tmp_path, capsys, change, fault):
    found = robot.inspect(read(small.gripper()), name="mine")
    found.write(tmp_path)
    (tmp_path / "mine.clasp.yaml").unlink()
    for path in tmp_path.iterdir():
        path.write_text(path.read_text().replace(*change))
    assert cli.main(["robot", "check", str(tmp_path / "mine.urdf")]) == 1
    assert fault in capsys.readouterr().out


def test_check_finds_a_home_in_collision(tmp_path, capsys):
    found = robot.inspect(read(small.gripper()), name="mine")
    found.write(tmp_path)
    srdf = tmp_path / "mine.srdf"
    text = srdf.read_text()
    before, state, after = text.partition('<group_state name="home" group="arm">')
    inner, end, rest = after.partition("</group_state>")
    values = "".join(
        f'<joint name="joint_{i}" value="{v}"/>' for i, v in enumerate([0, 2.8, 2.8, 0, 0, 0])
    )
    srdf.write_text(before + state + values + end + rest)
    assert cli.main(["robot", "check", str(tmp_path / "mine.urdf")]) == 1
    assert "home: " in capsys.readouterr().out


def test_check_opens_the_hand_at_home(tmp_path, capsys):
    """With the arm at 0 this robot would touch a ceiling, but no task starts there."""
    ceiling = small.box("ceiling", "0 0 1.4", "0.3 0.3 0.04")
    ceiling += small.joint("hung", "fixed", "base", "ceiling")
    urdf = small.gripper().replace("</robot>", ceiling + "</robot>")
    found = robot.inspect(read(urdf), name="mine")
    at_zero = np.asarray(found.robot.state("open"))
    assert "ceiling" in scene.Scene(found.robot).collision(at_zero)
    found.write(tmp_path)
    assert cli.main(["robot", "check", str(tmp_path / "mine.urdf")]) == 0, capsys.readouterr().out


@pytest.mark.parametrize("name", ["kr5_sdh", "kr5_dlr", "kr5_icub", "kr5_armar", "wam_t42"])
def test_nothing_is_wrong_with_our_own_files(name, capsys):
    assert cli.main(["robot", "check", str(robot.builtin(name))]) == 0, capsys.readouterr().out


def test_check_finds_a_corner_outside(tmp_path, capsys):
    robot.inspect(read(small.gripper(hand=small.three_fingers())), name="mine").write(tmp_path)
    assert cli.main(["robot", "check", str(tmp_path / "mine.urdf")]) == 0, capsys.readouterr().out
    clasp = tmp_path / "mine.clasp.yaml"
    fields = yaml.safe_load(clasp.read_text())
    fields["thumb"][-1]["point"] = [0.0, 0.05, 0.05]
    clasp.write_text(yaml.safe_dump(fields))
    assert cli.main(["robot", "check", str(tmp_path / "mine.urdf")]) == 1
    said = capsys.readouterr().out
    assert "thumb[2]: lies outside the collision shapes of opposed_far" in said
    clasp.unlink()
    assert cli.main(["robot", "check", str(tmp_path / "mine.urdf")]) == 2


def test_mesh_paths_survive_another_folder(tmp_path):
    mesh = tmp_path / "meshes" / "box.off"
    mesh.parent.mkdir()
    mesh.write_text(
        "OFF\n4 4 0\n0 0 0\n.05 0 0\n0 .05 0\n0 0 .05\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
    )
    urdf = small.gripper().replace(
        '<box size="0.2 0.2 0.08"/>', '<mesh filename="meshes/box.off"/>', 1
    )
    (tmp_path / "mine.urdf").write_text(urdf)
    found = robot.inspect(str(tmp_path / "mine.urdf"))
    written = found.write(tmp_path / "elsewhere")
    again = robot.Robot.from_urdf_file(str(written[0]))
    assert any(isinstance(placed.shape, geometry.Mesh) for _, placed in again.shapes)


@pytest.mark.parametrize(
    ("hand", "effort", "value", "is_sure", "words"),
    [
        (small.prismatic(), "50", "25 N", True, "effort limit of slide_left"),  # one for both
        (small.prismatic(mimic=False), "50", "50 N", True, "effort limit of slide_left"),
        (small.prismatic(), "5000", "2.5e+03 N", False, "write the real limit into the URDF"),
        (small.prismatic(), None, "unknown", False, "no effort limit of slide_left"),
    ],
)
def test_the_force_of_the_grip_is_that_of_virtual_work(hand, effort, value, is_sure, words):
    given = ' effort="50"'
    urdf = small.gripper("gripper", hand)
    arm, gripper = urdf.split('<link name="palm">')
    changed = gripper.replace(given, f' effort="{effort}"' if effort else "")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of the missing limit
        proposal = robot.inspect(read(f'{arm}<link name="palm">{changed}'))
    (grip,) = (finding for finding in proposal.findings if finding.field == "grip force")
    assert (grip.value, grip.is_sure) == (value, is_sure)
    assert words in grip.reason
