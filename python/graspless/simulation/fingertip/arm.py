# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Execution of a fingertip plan by its robot: joint paths with feed-forward of nominal forces."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames
from ...timing import time as timed
from ..robots import apply, compiled, joint_addresses, robot_spec, set_positions
from ..settings import Fingertip, Solver
from .execute import Log, execute
from .script import Script, blended, joined, moving, still
from .servo import LOADING
from .world import World, add_finger_pairs, add_scene

if TYPE_CHECKING:
    from ...fingertip import JointSegment, Plan
    from ...frames import Matrix
    from ...robot import Robot
    from ...timing import Trajectory
    from ..variation import Variation


@dataclass(frozen=True)
class ArmWorld(World):
    """World with a robot in place of bare fingertips.

    Attributes
    ----------
    robot : Robot
    joints : array [dof]
        Where the robot's joints stand in qpos, and in qvel: nothing stands before them.
    tips : list of int
        Body at the centre of each finger's sphere.
    """

    robot: Robot
    joints: Any
    tips: list[int]

    @property
    def centers(self) -> Matrix:
        """Positions of the fingertips [n, 3] [m]."""
        centers: Matrix = self.data.xpos[self.tips]
        return centers

    @property
    def joint_positions(self) -> Matrix:
        """Configuration [dof] of the robot [rad or m]."""
        q: Matrix = self.data.qpos[self.joints]
        return q

    def stand(self, place: Matrix, q: Matrix) -> None:
        """Puts the object [7] and the robot [dof] at the given positions, at rest."""
        self.object_qpos[:] = place
        self.data.qvel[:] = 0
        set_positions(self.model, self.data, self.robot, q)


def build_arm_world(plan: Plan, variation: Variation) -> ArmWorld:
    """Makes the world: robot, planes, obstacles, and the object, which only fingers may touch."""
    problem, arm, settings = plan.task.problem, plan.task.arm, Fingertip()
    spec = robot_spec(arm.robot, plan.task.fields.robot)
    apply(spec, Solver(timestep=settings.timestep * variation.timestep))
    by_finger = _name_finger_geoms(spec, plan)
    add_scene(spec, problem, variation)
    names = [name for geoms in by_finger for name in geoms]
    add_finger_pairs(spec, problem, variation, names)
    model = compiled(spec)
    finger_of_geom = {
        model.geom(name).id: finger for finger, geoms in enumerate(by_finger) for name in geoms
    }
    tips = [model.body(_frame(plan, finger)).id for finger in range(problem.fingers.count)]
    joints = joint_addresses(model, arm.robot)
    data = mujoco.MjData(model)
    world = ArmWorld(model, data, settings, problem, finger_of_geom, arm.robot, joints, tips)
    world.stiffen()
    return world


def _fingertip(plan: Plan, finger: int) -> int:
    """Returns the index of the robot's fingertip that acts as a finger of the plan."""
    found = plan.realization
    assert found is not None
    return found.finger_of_fingertip.index(finger)


def _frame(plan: Plan, finger: int) -> str:
    return str(plan.task.arm.carrier.fingertips[_fingertip(plan, finger)])


def _name_finger_geoms(spec: Any, plan: Plan) -> list[list[str]]:
    """Names the geoms of the links of each finger; returns the names."""
    by_finger: list[list[str]] = []
    for finger in range(plan.task.problem.fingers.count):
        by_finger.append([])
        for link in plan.task.arm.carrier.links[_fingertip(plan, finger)]:
            for k, geom in enumerate(spec.body(link).geoms):
                geom.name = f"{link} {k}"
                by_finger[-1].append(geom.name)
    return by_finger


def carry_out_by_arm(plan: Plan, variation: Variation) -> tuple[World, Script, Log]:
    """Executes a plan as `carry_out` does; `x`, `y` and `yaw` of the variation move the object."""
    world, script = prepare(plan, variation)
    return world, script, execute(world, script, ArmServo(world, script))


def prepare(plan: Plan, variation: Variation) -> tuple[ArmWorld, Script]:
    """Returns the world at the start, and the commands of each step."""
    world = build_arm_world(plan, variation)
    script = arm_program(plan, world.settings)
    script = script.at(np.arange(0, script.duration, world.model.opt.timestep))
    X_WO = frames.from_row(script.places[0])
    X_WO[:2, 3] += variation.x, variation.y
    X_WO[:3, :3] = frames.from_rpy([0, 0, variation.yaw])[:3, :3] @ X_WO[:3, :3]
    world.stand(np.array(frames.to_row(X_WO)), script.joints[0])
    return world, script


