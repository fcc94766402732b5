# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A clasp task in MuJoCo: robot, obstacles, and the object with its holes open."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames
from ..robots import joint_addresses, robot_spec
from ..settings import Clasp, Solver
from . import surface
from .obstacles import add_obstacle

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ...frames import Matrix
    from ...tasks import Task
    from ..variation import Variation

OBJECT, STAND = "graspless_object", "graspless_stand"
_ROBOT, _SKIN = 1, 2  # bits of what collides: obstacles have the robot's


@dataclass(frozen=True)
class World:
    """A model and what the execution must know of it.

    Attributes
    ----------
    model, data : MjModel, MjData
        The object stands, or is held, at `X_WO`.
    joints : array [dof]
        Where the robot's joints stand in qpos.
    body : int
        The object's.
    points_O : array [N, 3]
        Of the object's surface [m].
    X_WO : array [4, 4]
        Where the object is at first: the task's pose, varied.
    """

    model: Any
    data: Any
    joints: NDArray[np.int64]
    body: int
    points_O: Matrix
    X_WO: Matrix
    settings: Clasp

    @property
    def object_pose(self) -> Matrix:
        """X_WO now."""
        return frames.translation(self.data.xpos[self.body]) @ frames.from_quaternion(
            self.data.xquat[self.body]
        )

    @property
    def positions(self) -> Matrix:
        """[dof] of the robot now [rad or m]."""
        q: Matrix = self.data.qpos[self.joints].copy()
        return q

    def let_go(self) -> None:
        """Takes floor and gravity away: what holds the object is the hand alone."""
        self.model.opt.gravity[:] = 0.0
        self.model.geom(STAND).pos[2] -= 100.0
        self.data.eq_active[self.model.equality(OBJECT).id] = 0


def make_world(task: Task, variation: Variation, settings: Clasp) -> World:
    """The world at rest, the robot where the plan begins."""
    problem = task.problem
    spec = robot_spec(problem.robot, task.fields.robot)
    spec.option.timestep = Solver().timestep * variation.timestep
    for geom in spec.geoms:
        geom.contype, geom.conaffinity = _ROBOT, _ROBOT | _SKIN
    for obstacle in problem.obstacles:
        add_obstacle(spec, obstacle, contype=_ROBOT, conaffinity=_ROBOT)
    X_WO = _moved(np.asarray(problem.X_WO), variation)
    points = np.asarray(problem.object.loops.complex.points)
    mass = variation.mass * (task.fields.object.mass or settings.mass)
    _add_object(spec, problem.object.loops.complex, X_WO, mass, variation.friction, settings)
    model = spec.compile()
    data = mujoco.MjData(model)
    joints = joint_addresses(model, problem.robot)
    data.qpos[joints] = data.ctrl[:] = problem.q_start
    mujoco.mj_forward(model, data)
    return World(model, data, joints, model.body(OBJECT).id, points, X_WO, settings)


def _moved(X_WO: Matrix, variation: Variation) -> Matrix:
    """Turned about the vertical through its origin, and moved."""
    moved: Matrix = frames.from_rpy([0.0, 0.0, variation.yaw]) @ X_WO
    moved[:3, 3] = X_WO[:3, 3] + [variation.x, variation.y, 0.0]
    return moved


def _add_object(
    spec: Any, complex_: Any, X_WO: Matrix, mass: float, friction: float, settings: Clasp
) -> None:
    """A free body with the skin of K_d, on feet if it can stand, else held."""
    points = np.asarray(complex_.points)
    body = spec.worldbody.add_body(name=OBJECT, pos=X_WO[:3, 3], quat=frames.to_quaternion(X_WO))
    body.add_freejoint(name=OBJECT)
    body.explicitinertial, body.mass, body.ipos = True, mass, points.mean(axis=0)
    moments = mass * surface.inertia(points)
    body.fullinertia = moments[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    spec.add_flex(
        name=OBJECT,
        dim=2,
        radius=settings.skin,
        vertbody=[OBJECT],
        vert=points.ravel().tolist(),
        elem=surface.skin(complex_).ravel().tolist(),
        selfcollide=mujoco.mjtFlexSelf.mjFLEXSELF_NONE,
        contype=_SKIN,
        conaffinity=_SKIN,
        condim=3,
        friction=[friction * settings.friction, 0.005, 0.0001],
        solref=[settings.stiffness_time, 1.0],
        priority=1,  # its friction is that of the pair
    )
    held = spec.add_equality(name=OBJECT, type=mujoco.mjtEq.mjEQ_WELD)
    held.name1, held.name2 = OBJECT, "world"
    held.objtype = mujoco.mjtObj.mjOBJ_BODY
    standing = surface.feet(points @ X_WO[:3, :3].T + X_WO[:3, 3], settings.foot_depth)
    held.active = standing is None
    _add_stand(spec, body, X_WO, standing, friction * settings.stand_friction)


def _add_stand(
    spec: Any, body: Any, X_WO: Matrix, standing: Matrix | None, friction: float
) -> None:
    """A level plane under small feet. Nothing else touches it: the planner knows of no floor."""
    radius = 0.002  # of a foot [m]: a point's contact
    height = 0.0 if standing is None else standing[:, 2].min()
    spec.worldbody.add_geom(
        name=STAND,
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        size=[1, 1, 1],
        pos=[0, 0, height],
        contype=0,
        conaffinity=0,
    )
    for i, p_W in enumerate(() if standing is None else standing):
        p_O = X_WO[:3, :3].T @ (np.array([*p_W[:2], height + radius]) - X_WO[:3, 3])
        name = f"{OBJECT}_{i}"
        size = [radius, 0, 0]
        body.add_geom(name=name, size=size, pos=p_O, contype=0, conaffinity=0, mass=0)
        spec.add_pair(
            geomname1=name,
            geomname2=STAND,
            condim=3,
            friction=[friction, friction, 0.005, 0.0001, 0.0001],
        )
