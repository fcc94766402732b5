# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pinches: task file, plan file, check, timing, simulation and chains."""

import copy
import re
import warnings

import numpy as np
import pytest

import graspless
import inspect_common as small
from graspless import _data, frames, geometry, pinch, robot, scene
from graspless.errors import TaskError
from graspless.tasks import task_from_dict
from graspless.tasks.grip import ends_of_curves, weakest_joint
from tasks_common import pixels, read_png, recording

TASK = {
    "kind": "pinch",
    "robot": {"urdf": "wam_t42"},
    "object": {
        "name": "bar",
        "rectangle": {"size": [0.12, 0.03]},
        "thickness": 0.05,
        "pose": {"x": 0.6, "y": 0.1, "yaw": 0.5},
    },
    "support": {"rectangle": {"center": [0.65, 0.0], "size": [0.7, 0.7]}},
}


def changed(**fields):
    task = copy.deepcopy(TASK)
    for place, value in fields.items():
        *above, last = place.split("__")
        inner = task
        for key in above:
            inner = inner.setdefault(key, {})
        inner[last] = value
    return task


@pytest.fixture(scope="module")
def plan():
    found = graspless.plan(TASK, seed=1)
    assert found, found.reason
    return found


def test_a_pinch_holds_and_is_kept_by_its_file(plan, tmp_path):
    assert isinstance(plan, pinch.Plan)
    assert graspless.check(plan) == []
    assert [segment.name for segment in plan.segments] == ["approach", "grasp", "close"]
    plan.save(tmp_path / "plan.json")
    assert graspless.load_plan(tmp_path / "plan.json") == plan
    assert plan.task.kind == "pinch"


def test_the_contacts_are_opposite_on_the_narrow_faces(plan):
    first, second = plan.contacts_O
    assert np.linalg.norm(second - first) == pytest.approx(0.03, abs=1e-6)
    assert sorted([first[1], second[1]]) == pytest.approx([-0.015, 0.015], abs=1e-6)
    assert plan.friction < 0.01
    assert plan.opening == pytest.approx(0.054, abs=1e-6)


def test_an_edited_plan_is_at_fault(plan):
    edited = copy.copy(plan)
    edited.contacts_O = np.asarray(plan.contacts_O) + [0, 0.02, 0]
    assert any("contact" in fault for fault in graspless.check(edited))


def test_contacts_beside_the_hand_are_a_fault(plan):
    moved = copy.copy(plan)
    moved.contacts_O = np.asarray(plan.contacts_O) + [0.03, 0, 0]  # along both faces
    assert "close: the contacts are beside the pads" in graspless.check(moved)


def test_the_edges_are_certified(plan):
    assert graspless.check(plan, certify=True) == []


def test_the_hand_closes_slowly(plan):
    trajectory = graspless.time(plan)
    assert trajectory.duration > 1
    assert np.allclose(trajectory.object_poses[-1], plan.X_WO_start)


def test_the_simulated_hand_lifts_the_object(plan):
    simulation = graspless.simulate(plan, trials=2)
    assert simulation, [trial.failures for trial in simulation.trials]
    assert simulation.trials[0].measures["lift_height"] > 0.09


def test_a_problem_made_in_python_is_planned(plan):
    given = plan.task.problem
    problem = pinch.Problem(
        given.robot, given.hand, given.object, given.support, given.X_WO_start, given.q_home
    )
    again = graspless.plan(problem, seed=1)
    assert again.kind == "pinch"
    assert np.array_equal(again.segments[-1].positions, plan.segments[-1].positions)
    assert graspless.check(pickled(again)) == []


def test_an_object_that_is_tilted_a_little_is_pinched(plan):
    given = plan.task.problem
    for axis in (0, 1):
        tilt = [0.0, 0.0, 0.0]
        tilt[axis] = 0.005
        X_WO = np.array(given.X_WO_start) @ frames.from_rpy(tilt)
        problem = pinch.Problem(
            given.robot, given.hand, given.object, given.support, X_WO, given.q_home
        )
        tilted = graspless.plan(problem, seed=1)
        assert tilted, tilted.reason
        assert graspless.check(tilted) == []


def pickled(value):
    import pickle

    return pickle.loads(pickle.dumps(value))


@pytest.mark.parametrize(
    ("fields", "status", "words"),
    [
        ({"object__rectangle": {"size": [0.2, 0.118]}}, "too_wide", "118 mm wide where it is"),
        ({"object__thickness": 0.004}, "too_flat", "4.0 mm high; "),
        ({"options": {"max_lever": 0.0}, "object__com": [0.055, 0.0]}, "too_slippery", "centre of"),
    ],
)
def test_lengths_are_reasons(fields, status, words):
    found = graspless.plan(changed(**fields))
    assert str(found.status) == status
    assert words in found.reason


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"options": {"friction": -1}}, "options.friction"),
        ({"options": {"pitch": 0.5}}, "unknown field"),
        ({"robot": {"urdf": "kr5_sdh"}}, "robot"),
        ({"object__thickness": -0.01}, "thickness"),
    ],
)
def test_mistakes_name_the_field(fields, words):
    with pytest.raises(TaskError, match=words):
        graspless.plan(changed(**fields))


