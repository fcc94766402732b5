# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fingertips under position or force control."""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np
from scipy.spatial.transform import Rotation

if TYPE_CHECKING:
    from ...frames import Matrix
    from .script import Script
    from .world import World

LOADING = ("load", "settle")


class Servo:
    """Moves the fingertips of a world along a script, step by step.

    Along the surface every finger is a spring about its place, with the nominal force fed forward.
    Along the normal so is one in position control, within its greatest force; one in force control
    pushes with its force and is damped. Fingertips turn with the object's planned pose: a contact
    that does not roll.

    A place is zeroed when the fingers have come to their forces, and along the normal when one
    goes from force to position control: the force is then the nominal one. Without it the contact's
    own softness, a tenth of a millimetre, would take a newton from the force.

    Parameters
    ----------
    world : World
    script : Script
        A moment each step.
    limit : float
        Greatest normal force [N].
    offsets : array [n, 3]
        By how much the fingers are beside where they are told to be, see Script.drift [m].
    feeds : bool
        True to feed nominal forces forward.
    """

    def __init__(
        self,
        world: World,
        script: Script,
        limit: float,
        offsets: Matrix | None = None,
        *,
        feeds: bool = True,
    ) -> None:
        self._world, self._script, self._limit = world, script, limit
        beside = np.zeros((world.fingers, 3)) if offsets is None else offsets
        self._centers = script.centers + script.drift[:, None, None] * beside
        normal_forces = np.einsum("tni,tni->tn", script.forces, script.normals)
        along = script.forces - normal_forces[..., None] * script.normals
        if not feeds:
            along, normal_forces = 0 * along, normal_forces * (1 - script.holds)
        self._along = along + world.model.dof_damping[6] * script.velocities()
        self._normal_forces = normal_forces
        self._turning = world.settings.turning * world.settings.stiffness * world.radius**2
        self._R_WO = Rotation.from_quat(script.places[:, [4, 5, 6, 3]]).as_matrix()
        is_new = np.diff(script.stage) != 0
        starts = (np.diff(script.holds, axis=0) > 0).any(axis=1)
        self._may_zero = np.concatenate([[False], is_new | starts])
        self._error = np.zeros(3)
        self._zero_O = np.zeros((world.fingers, 3))

    @property
    def zero_O(self) -> Matrix:
        """Offsets of the finger positions [n, 3], turning with the object [m]."""
        zero_O: Matrix = self._zero_O.copy()
        return zero_O

    @zero_O.setter
    def zero_O(self, value: Matrix) -> None:
        self._zero_O = value.copy()

    def commanded(self, i: int) -> Matrix:
        """Returns the places [n, 3] of the fingertips that moment i asks for [m]."""
        places: Matrix = self._centers[i] + self._zero_O @ self._R_WO[i].T
        return places

    def command(self, i: int) -> None:
        """Sets the forces of the fingers for moment i."""
        world, script = self._world, self._script
        stiffness, normals = world.settings.stiffness, script.normals[i]
        if self._may_zero[i]:
            self._zero(i, self._R_WO[i])
        qpos = world.data.qpos[7:].reshape(-1, 7)
        pull = stiffness * (self.commanded(i) - qpos[:, :3])
        along_normal = (pull * normals).sum(axis=1)
        held = (along_normal + self._normal_forces[i]).clip(-self._limit, self._limit)
        pushed = np.where(script.holds[i] > 0, held, self._normal_forces[i])
        force = pull + self._along[i] + (pushed - along_normal)[:, None] * normals
        applied = world.data.qfrc_applied[6:].reshape(-1, 6)
        applied[:, :3] = force
        for finger in range(world.fingers):
            mujoco.mju_subQuat(self._error, script.places[i, 3:], qpos[finger, 3:])
            applied[finger, 3:] = self._turning * self._error

    def zero(self, i: int) -> None:
        """Takes the present positions of all fingers as their commands of moment i."""
        off = (self._world.centers - self._centers[i]) @ self._R_WO[i]
        self._zero_O = np.where(self._script.forces[i].any(axis=1)[:, None], off, 0.0)

    def _zero(self, i: int, R_WO: Matrix) -> None:
        """Takes the present positions of fingers as their commands, when it is time to."""
        script = self._script
        is_new = script.stage[i] != script.stage[i - 1]
        starts = script.holds[i] > script.holds[i - 1]
        off = (self._world.centers - self._centers[i]) @ R_WO
        if is_new and script.names[script.stage[i - 1]] in LOADING:
            self._zero_O = off
        elif not is_new:
            normals_O = script.normals[i] @ R_WO
            more = ((off - self._zero_O) * normals_O).sum(axis=1) * starts
            self._zero_O = self._zero_O + more[:, None] * normals_O
        if is_new:  # a finger off the object follows its command
            self._zero_O[~script.forces[i].any(axis=1)] = 0
