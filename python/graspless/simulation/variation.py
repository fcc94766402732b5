# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Variations of the model of a plan from trial to trial."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

import numpy as np

from .settings import Spread

if TYPE_CHECKING:
    from numpy.random import Generator


@dataclass(frozen=True)
class Variation:
    """Factors and offsets of a trial; the default is nominal.

    Attributes
    ----------
    friction : float
        Factor of the friction coefficients of contacts with the robot.
    support_friction : float
        Factor of the friction coefficients between object and support. The ratio of both factors
        decides how far an object turns with the finger that slides it.
    mass : float
        Factor of the object's mass and inertia.
    x, y : float
        Offset of the object from its position in the task [m].
    yaw : float
        Rotation of the object from its orientation in the task [rad].
    timestep : float
        Factor of the physics engine's time step.
    thickness : float
        Factor of the object's thickness.
    table : float
        Offset of support and object along the support's normal [m].
    com_x, com_y : float
        Offset of the centre of mass in the object's frame [m].
    flexure_length, flexure_stiffness : float
        Factors of the fingers' flexures.
    kick_x, kick_y, kick_yaw : float
        Displacement of the object half way through a slide, as x, y and yaw [m, m, rad].
    """

    friction: float = 1.0
    support_friction: float = 1.0
    mass: float = 1.0
    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    timestep: float = 1.0
    thickness: float = 1.0
    table: float = 0.0
    com_x: float = 0.0
    com_y: float = 0.0
    flexure_length: float = 1.0
    flexure_stiffness: float = 1.0
    kick_x: float = 0.0
    kick_y: float = 0.0
    kick_yaw: float = 0.0

    @property
    def is_nominal(self) -> bool:
        """True if nothing differs from the model."""
        return self == Variation()

    def as_dict(self) -> dict[str, float]:
        """Returns all values by name."""
        return {field.name: float(getattr(self, field.name)) for field in fields(self)}


def draw(random: Generator, spread: Spread | None = None) -> Variation:
    """Draws a variation uniformly within the spread, positions within a disc."""
    spread = spread or Spread()
    friction, mass, timestep, turn = random.uniform(-1, 1, 4)
    x, y = in_disc(random, spread.position)
    support = random.uniform(-1, 1)
    thickness, table, length, stiffness = random.uniform(-1, 1, 4)
    com_x, com_y = in_disc(random, spread.com)
    return Variation(
        friction=1 + spread.friction * friction,
        support_friction=1 + spread.friction * support,
        mass=1 + spread.mass * mass,
        x=x,
        y=y,
        yaw=spread.angle * turn,
        timestep=1 + spread.timestep * timestep,
        thickness=1 + spread.thickness * thickness,
        table=spread.table * table,
        com_x=com_x,
        com_y=com_y,
        flexure_length=1 + spread.flexure * length,
        flexure_stiffness=1 + spread.flexure * stiffness,
    )


def in_disc(random: Generator, radius: float) -> tuple[float, float]:
    """Draws a point uniformly from a disc about 0 [m]."""
    far, way = np.sqrt(random.uniform()) * radius, random.uniform(-np.pi, np.pi)
    return float(far * np.cos(way)), float(far * np.sin(way))


def variations(trials: int, seed: int, spread: Spread | None = None) -> list[Variation]:
    """Returns one variation per trial; trial k does not depend on the number of trials.

    Parameters
    ----------
    trials : int
        Number of trials. The first variation is nominal.
    seed : int
        Seed of the others.
    spread : Spread, optional
        Half widths of the variations; by default `Spread()`.
    """
    drawn = [
        draw(np.random.default_rng([seed, trial]), spread) for trial in range(1, max(trials, 1))
    ]
    return [Variation(), *drawn]