def test_a_chain_pinches_and_lifts():
    fields = {key: value for key, value in TASK.items() if key != "kind"}
    lift = {"name": "lift", "kind": "carry", "line": {"direction": [0, 0, 1], "distance": 0.1}}
    chain = graspless.plan(
        {"kind": "chain", **fields, "stages": [{"name": "pinch", "kind": "pinch"}, lift]}
    )
    assert chain, chain.reason
    assert graspless.check(chain) == []
    simulation = graspless.simulate(chain)
    assert simulation, simulation.trials[0].failures
    assert simulation.trials[0].measures["kept"] == 1


def test_only_a_carry_follows_a_pinch():
    stages = [{"name": "pinch", "kind": "pinch"}, {"name": "slide", "kind": "slide"}]
    fields = {key: value for key, value in TASK.items() if key != "kind"}
    with pytest.raises(TaskError, match="only a carry can follow"):
        graspless.plan({"kind": "chain", **fields, "stages": stages})


def test_it_is_drawn(plan, tmp_path):
    from graspless import view
    from graspless.view.bodies import OBJECT

    view.write_png(plan, str(tmp_path / "plan.png"))
    view.write_html(plan, str(tmp_path / "plan.html"))
    assert len(pixels(read_png(tmp_path / "plan.png"), OBJECT)) > 300
    messages = recording((tmp_path / "plan.html").read_text())["messages"]
    assert {"/robot", "/object", "/table"} <= {m["name"] for _, m in messages if "name" in m}


