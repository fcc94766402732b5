# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The fastest motion along a path, from rest to rest: toppra, and a check of what it gives."""

from __future__ import annotations

import logging
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import TaskError

try:
    from toppra.algorithm import TOPPRA
    from toppra.constraint import (
        JointAccelerationConstraint,
        JointVelocityConstraint,
        LinearConstraint,
    )
    from toppra.interpolator import AbstractGeometricPath
    from toppra.parametrizer import ParametrizeConstAccel
except ImportError as error:
    raise TaskError(f"needs {error.name}: pip install 'graspless[timing]'") from None

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..frames import Matrix
    from .path import Path

    Pace = Callable[[Matrix, Matrix], Matrix]

logging.getLogger("toppra").setLevel(logging.CRITICAL)  # what fails is told by us

CHECKS = 4  # moments between two grid points at which the limits are looked at again


@dataclass(frozen=True)
class Limits:
    """What holds along a path of n coordinates.

    Attributes
    ----------
    velocity, acceleration : array [n]
        Of each coordinate; inf where there is none.
    paces : list of callable
        Of coordinates [N, n] and their derivatives [N, n] along the path: [N] the seconds that a
        unit of the path takes at least.
    """

    velocity: Matrix
    acceleration: Matrix
    paces: Sequence[Pace] = ()

    def pace(self, path: Path, s: Matrix) -> Matrix:
        """[N] the slowest of the paces."""
        slowest = np.zeros(len(s))
        if self.paces:
            q, dq = path(s), path(s, 1)
            for pace in self.paces:
                slowest = np.maximum(slowest, pace(q, dq))
        return slowest


@dataclass(frozen=True)
class Motion:
    """A path in time.

    Attributes
    ----------
    duration : float
        [s].
    """

    path: Path
    _arc: Any
    _slowed: float

    @property
    def duration(self) -> float:
        """[s]."""
        return float(self._arc.duration) * self._slowed

    def at(self, t: Matrix) -> tuple[Matrix, Matrix, Matrix]:
        """[N] where on the path, its speed and its acceleration at `t` [N] [s]."""
        scaled = np.clip(t / self._slowed, 0.0, self._arc.duration)
        s, ds, dds = (self._arc(scaled, order)[:, 0] for order in range(3))
        return s.clip(0.0, self.path.length), ds / self._slowed, dds / self._slowed**2

    def coordinates(self, t: Matrix) -> tuple[Matrix, Matrix, Matrix]:
        """[N, n] coordinates, velocities and accelerations at `t` [N] [s]."""
        s, ds, dds = self.at(t)
        dq = self.path(s, 1)
        accelerations = self.path(s, 2) * ds[:, None] ** 2 + dq * dds[:, None]
        return self.path(s), dq * ds[:, None], accelerations


def fastest(path: Path, limits: Limits) -> Motion:
    """The fastest motion along `path`; its limits hold at every moment.

    toppra looks at them at the points of a grid; between these they are broken by some 1e-3 of
    their size, by which the whole motion is slowed down.
    """
    grid = path.grid()
    given = _Given(path)
    constraints = [
        JointVelocityConstraint(np.minimum(limits.velocity, 1e6)),
        JointAccelerationConstraint(np.minimum(limits.acceleration, 1e6)),
        _Pace(limits),
    ]
    result = TOPPRA(constraints, given, gridpoints=grid).compute_parameterization(0, 0)
    speeds = result[1]
    if speeds is None or not np.isfinite(speeds).all():
        raise RuntimeError("toppra found no parametrisation of a path that comes to rest")
    arc = ParametrizeConstAccel(_Arc(path.length), grid, np.maximum(speeds, 0.0))
    motion = Motion(path, arc, 1.0)
    return Motion(path, arc, _excess(motion, limits))


def _excess(motion: Motion, limits: Limits) -> float:
    """By how much a motion is too fast, at least 1."""
    times = np.asarray(motion._arc._ts)
    parts = np.linspace(1e-6, 1 - 1e-6, CHECKS + 2)
    t = (times[:-1, None] + np.diff(times)[:, None] * parts).ravel()
    s, ds, _ = motion.at(t)
    _, velocities, accelerations = motion.coordinates(t)
    velocity = (np.abs(velocities) / limits.velocity).max()
    acceleration = (np.abs(accelerations) / limits.acceleration).max()
    pace = (ds * limits.pace(motion.path, s)).max()
    excess = max(0.0, velocity - 1, np.sqrt(acceleration) - 1, pace - 1)
    return 1 + 1.05 * float(excess) + 1e-9  # what is between these moments is smooth


class _Given(AbstractGeometricPath):  # type: ignore[misc]
    """Our path as toppra asks for one."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __call__(self, path_positions: Any, order: int = 0) -> Matrix:
        return self.path(path_positions, order)

    @property
    def dof(self) -> int:
        return int(self.path.curve.c.shape[2])

    @property
    def path_interval(self) -> Matrix:
        return np.array([0.0, self.path.length])


class _Arc(AbstractGeometricPath):  # type: ignore[misc]
    """The parameter itself as a path of one coordinate."""

    def __init__(self, length: float) -> None:
        self.length = length

    def __call__(self, path_positions: Any, order: int = 0) -> Matrix:
        s = np.asarray(path_positions, dtype=float).reshape(-1, 1)
        return s if order == 0 else np.full_like(s, float(order == 1))

    @property
    def dof(self) -> int:
        return 1

    @property
    def path_interval(self) -> Matrix:
        return np.array([0.0, self.length])


class _Pace(LinearConstraint):  # type: ignore[misc]
    """Paces as bounds on the squared speed along the path."""

    def __init__(self, limits: Limits) -> None:
        super().__init__()
        self.limits = limits
        self.dof = len(limits.velocity)

    def compute_constraint_params(self, path: Any, gridpoints: Matrix) -> tuple[Any, ...]:
        pace = np.maximum(self.limits.pace(path.path, gridpoints), 1e-6)
        bounds = np.stack([np.zeros(len(pace)), 1 / pace**2], axis=1)
        return None, None, None, None, None, None, bounds
