# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fingertips under position or force control."""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np

if TYPE_CHECKING:
    from ...frames import Matrix
    from .script import Script
    from .world import World


class Servo:
    """Moves the fingertips of a world as a script says, moment by moment.

    Along the surface every finger is a spring about its place, with the nominal force fed forward.
    Along the normal so is one in position control, within its greatest force; one in force control
    pushes with its force and is damped. Fingertips turn with the object's planned pose: a contact
    that does not roll.

    Parameters
    ----------
    world : World
    script : Script
        A moment each step.
    limit : float
        Greatest normal force [N].
    offsets : array [n, 3]
        By how much the fingers are beside where they are told to be [m].
    feeds : bool
        Whether nominal forces are fed forward.
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
        n = world.fingers
        self._world, self._script, self._limit = world, script, limit
        self._centers = script.centers + (np.zeros((n, 3)) if offsets is None else offsets)
        normal_forces = np.einsum("tni,tni->tn", script.forces, script.normals)
        along = script.forces - normal_forces[..., None] * script.normals
        if not feeds:
            along, normal_forces = 0 * along, normal_forces * (1 - script.holds)
        damping = world.model.dof_damping[6]
        self._along = along + damping * script.velocities()
        self._normal_forces = normal_forces
        radius = world.model.geom_size[-1, 0]
        self._turning = world.settings.turning * world.settings.stiffness * radius**2
        self._error = np.zeros(3)

    def command(self, i: int) -> None:
        """Sets the forces of the fingers for moment i."""
        world, script = self._world, self._script
        stiffness = world.settings.stiffness
        normals = script.normals[i]
        pull = stiffness * (self._centers[i] - world.centers)
        along_normal = (pull * normals).sum(axis=1)
        held = np.clip(along_normal + self._normal_forces[i], -self._limit, self._limit)
        pushed = np.where(script.holds[i] > 0, held, self._normal_forces[i])
        force = pull + self._along[i] + (pushed - along_normal)[:, None] * normals
        applied = world.data.qfrc_applied[6:].reshape(-1, 6)
        applied[:, :3] = force
        places = world.data.qpos[7:].reshape(-1, 7)
        for finger in range(world.fingers):
            mujoco.mju_subQuat(self._error, script.places[i, 3:], places[finger, 3:])
            applied[finger, 3:] = self._turning * self._error
