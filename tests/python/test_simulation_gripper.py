# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grippers of two fingers in the physics engine: servos of sliding joints, loads, curves."""

from types import SimpleNamespace

import mujoco
import numpy as np
import pytest

import inspect_common as small
from graspless import clasp
from graspless.robot import Robot
from graspless.simulation.clasp import _settings
from graspless.simulation.clasp.judge import _inside
from graspless.simulation.robots import lags, robot_spec
from graspless.simulation.settings import Clasp, Servo
from graspless.tasks.robots import Robot as Fields

INERTIAL = (
    '<inertial><mass value="0.5"/>'
    '<inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>'
)


@pytest.fixture(scope="module")
def gripper():
    urdf = small.gripper().replace("</link>", f"{INERTIAL}</link>")
    return Robot.from_urdf(urdf), robot_spec(
        Robot.from_urdf(urdf), Fields(urdf_text=urdf)
    ).compile()


def test_sliding_joints_deflect_by_a_tenth_in_metres(gripper):
    arm, model = gripper
    for joint, effort, weight, lag in zip(
        arm.joint_names, arm.max_effort, arm.step_weights, lags(arm), strict=True
    ):
        actuator = model.actuator(joint)
        assert effort / actuator.gainprm[0] == pytest.approx(Servo().sag / weight)
        assert -actuator.biasprm[2] / actuator.gainprm[0] == pytest.approx(lag)
        armature = model.dof_armature[model.joint(joint).dofadr[0]]
        assert armature == pytest.approx(effort / Servo().sag / Servo().bandwidth ** 2)
    assert arm.step_weights[list(arm.joint_names).index("slide_left")] == 10


def test_a_jaw_that_is_pushed_with_half_its_effort_gives_way_by_half_a_millimetre(gripper):
    arm, model = gripper
    model.opt.gravity[:] = 0
    data = mujoco.MjData(model)
    joint = model.joint("slide_left")
    data.qpos[joint.qposadr[0]] = data.ctrl[model.actuator("slide_left").id] = 0.01
    data.qfrc_applied[joint.dofadr[0]] = 25
    mujoco.mj_step(model, data, nstep=500)
    assert data.qpos[joint.qposadr[0]] == pytest.approx(0.0105, abs=5e-5)


def test_an_effort_limit_of_zero_is_told():
    urdf = small.gripper().replace("</link>", f"{INERTIAL}</link>")
    urdf = urdf.replace('effort="50"', 'effort="0"')
    robot = Robot.from_urdf(urdf)
    assert not np.isfinite(robot.max_effort[list(robot.joint_names).index("slide_left")])
    with pytest.warns(UserWarning, match="'joint_0'.* and 2 more: the URDF has no effort"):
        spec = robot_spec(robot, Fields(urdf_text=urdf))
    model = spec.compile()
    assert model.actuator("slide_left").forcerange.tolist() == [-50, 50]


@pytest.mark.parametrize(
    ("fingers", "load", "force"), [(1, 3.0, 3.0), (1, 0.0, 15.0), (2, 3.0, 15.0)]
)
def test_two_fingers_are_pulled_with_the_load_of_the_task(fingers, load, force):
    task = SimpleNamespace(
        problem=SimpleNamespace(hand=clasp.Hand(fingers=[clasp.Finger()] * fingers)),
        options=clasp.Options(stability=clasp.StabilityOptions(force=load, torque=load / 10)),
    )
    settings = _settings(SimpleNamespace(task=task, fingers=[], pre_shape=""))
    assert settings.force == settings.pull_needed == force
    assert settings.torque == (load / 10 if force == load else Clasp().torque)


def test_curves_run_through_the_shapes_of_their_links():
    model = SimpleNamespace(
        geom_bodyid=np.array([1, 1, 2]),
        geom_pos=np.array([[0, 0.016, 0.03], [0, 0.02, 0.2], [0, 0.016, 0.03]]),
    )
    palm, root, tip = (0, np.zeros(3)), (1, np.zeros(3)), (1, np.array([0, 0, 0.05]))
    found = _inside([palm, root, tip], model)
    assert [body for body, _ in found] == [0, 1, 1, 1]
    assert found[2][1].tolist() == [0, 0.016, 0.03]  # beside the side, not beyond its end
