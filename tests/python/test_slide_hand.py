# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arms and hands that no slide is possible with are refused, with the lengths in the way."""

import copy
import io
import json
import re
import shutil

import numpy as np
import pytest
import trimesh
from trimesh.creation import box

import graspless
import inspect_common as small
from graspless import robot
from graspless.errors import TaskError
from graspless.tasks import read_task

TASK = {
    "kind": "slide",
    "object": {
        "rectangle": {"size": [0.1, 0.06]},
        "thickness": 0.003,
        "pose": {"x": 0.42, "y": 0.05, "yaw": 0.3},
    },
    "support": {"rectangle": {"center": [0.45, 0.0], "size": [0.4, 0.5]}},
}


def plan(tmp_path, urdf, **changes):
    robot.inspect(robot.Robot.from_urdf(urdf), name="mine").write(tmp_path)
    task = TASK | {"robot": {"urdf": str(tmp_path / "mine.urdf")}}
    return graspless.plan(task | {"object": TASK["object"] | changes})


def test_gap_of_the_closed_fingers(tmp_path):
    """Fingers that stay 20 mm apart."""
    urdf = small.gripper(hand=small.prismatic().replace('lower="0"', 'lower="0.01"'))
    what = (
        "closed: closed: the fingers stay 20 mm apart, but the object 'object' is only 3 mm thick"
    )
    with pytest.raises(TaskError, match=what):
        plan(tmp_path, urdf)
    assert plan(tmp_path, urdf, thickness=0.025)


def test_arm_of_five_joints_pinches_from_above(tmp_path):
    fixed = 'name="joint_3" type="fixed"'
    urdf = small.gripper().replace('name="joint_3" type="revolute"', fixed)
    with pytest.raises(TaskError, match="hand.arm: 'arm' has 5 joints; a slide needs 6 or more"):
        plan(tmp_path, urdf)
    box = TASK["object"] | {"rectangle": {"size": [0.1, 0.03]}, "thickness": 0.06}
    here = {"urdf": str(tmp_path / "mine.urdf")}
    pinched = graspless.plan(TASK | {"kind": "pinch", "robot": here, "object": box})
    assert pinched, pinched.reason
    assert graspless.check(pinched) == []


@pytest.fixture(scope="module")
def five_joints(tmp_path_factory):
    """Field `robot` of a gripper on an arm of five joints, whose hand can hang straight down."""
    folder = tmp_path_factory.mktemp("five")
    fixed = 'name="joint_3" type="fixed"'
    urdf = small.gripper().replace('name="joint_3" type="revolute"', fixed)
    robot.inspect(robot.Robot.from_urdf(urdf), name="mine").write(folder)
    return {"urdf": str(folder / "mine.urdf")}


@pytest.mark.parametrize("tilt", [2e-4, 2e-3, 8e-3])
@pytest.mark.parametrize("axis", [0, 1])
def test_arm_of_five_joints_leans_with_the_table(five_joints, tilt, axis):
    """Cameras and mounts are level within tenths of a degree."""
    box = TASK["object"] | {"rectangle": {"size": [0.1, 0.03]}, "thickness": 0.06, "mass": 0.05}
    rpy = [0.0, 0.0, 0.0]
    rpy[axis] = tilt
    support = {"rectangle": {"size": [0.4, 0.5]}, "pose": {"position": [0.45, 0, 0], "rpy": rpy}}
    box["pose"] = {"x": -0.03, "y": 0.05, "yaw": 0.3}
    lift = {"name": "lift", "kind": "carry", "line": {"direction": [0, 0, 1], "distance": 0.05}}
    side = {"name": "side", "kind": "carry", "offset": [0, -0.08, 0]}
    stages = [{"name": "pinch", "kind": "pinch"}, lift]
    stages += [side] if tilt < 5e-3 else []  # a hand that leans turns with the arm
    task = {"kind": "chain", "robot": five_joints, "object": box, "support": support}
    done = graspless.plan(task | {"stages": stages})
    assert done, done.reason
    assert graspless.check(done) == []
    assert graspless.check(done, certify=True) == []


@pytest.mark.parametrize("tilt", [0.0, 5e-4])
def test_arm_of_five_joints_puts_down(five_joints, tilt):
    box = TASK["object"] | {"rectangle": {"size": [0.1, 0.03]}, "thickness": 0.06, "mass": 0.05}
    box["pose"] = {"x": -0.03, "y": 0.05, "yaw": 0.3}
    support = {"rectangle": {"size": [0.4, 0.5]}}
    support["pose"] = {"position": [0.45, 0, 0], "rpy": [tilt, 0, 0]}
    lift = {"name": "lift", "kind": "carry", "line": {"direction": [0, 0, 1], "distance": 0.05}}
    pose = {"position": [0.45, -0.1, -0.1 * tilt], "rpy": [tilt, 0, 1.0]}
    place = {"name": "place", "kind": "carry", "place": {"poses": [pose], "on": "support"}}
    stages = [{"name": "pinch", "kind": "pinch"}, lift, place]
    task = {"kind": "chain", "robot": five_joints, "object": box, "support": support}
    done = graspless.plan(task | {"stages": stages})
    assert done, done.reason
    assert graspless.check(done, certify=True) == []
    document = json.loads(done.to_json())
    for stage in (document["task"]["stages"][2], document["stages"][2]["task"]):
        stage["place"]["poses"][0]["position"][1] += 1e-3
    faults = graspless.check(graspless.load_plan(io.StringIO(json.dumps(document))))
    assert any("the object is not at its place" in fault for fault in faults), faults


