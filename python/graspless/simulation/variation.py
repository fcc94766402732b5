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
    """

    friction: float = 1.0
    support_friction: float = 1.0
    mass: float = 1.0
    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    timestep: float = 1.0

    @property
    def is_nominal(self) -> bool:
        """True if nothing differs from the model."""
        return self == Variation()

    def as_dict(self) -> dict[str, float]:
        """Returns all values by name."""
        return {field.name: float(getattr(self, field.name)) for field in fields(self)}


def draw(random: Generator, spread: Spread | None = None) -> Variation:
    """Draws a variation uniformly within the spread, the position within a disc."""
    spread = spread or Spread()
    friction, mass, timestep, turn = random.uniform(-1, 1, 4)
    far, way = np.sqrt(random.uniform()) * spread.position, random.uniform(-np.pi, np.pi)
    support = random.uniform(-1, 1)
    return Variation(
        friction=1 + spread.friction * friction,
        support_friction=1 + spread.friction * support,
        mass=1 + spread.mass * mass,
        x=float(far * np.cos(way)),
        y=float(far * np.sin(way)),
        yaw=spread.angle * turn,
        timestep=1 + spread.timestep * timestep,
    )


def variations(trials: int, seed: int, spread: Spread | None = None) -> list[Variation]:
    """Returns one variation per trial; trial k does not depend on the number of trials."""
    drawn = [
        draw(np.random.default_rng([seed, trial]), spread) for trial in range(1, max(trials, 1))
    ]
    return [Variation(), *drawn]