def arm_program(plan: Plan, settings: Fingertip) -> Script:
    """Returns the script of the robot: timed joint paths; forces change while the object rests."""
    trajectory = timed(plan, contact_speed=settings.arm_speed)
    parts: list[Script] = []
    for k, segment in enumerate(trajectory.segments):
        part = _part(plan, trajectory, k, segment)
        if parts and not np.allclose(parts[-1].forces[-1], part.forces[0]):
            parts.append(blended(parts[-1], part, settings.load_seconds))
        parts.append(part)
    return joined([*parts, still(parts[-1], -1, settings.rest_seconds, "rest")])


def _part(plan: Plan, trajectory: Trajectory, k: int, segment: JointSegment) -> Script:
    here = np.flatnonzero(trajectory.segment_index == k)
    times, poses = trajectory.times[here] - trajectory.times[here[0]], trajectory.object_poses[here]
    carried = plan.segments[max(segment.plan_segment, 0)]
    rows = _rows(carried.X_WO, len(carried), poses) if segment.plan_segment >= 0 else 0 * times
    part = moving(carried, times, rows, poses, plan.task.problem.fingers.radius)
    forces, holds = part.forces, part.holds
    if segment.plan_segment < 0:
        forces, holds = np.zeros_like(forces), np.ones_like(holds)
    joints = trajectory.positions[here]
    return replace(part, forces=forces, holds=holds, joints=joints, names=[segment.name])


def _rows(X_WO: Matrix, count: int, poses: Matrix) -> Matrix:
    """Returns the row [T], of `count`, of each pose, by its distance along the lattice poses."""
    if len(X_WO) == 1:
        return np.zeros(len(poses))
    lattice, asked = X_WO[:, :3].reshape(len(X_WO), -1), poses[:, :3].reshape(len(poses), -1)
    near = np.linalg.norm(asked[:, None] - lattice[None], axis=2)
    before = near.argmin(axis=1).clip(0, len(X_WO) - 2)
    each = np.arange(len(asked))
    before -= (before > 0) & (near[each, before - 1] < near[each, before + 1])
    step = lattice[before + 1] - lattice[before]
    share = ((asked - lattice[before]) * step).sum(axis=1) / (step**2).sum(axis=1)
    rows: Matrix = (before + share) * count / (len(X_WO) - 1) - 0.5
    return rows.clip(0, count - 1)


class ArmServo:
    """Moves the joints of a robot along a script, step by step.

    Every joint is under position control, with the nominal forces of the fingers fed forward by
    its Jacobian; both together stay within the motors' greatest effort. The joints that move one
    fingertip alone give up their stiffness while it is in force control. As in Servo, places are
    zeroed when the fingers have come to their forces.
    """

    def __init__(self, world: ArmWorld, script: Script) -> None:
        self._world, self._script = world, script
        actuators = world.model.actuator_gainprm[:, 0], world.model.actuator_biasprm[:, 2]
        self._stiffness = actuators[0]
        lead = -actuators[1] / actuators[0]  # so that damping does not lag behind
        steps = np.diff(script.joints, axis=0) / np.diff(script.times)[:, None]
        self._joints = script.joints + lead * np.concatenate([steps, steps[-1:]])
        self._zero = np.zeros(script.joints.shape[1])
        self._own = self._joints_of_one_finger()

    def command(self, i: int) -> None:
        """Sets joint positions and torques for moment i."""
        world, script = self._world, self._script
        is_new = i > 0 and script.stage[i] != script.stage[i - 1]
        if is_new and script.names[script.stage[i - 1]] in LOADING:
            self._zero = world.data.qpos[world.joints] - self._joints[i]
        places = self._joints[i] + self._zero
        torques = np.zeros(len(places))
        for finger in range(world.fingers):
            jacobian = self._jacobian(finger, script.normals[i, finger])
            torques += jacobian.T @ script.forces[i, finger]
            if script.holds[i, finger] == 0:
                free = self._own[finger]
                places[free] = world.data.qpos[world.joints[free]]
        # As a position, not as qfrc_applied, which would exceed the limits of the motors.
        world.data.ctrl[:] = places + torques / self._stiffness

    def _jacobian(self, finger: int, normal: Matrix) -> Matrix:
        """Returns the Jacobian [3, dof] of the contact point of a fingertip, in W."""
        world = self._world
        jacobian = np.zeros((3, world.model.nv))
        body = world.tips[finger]
        point = world.data.xpos[body] + world.radius * normal
        mujoco.mj_jac(world.model, world.data, jacobian, None, point, body)
        return jacobian[:, world.joints]

    def _joints_of_one_finger(self) -> list[Any]:
        """Returns masks [n][dof] of the joints that move this fingertip and no other."""
        mujoco.mj_forward(self._world.model, self._world.data)
        moves = [
            np.abs(self._jacobian(f, np.zeros(3))).max(axis=0) > 1e-9
            for f in range(self._world.fingers)
        ]
        shared = np.sum(moves, axis=0)
        return [mine & (shared == 1) for mine in moves]
