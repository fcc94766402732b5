# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Execution of a script, with observations of the object."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Protocol

import mujoco
import numpy as np

from ... import frames, limits
from .world import FINGER, OBJECT, OBSTACLE, PLANE

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ...frames import Matrix
    from .script import Script
    from .world import World

EVERY = 10  # steps between looks


@dataclass
class Log:
    """Observations every few steps: K samples, n fingers.

    Attributes
    ----------
    moments : list of int
        Of the script.
    places : list of array [7]
        Of the object.
    centers : list of array [n, 3]
        Of the fingertips [m].
    joints : list of array [dof]
        Of the arm [rad or m].
    errors : list of float
        How far the object's worst corner is from where it is to be [m].
    floor : list of float
        Normal force of all planes on the object [N].
    pressed : list of array [n]
        Normal forces of the fingers [N].
    hits : list of float
        How deep something is in what it is not to touch, see `hit_depth` [m].
    """

    moments: list[int] = field(default_factory=list)
    places: list[Matrix] = field(default_factory=list)
    centers: list[Matrix] = field(default_factory=list)
    joints: list[Matrix] = field(default_factory=list)
    errors: list[float] = field(default_factory=list)
    floor: list[float] = field(default_factory=list)
    pressed: list[Matrix] = field(default_factory=list)
    hits: list[float] = field(default_factory=list)


class Commands(Protocol):
    """Controller of the fingers."""

    def command(self, i: int) -> None:
        """Sets the engine's controls for moment i."""


def execute(world: World, script: Script, servo: Commands) -> Log:
    """Executes a script, one moment per step; stops when the object is lost.

    Parameters
    ----------
    world : World
        The object and the fingers are put to where the script begins.
    script : Script
        At even times, a time step of the world's apart.
    servo : Commands
        Of this world and script.
    """
    log = Log()
    for _ in steps(world, script, servo, log):
        pass
    return log


def steps(world: World, script: Script, servo: Commands, log: Log) -> Iterator[str]:
    """Does what `execute` does, and logs it; yields the stage before each physics step."""
    slides = None
    size = float(np.ptp(world.hull, axis=0).max())
    for i in range(len(script)):
        if script.slides[i] != slides:
            slides = script.slides[i]
            world.soften(slides=bool(slides))
        servo.command(i)
        yield script.names[script.stage[i]]
        limits.poll()
        mujoco.mj_step(world.model, world.data)
        if i % EVERY == 0:
            look(world, script, i, log)
            if not log.errors[-1] < size:
                break


def look(world: World, script: Script, i: int, log: Log) -> None:
    """Adds the present state to the log, as moment i."""
    log.moments.append(i)
    log.places.append(world.object_qpos.copy())
    log.centers.append(world.centers.copy())
    log.joints.append(world.joint_positions.copy())
    log.errors.append(corner_error(world.hull, world.object_qpos, script.places[i]))
    floor, pressed = contact_forces(world)
    log.floor.append(floor)
    log.pressed.append(pressed)
    log.hits.append(hit_depth(world))


def corner_error(hull: Matrix, place: Matrix, wanted: Matrix) -> float:
    """Returns the largest distance of a corner from its planned position [m]; poses are [7]."""
    X_WO, X_WO_wanted = frames.from_row(place), frames.from_row(wanted)
    off = hull @ (X_WO - X_WO_wanted)[:3, :3].T + (X_WO - X_WO_wanted)[:3, 3]
    return float(np.linalg.norm(off, axis=1).max())


def contact_forces(world: World) -> tuple[float, Matrix]:
    """Returns normal forces on the object: of all planes together, and of each finger [N]."""
    planes, fingers, force = 0.0, np.zeros(world.fingers), np.zeros(6)
    for k, geoms in enumerate(world.data.contact.geom):
        kinds = set(world.kinds[geoms])
        if kinds not in ({OBJECT, PLANE}, {OBJECT, FINGER}):
            continue
        mujoco.mj_contactForce(world.model, world.data, k, force)
        if PLANE in kinds:
            planes += force[0]
        else:
            fingers[max(world.finger_of_geom.get(geom, -1) for geom in geoms)] += force[0]
    return planes, fingers


def hit_depth(world: World) -> float:
    """Returns the depth of the deepest forbidden contact, or 0 [m].

    That is anything in an obstacle, the robot in a plane, and what is no fingertip in the object.
    """
    touching = world.data.contact.dist < 0
    kinds = world.kinds[world.data.contact.geom[touching]]
    of_object, of_plane = (kinds == OBJECT).any(axis=1), (kinds == PLANE).any(axis=1)
    of_finger = (kinds == FINGER).any(axis=1)
    meant = np.where(of_object, of_plane | of_finger, ~of_plane) & (kinds != OBSTACLE).all(axis=1)
    return float(np.max(-world.data.contact.dist[touching][~meant], initial=0.0))
