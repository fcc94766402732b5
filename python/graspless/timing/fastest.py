# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fastest motion along a path from rest to rest, by toppra, with a check of its result."""

from __future__ import annotations

import logging
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from toppra.algorithm import TOPPRA
from toppra.constraint import (
    JointAccelerationConstraint,
    JointVelocityConstraint,
    LinearConstraint,
)
from toppra.interpolator import AbstractGeometricPath
from toppra.parametrizer import ParametrizeConstAccel

from ..errors import TaskError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..frames import Matrix
    from .path import Path

    Pace = Callable[[Matrix, Matrix], Matrix]

logging.getLogger("toppra").setLevel(logging.CRITICAL)  # graspless reports failures itself

CHECKS = 4  # moments between two grid points at which limits are checked
FINAL_CHECKS = 24
REFINEMENTS = 4  # maximum number of refinements of the grid
MARGIN = 1e-4  # for excess between the checked moments
ACCEPTED = 0.01  # relative excess above which the grid is refined

_NO_MOTION = (
    "toppra found no motion along a path within max_velocity, max_acceleration and contact_speed: "
    "they should be closer to their defaults"
)


@dataclass(frozen=True)
class Limits:
    """Limits along a path of n coordinates.

    Attributes
    ----------
    velocity, acceleration : array [n]
        Limits of each coordinate; inf for none.
    paces : list of callable
        Functions of coordinates [N, n] and their derivatives [N, n] along the path. Each returns
        the least time per unit of the path [N].
    """

    velocity: Matrix
    acceleration: Matrix
    paces: Sequence[Pace] = ()

    def pace(self, path: Path, s: Matrix) -> Matrix:
        """Returns the slowest of the paces [N]."""
        slowest = np.zeros(len(s))
        if self.paces:
            q, dq = path(s), path(s, 1)
            for pace in self.paces:
                slowest = np.maximum(slowest, pace(q, dq))
        return slowest


@dataclass(frozen=True)
class Motion:
    """A timed path.

    The tolerances of toppra are absolute, so the path is scaled to length 1 and to a duration of
    about 1.
    """

    path: Path
    _arc: Any
    _unit: float

    @property
    def duration(self) -> float:
        """Duration [s]."""
        return float(self._arc.duration) * self._unit

    def at(self, t: Matrix) -> tuple[Matrix, Matrix, Matrix]:
        """Returns position, speed and acceleration along the path [N] at times `t` [N] [s]."""
        scaled = np.clip(t / self._unit, 0.0, self._arc.duration)
        s, ds, dds = (self._arc(scaled, order)[:, 0] * self.path.length for order in range(3))
        s = np.where(scaled < self._arc.duration, s, self.path.length)  # exactly, at the end
        return s.clip(0.0, self.path.length), ds / self._unit, dds / self._unit**2

    def coordinates(self, t: Matrix) -> tuple[Matrix, Matrix, Matrix]:
        """Returns coordinates, velocities and accelerations [N, n] at times `t` [N] [s]."""
        s, ds, dds = self.at(t)
        dq = self.path(s, 1)
        accelerations = self.path(s, 2) * ds[:, None] ** 2 + dq * dds[:, None]
        return self.path(s), dq * ds[:, None], accelerations


def fastest(path: Path, limits: Limits) -> Motion:
    """Returns the fastest motion along `path` whose limits hold at every moment.

    toppra evaluates limits at the points of a grid. The grid is refined where they are exceeded
    between two points. The remaining excess slows down the whole motion.
    """
    grid = path.grid() / path.length
    motion, excess = _solved(path, limits, grid)
    for _ in range(REFINEMENTS):
        if excess.max() <= ACCEPTED:
            break
        broken = np.flatnonzero(excess > ACCEPTED / 2)
        grid = np.sort(np.append(grid, (grid[broken] + grid[broken + 1]) / 2))
        motion, excess = _solved(path, limits, grid)
    without_paces = replace(limits, paces=())  # they are slow to ask, and smoother
    most = max(excess.max(), _excess(motion, without_paces, FINAL_CHECKS).max())
    slower = 1 + MARGIN + 1.1 * float(most)
    return Motion(path, motion._arc, motion._unit * slower)


