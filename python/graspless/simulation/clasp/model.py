# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""World of a clasp task in MuJoCo: robot, obstacles, and the object with open holes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames
from ..obstacles import add_obstacle, plain
from ..robots import compiled, joint_addresses, robot_spec, set_positions
from ..settings import Clasp, Solver
from .object import OBJECT, OBJECT_BIT, STAND, add_object

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from numpy.typing import NDArray

    from ... import geometry
    from ...frames import Matrix
    from ...tasks import Task
    from ..variation import Variation

_ROBOT_BIT = 1  # collision bit of robot and obstacles


@dataclass(frozen=True)
class World:
    """A model, and the indices that the execution needs.

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
        """Present pose X_WO."""
        return frames.translation(self.data.xpos[self.body]) @ frames.from_quaternion(
            self.data.xquat[self.body]
        )

    @property
    def positions(self) -> Matrix:
        """Present configuration [dof] of the robot [rad or m]."""
        q: Matrix = self.data.qpos[self.joints].copy()
        return q

    def touched(self) -> tuple[str, str] | None:
        """Returns an obstacle that the robot touches, and what touches it, by name, or None.

        Nothing else can touch fixed geoms.
        """
        contact, model = self.data.contact, self.model
        geoms, skins = contact.geom, contact.flex  # -1 where a contact is not of one
        # The object's skin is the one that moves; those of meshes are fixed.
        own = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_FLEX, OBJECT)
        fixed = (geoms >= 0) & (model.geom_bodyid[geoms] == 0) | (skins >= 0) & (skins != own)
        found = np.flatnonzero(fixed.any(axis=1) & (contact.dist < 0))
        if not len(found):
            return None
        k = found[0]
        first, second = (
            self._name(geoms[k, side], skins[k, side]) for side in np.argsort(~fixed[k])
        )
        return first, second

    def _name(self, geom: int, skin: int) -> str:
        """Returns the name of the obstacle or link that a geom or, without one, a skin is of."""
        if geom < 0:
            return plain(mujoco.mj_id2name(self.model, mujoco.mjtObj.mjOBJ_FLEX, int(skin)))
        body = self.model.body(self.model.geom_bodyid[geom])
        return str(body.name) if body.id else plain(self.model.geom(geom).name)

    def let_go(self) -> None:
        """Removes floor and gravity, so that the hand alone holds the object."""
        self.model.opt.gravity[:] = 0.0
        self.data.mocap_pos[self.model.body(STAND).mocapid[0], 2] -= 100.0
        self.data.eq_active[self.model.equality(OBJECT).id] = 0


def make_world(
    task: Task,
    variation: Variation,
    settings: Clasp,
    solids: Sequence[geometry.PlacedShape] | None = None,
    excluded: Iterable[tuple[int, int]] | None = None,
) -> World:
    """Makes the world at rest, with the robot at the start of the plan.

    Parameters
    ----------
    task : Task
        Of kind clasp.
    variation : Variation
        What differs from it.
    settings : Clasp
        Of the object and what touches it.
    solids : list of PlacedShape, optional
        In O, what the object's cloud was taken from: touched instead of the cloud's skin.
    excluded : pairs of int, optional
        Links of the robot that do not collide with each other; as in `robot_spec` by default.
    """
    problem = task.problem
    spec = robot_spec(problem.robot, task.fields.robot, excluded=excluded)
    spec.option.timestep = Solver().timestep * variation.timestep
    for geom in spec.geoms:
        geom.contype, geom.conaffinity = _ROBOT_BIT, _ROBOT_BIT | OBJECT_BIT
    for obstacle in problem.obstacles:
        skin = settings.obstacle_skin
        add_obstacle(spec, obstacle, skin, contype=_ROBOT_BIT, conaffinity=_ROBOT_BIT)
    X_WO = _moved(np.asarray(problem.X_WO), variation)
    surface = problem.object.loops.surface
    mass = task.fields.object.mass or settings.mass
    add_object(spec, surface, solids, X_WO, mass, variation, settings)
    model = compiled(spec)
    data = mujoco.MjData(model)
    joints = joint_addresses(model, problem.robot)
    set_positions(model, data, problem.robot, problem.q_start)
    points = np.asarray(surface.points)
    return World(model, data, joints, model.body(OBJECT).id, points, X_WO, settings)


def _moved(X_WO: Matrix, variation: Variation) -> Matrix:
    """Returns the pose, turned about the vertical through its origin and shifted."""
    moved: Matrix = frames.from_rpy([0.0, 0.0, variation.yaw]) @ X_WO
    moved[:3, 3] = X_WO[:3, 3] + [variation.x, variation.y, 0.0]
    return moved
