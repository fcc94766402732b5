# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A task's robot in MuJoCo: read from its URDF by MuJoCo, with a position servo on every joint."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from .. import frames
from ..tasks.robots import mesh_path
from .settings import Servo, Solver

if TYPE_CHECKING:
    from ..robot import Robot
    from ..tasks.robots import Robot as RobotFields


def robot_spec(robot: Robot, fields: RobotFields, servo: Servo | None = None) -> Any:
    """The world with the robot alone: an mujoco.MjSpec.

    Bodies and joints have the URDF's names, an actuator that of its joint. Pairs of links that
    the planner never tests do not collide; gravity is compensated; mimic joints are coupled.

    Parameters
    ----------
    robot : Robot
        For the order of its joints, its base and its pairs of links.
    fields : tasks.robots.Robot
        A resolved task's: has the URDF's text.
    servo : Servo, optional
        Of all joints.
    """
    servo = servo or Servo()
    spec = mujoco.MjSpec.from_string(_with_compiler(fields))
    apply(spec)
    names = list(robot.frame_names)
    base = spec.body(names[0])
    base.pos, base.quat = robot.X_WB[:3, 3], frames.to_quaternion(robot.X_WB)
    for body in spec.bodies:
        if body.name in names:
            body.gravcomp = 1.0
    for i, j in sorted(robot.ignored_pairs):
        spec.add_exclude(bodyname1=names[i], bodyname2=names[j])
    for name, effort in zip(robot.joint_names, robot.max_effort, strict=True):
        _add_servo(spec, name, float(effort), servo)
    for equality in spec.equalities:  # mimic joints: a light follower would yield to a touch
        spec.joint(equality.name1).armature = spec.joint(equality.name2).armature
        equality.solimp[:2] = servo.mimic_solimp
    return spec


def apply(spec: Any, solver: Solver | None = None) -> None:
    """Gives a model the solver's settings."""
    solver = solver or Solver()
    spec.option.timestep = solver.timestep
    spec.option.cone = getattr(mujoco.mjtCone, f"mjCONE_{solver.cone.upper()}")
    spec.option.impratio = solver.impratio
    integrator = f"mjINT_{solver.integrator.upper()}"
    spec.option.integrator = getattr(mujoco.mjtIntegrator, integrator)
    spec.option.tolerance = solver.tolerance
    spec.option.iterations = solver.iterations


def joint_addresses(model: Any, robot: Robot) -> Any:
    """[dof] where each of the robot's joints stands in qpos."""
    return np.array([model.joint(name).qposadr[0] for name in robot.joint_names])


def set_positions(model: Any, data: Any, robot: Robot, q: Any) -> None:
    """The robot at rest at q, [dof], told to stay there; mimic joints with theirs."""
    data.qpos[joint_addresses(model, robot)] = data.ctrl[:] = q
    for equality in np.flatnonzero(model.eq_type == mujoco.mjtEq.mjEQ_JOINT):
        follower, leader = model.eq_obj1id[equality], model.eq_obj2id[equality]
        offset, factor = model.eq_data[equality][:2]
        followed = data.qpos[model.jnt_qposadr[leader]]
        data.qpos[model.jnt_qposadr[follower]] = offset + factor * followed
    mujoco.mj_forward(model, data)


def _add_servo(spec: Any, name: str, effort: float, servo: Servo) -> None:
    """A position servo that sags by `servo.sag` at its greatest effort."""
    effort = effort if np.isfinite(effort) and effort > 0 else servo.effort
    stiffness = effort / servo.sag
    joint = spec.joint(name)
    joint.armature = stiffness / servo.bandwidth**2
    actuator = spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    actuator.set_to_position(kp=stiffness, kv=2 * servo.damping_ratio * stiffness / servo.bandwidth)
    actuator.forcelimited, actuator.forcerange = True, [-effort, effort]


def _with_compiler(fields: RobotFields) -> str:
    """The URDF with absolute mesh files, and told to keep its links as they are."""
    root = ET.fromstring(fields.urdf_text or "")
    for mesh in root.iter("mesh"):
        path = mesh_path(mesh.get("filename", ""), fields.packages, fields.directory)
        mesh.set("filename", str(path))
    settings = {"fusestatic": "false", "strippath": "false", "discardvisual": "true"}
    ET.SubElement(ET.SubElement(root, "mujoco"), "compiler", settings)
    return ET.tostring(root, encoding="unicode")