def _solved(path: Path, limits: Limits, grid: Matrix) -> tuple[Motion, Matrix]:
    """Returns the motion of toppra, and its relative excess between points of the grid [M - 1]."""
    unit = _unit_of_time(path, limits)
    constraints = [
        JointVelocityConstraint(np.minimum(limits.velocity * unit, 1e6)),
        JointAccelerationConstraint(np.minimum(limits.acceleration * unit**2, 1e6)),
        _Pace(limits, unit),
    ]
    result = TOPPRA(constraints, _Given(path), gridpoints=grid).compute_parameterization(0, 0)
    speeds = result[1]
    if speeds is None or not np.isfinite(speeds).all():
        raise TaskError(_NO_MOTION)
    with np.errstate(all="ignore"):  # speeds too small to divide by are reported below
        motion = Motion(path, ParametrizeConstAccel(_Arc(), grid, np.maximum(speeds, 0.0)), unit)
    if not np.isfinite(motion.duration):
        raise TaskError(_NO_MOTION)
    return motion, _excess(motion, limits)


def _unit_of_time(path: Path, limits: Limits) -> float:
    """Returns the time that the path takes from rest at its maximum accelerations [s]."""
    slopes = np.abs(path(np.linspace(0.0, path.length, 50), 1)).max(axis=0)
    return float(np.sqrt((path.length * slopes / limits.acceleration).max()))


def _excess(motion: Motion, limits: Limits, checks: int = CHECKS) -> Matrix:
    """Returns the relative excess of a motion between points of its grid; 0.01 is one percent."""
    times = np.asarray(motion._arc._ts) * motion._unit
    parts = np.linspace(1e-6, 1 - 1e-6, checks + 2)
    t = (times[:-1, None] + np.diff(times)[:, None] * parts).ravel()
    s, ds, _ = motion.at(t)
    _, velocities, accelerations = motion.coordinates(t)
    velocity = (np.abs(velocities) / limits.velocity).max(axis=1)
    acceleration = (np.abs(accelerations) / limits.acceleration).max(axis=1)
    pace = ds * limits.pace(motion.path, s)
    most = np.max([velocity, np.sqrt(acceleration), pace, np.ones(len(t))], axis=0)
    excess: Matrix = most.reshape(-1, len(parts)).max(axis=1) - 1
    return excess


class _Given(AbstractGeometricPath):  # type: ignore[misc]
    """A path with the interface of toppra, scaled to length 1."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __call__(self, path_positions: Any, order: int = 0) -> Matrix:
        length = self.path.length
        return self.path(path_positions * length, order) * length**order

    @property
    def dof(self) -> int:
        return int(self.path.curve.c.shape[2])

    @property
    def path_interval(self) -> Matrix:
        return np.array([0.0, 1.0])


class _Arc(AbstractGeometricPath):  # type: ignore[misc]
    """Path parameter as a path of one coordinate."""

    def __call__(self, path_positions: Any, order: int = 0) -> Matrix:
        s = np.asarray(path_positions, dtype=float).reshape(-1, 1)
        return s if order == 0 else np.full_like(s, float(order == 1))

    @property
    def dof(self) -> int:
        return 1

    @property
    def path_interval(self) -> Matrix:
        return np.array([0.0, 1.0])


class _Pace(LinearConstraint):  # type: ignore[misc]
    """Paces as bounds on the squared speed along the path."""

    def __init__(self, limits: Limits, unit: float) -> None:
        super().__init__()
        self.limits = limits
        self.unit = unit
        self.dof = len(limits.velocity)

    def compute_constraint_params(self, path: Any, gridpoints: Matrix) -> tuple[Any, ...]:
        length = path.path.length
        pace = self.limits.pace(path.path, gridpoints * length) * length / self.unit
        slowest = np.clip(pace, 1e-4, 1e100)  # whose square is a number
        bounds = np.stack([np.zeros(len(pace)), 1 / slowest**2], axis=1)
        return None, None, None, None, None, None, bounds