def test_arm_of_five_joints_takes_any_angle_tolerance(five_joints):
    box = TASK["object"] | {"rectangle": {"size": [0.1, 0.03]}, "thickness": 0.06, "mass": 0.05}
    lift = {"name": "lift", "kind": "carry", "line": {"direction": [0, 0, 1], "distance": 0.05}}
    lift["options"] = {"angle_tolerance": 0.5}
    task = {"kind": "chain", "robot": five_joints, "object": box, "support": TASK["support"]}
    done = graspless.plan(task | {"stages": [{"name": "pinch", "kind": "pinch"}, lift]})
    assert done, done.reason


def test_a_hand_that_turns_from_its_contacts_is_a_fault(five_joints):
    box = TASK["object"] | {"rectangle": {"size": [0.1, 0.03]}, "thickness": 0.06}
    support = TASK["support"]
    pinched = graspless.plan(
        {"kind": "pinch", "robot": five_joints, "object": box, "support": support}
    )
    assert graspless.check(pinched) == []
    for turn, is_fault in ((0.008, False), (0.02, True)):
        a, b = np.asarray(pinched.contacts_O)
        aside = turn / 2 * np.cross([0.0, 0.0, 1.0], b - a)
        turned = copy.copy(pinched)
        turned.contacts_O = np.stack([a - aside, b + aside])
        told = [f for f in graspless.check(turned) if "do not close along the line" in f]
        assert bool(told) == is_fault


def test_what_is_flat_or_far_is_a_result_of_a_pinch(five_joints):
    thin = TASK["object"] | {"rectangle": {"size": [0.03, 0.03]}, "thickness": 0.004}
    pinch = {"kind": "pinch", "robot": five_joints, "support": TASK["support"]}
    found = graspless.plan(pinch | {"object": thin})
    assert found.status == found.status.too_flat
    support = {"rectangle": {"center": [2.0, 0.0], "size": [0.4, 0.5]}}
    far = TASK["object"] | {"thickness": 0.06, "pose": {"x": 2.0, "y": 0.0, "yaw": 0.3}}
    far["rectangle"] = {"size": [0.1, 0.03]}
    found = graspless.plan(pinch | {"object": far, "support": support})
    assert re.search(r"the hand gets at most 1\.\d+ m from '\w+', and its nearest", found.reason)


def test_pads_of_a_mesh_are_at_its_end(tmp_path):
    """Fingers of one mesh each, with a bump of 2 mm at their base that touches no object."""
    size, middle = (0.02, 0.01, 0.08), (0, 0.005, 0.04)
    hand = small.prismatic()
    for side, sign in (("left", 1), ("right", -1)):
        parts = [
            box(size, trimesh.transformations.translation_matrix([0, sign * middle[1], middle[2]])),
            box(
                size[:2] + (0.01,),
                trimesh.transformations.translation_matrix([0, sign * 0.003, 0.01]),
            ),
        ]
        trimesh.util.concatenate(parts).export(tmp_path / f"{side}.stl")
        given = small.box(side, f"0 {sign * middle[1]} {middle[2]}", "0.02 0.01 0.08")
        assert given in hand
        mesh = f'<mesh filename="{tmp_path / side}.stl"/>'
        hand = hand.replace(given, small.link(side, "0 0 0", mesh))
    thing = TASK["object"] | {"rectangle": {"size": [0.1, 0.03]}, "thickness": 0.06}
    robot.inspect(robot.Robot.from_urdf(small.gripper(hand=hand)), name="mine").write(tmp_path)
    here = {"urdf": str(tmp_path / "mine.urdf")}
    pinched = graspless.plan(TASK | {"kind": "pinch", "robot": here, "object": thing})
    assert pinched, pinched.reason
    assert pinched.opening == pytest.approx(0.06, abs=1e-6)
    assert graspless.check(pinched) == []


@pytest.mark.parametrize(
    ("beside", "where"),
    [
        ("arm: leg", r"wam_t42.hand.yaml:\d+: arm: leg: "),
        ("fingertip: [grasp]", r"wam_t42.hand.yaml:\d+: fingertip: "),
        ("fingertip: flange", r"wam_t42.hand.yaml:\d+: fingertip: flange: its Z"),
        ("arm: arm", r"task.yaml:2: hand.open: wide: "),
    ],
)
def test_a_fault_is_in_the_file_that_has_it(tmp_path, beside, where):
    for ending in (".urdf", ".srdf", ".hand.yaml"):
        shutil.copy(robot.builtin("wam_t42").with_name(f"wam_t42{ending}"), tmp_path)
    file, field = tmp_path / "wam_t42.hand.yaml", beside.partition(":")[0]
    file.write_text(re.sub(rf"(?m)^{field}:.*", beside, file.read_text()))
    given = {"open": "wide"} if beside == "arm: arm" else {"pad_friction": 1.0}
    task = {"robot": {"urdf": "wam_t42.urdf"}, "hand": given} | TASK
    text = "".join(f"{name}: {json.dumps(value)}\n" for name, value in task.items())
    with pytest.raises(TaskError, match=where):
        read_task(text, "task.yaml", tmp_path)
