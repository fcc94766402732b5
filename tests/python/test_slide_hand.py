# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arms and hands that no slide is possible with are refused, with the lengths in the way."""

import pytest

import graspless
import inspect_common as small
from graspless import robot
from graspless.errors import TaskError

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