@pytest.mark.parametrize("hand", [small.revolute(), small.linkage()], ids=["revolute", "linkage"])
def test_fingers_that_turn_keep_off_the_support_while_they_close(tmp_path, hand):
    """Their tips are lowest when they are upright: before they touch, or a little later."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of what the URDF does not say
        robot.inspect(robot.Robot.from_urdf(small.gripper("hand", hand))).write(tmp_path)
    solved = 0
    for width in (0.01, 0.02, 0.03, 0.04):
        task = {
            "kind": "pinch",
            "robot": {"urdf": str(tmp_path / "hand.urdf")},
            "object": {
                "name": "bar",
                "thickness": 0.02,
                "rectangle": {"size": [0.15, width]},
                "pose": {"x": 0.45, "y": 0.05, "yaw": 0.4},
            },
            "support": {"rectangle": {"center": [0.65, 0], "size": [0.7, 0.7]}},
            "options": {"depth": 0.003, "patch": 0.003, "height": 0.0},
        }
        found = graspless.plan(task, seed=1)
        solved += bool(found)
        assert not found or graspless.check(found) == []
    assert solved >= 3


def gaps_on_the_way_down(plan):
    """Returns the gap that the hand leaves on either side of the object, at most 3 mm [m]."""
    problem = plan.task.problem
    hand, frame = problem.robot, problem.hand.grasp_frame
    world = scene.Scene(hand)
    size = np.append(np.ptp(problem.object.outline.vertices, axis=0), problem.object.thickness)
    world.add_object("object", [geometry.PlacedShape(geometry.Box(size))])
    X_HW = np.linalg.inv(plan.X_WH_grasp)
    down = [q for q in plan.segments[1].positions if (X_HW @ hand.pose(frame, q))[2, 3] < -1e-3]
    across = plan.contacts_O[1] - plan.contacts_O[0]
    across /= np.linalg.norm(across)

    def touches(off):
        X_OB = np.eye(4)
        X_OB[:3, 3] = off * across + [0, 0, size[2] / 2]
        world.move_object("object", plan.X_WO_start @ X_OB)
        return any("object" in (world.collision(q) or ()) for q in down)

    steps = np.arange(0, 3.01e-3, 1e-4)
    return [next((off for off in steps if touches(side * off)), 3e-3) for side in (-1, 1)]


@pytest.mark.parametrize("yaw", [0.0, 0.4, 1.5])
def test_a_jaw_that_does_not_move_comes_aside_of_the_object(tmp_path, yaw):
    jaws = small.one_jaw().replace("revolute", "prismatic").replace("-1.4", "-0.05")
    jaws = jaws.replace('axis xyz="-1 0 0"', 'axis xyz="0 1 0"')
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of what the URDF does not say
        robot.inspect(robot.Robot.from_urdf(small.gripper("jaw", jaws))).write(tmp_path)
    task = changed(
        robot__urdf=str(tmp_path / "jaw.urdf"),
        object__rectangle={"size": [0.09, 0.02]},
        object__pose={"x": 0.45, "y": 0.05, "yaw": yaw},
    )
    found = graspless.plan(task, seed=1)
    assert found, found.reason
    assert graspless.check(found) == []
    assert min(gaps_on_the_way_down(found)) > 0.0017
    near = graspless.plan({**task, "options": {"margin": 0.0}}, seed=1)
    assert near, near.reason
    assert graspless.check(near) == []
    faults = pinch.check(near.task.problem, near, pinch.Options())
    assert any("a finger passes at" in fault for fault in faults)


@pytest.mark.parametrize("width", [0.01, 0.03, 0.04])
def test_a_jaw_that_turns_holds_by_its_face_with_the_force_that_check_finds(tmp_path, width):
    """Its face is not parallel to the other one, and its end reaches further out."""
    jaws = small.one_jaw().replace("50", "5")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of what the URDF does not say
        robot.inspect(robot.Robot.from_urdf(small.gripper("jaw", jaws))).write(tmp_path)
    task = changed(
        robot__urdf=str(tmp_path / "jaw.urdf"),
        object__rectangle={"size": [0.12, width]},
        object__pose={"x": 0.45, "y": 0.05, "yaw": 0.3},
    )
    found = graspless.plan(task, seed=1)
    assert found, found.reason
    assert found.max_mass > 0
    assert graspless.check(found) == []


def with_effort(folder, effort):
    """Writes a WAM with T42 whose URDF gives the motor of the hand an effort limit [Nm]."""
    for part in (".urdf", ".srdf", ".hand.yaml", ".clasp.yaml"):
        text = (_data.directory("urdf") / f"wam_t42{part}").read_text()
        (folder / f"mine{part}").write_text(text.replace('effort="2"', f'effort="{effort}"'))
    return {"urdf": str(folder / "mine.urdf")}


CLASP = {"kind": "clasp", "object": {"name": "purse", "sample": "purse"}}


@pytest.mark.parametrize(
    ("task", "instead"),
    [(TASK, "write the real limit into the URDF, or give grip_force"), (CLASP, "into the URDF")],
)
def test_a_limit_of_effort_that_no_gripper_has_is_told(tmp_path, task, instead):
    given = task | {"robot": with_effort(tmp_path, 1000)}
    with pytest.warns(UserWarning, match="joint 'left_finger_joint' has an effort limit") as said:
        told = task_from_dict(given, "task", resolve=True)
    assert len(said) == 1
    text = str(said[0].message)
    assert text.startswith("task: robot.urdf: ")
    assert "limit of 1000 Nm" in text
    assert "few grippers are stronger than 500 N" in text
    assert text.endswith(instead)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        task_from_dict(told.to_dict(), "plan")  # of what a plan file has, it was told before
        task_from_dict(task | {"robot": with_effort(tmp_path, 20)}, "task", resolve=True)


def test_limits_of_several_fingers_are_told_once_with_the_largest_force(tmp_path):
    for part in (".urdf", ".srdf", ".clasp.yaml"):
        text = (_data.directory("urdf") / f"kr5_sdh{part}").read_text()
        strong = re.sub(r'effort="(1\.4|2\.1)"', 'effort="1000"', text)
        (tmp_path / f"mine{part}").write_text(strong)
    given = CLASP | {"robot": {"urdf": str(tmp_path / "mine.urdf")}}
    with pytest.warns(UserWarning, match="a finger presses with") as said:
        made = task_from_dict(given, "task", resolve=True).problem
    assert len(said) == 1
    told = float(re.search(r"presses with (\d+) N", str(said[0].message))[1])
    made_robot, hand = made.robot, made.hand
    q = [np.array(made_robot.state(name)) for name in (hand.open, hand.closed)]
    moving = [made_robot.joint_names[i] for i in np.flatnonzero(q[0] != q[1])]
    forces = [
        weakest_joint(made_robot, moving, sum(q) / 2, ends_of_curves(hand, finger))[1]
        for finger in hand.fingers
    ]
    assert len(forces) > 1
    assert told == pytest.approx(max(forces), abs=0.5)


def test_a_given_force_needs_no_limit_of_effort(tmp_path):
    task = TASK | {"robot": with_effort(tmp_path, 1000), "options": {"grip_force": 10.0}}
    assert task_from_dict(task, "task", resolve=True).options.grip_force == 10.0


def test_the_force_that_is_told_is_that_of_inspect(tmp_path):
    given = with_effort(tmp_path, 1000)
    found = robot.inspect(robot.Robot.from_urdf_file(given["urdf"]))
    force = next(finding.value for finding in found.findings if finding.field == "grip force")
    with pytest.warns(UserWarning, match="each finger presses with") as said:
        task_from_dict(TASK | {"robot": given}, "task", resolve=True)
    told = float(re.search(r"presses with (\d+) N", str(said[0].message))[1])
    assert told == pytest.approx(float(force.split()[0]), rel=0.1)
