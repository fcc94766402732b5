# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fastest motion along a path from rest to rest, by toppra, smoothed and checked.

toppra knows no jerk: its accelerations jump. Its motion s(t) along the path is therefore averaged
over a window of T = 2 a / j, the time in which an acceleration a changes its sign at a jerk j. The
path stays the same, and the motion takes T longer. On a straight path the result is the fastest
motion within a and j. At a bend the average is faster than toppra's motion. Speed limits of bends
therefore hold from T / 2 before to T / 2 after them.
"""

from __future__ import annotations

import contextlib
import logging
from typing import TYPE_CHECKING, Any

import numpy as np

from .later import imported_later

with imported_later("matplotlib", "matplotlib.pyplot"):  # to plot, which nobody asks for here
    from toppra.algorithm import TOPPRA
    from toppra.constraint import LinearConstraint
    from toppra.constraint.linear_constraint import canlinear_colloc_to_interpolate
    from toppra.interpolator import AbstractGeometricPath

from .limits import bounds
from .motion import Motion, profile_of
from .settings import NoMotionError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix
    from .limits import Zone
    from .path import Path

logging.getLogger("toppra").setLevel(logging.CRITICAL)  # graspless reports failures itself

CHECKS = 4  # moments between two points of the grid at which limits are checked
FINAL_CHECKS = 24
REFINEMENTS = 4  # maximum number of refinements of the grid
MARGIN = 1e-4  # for excess between the checked moments
ROUNDING = 1e-9  # part of a motion, below which a window is lost in rounding
ACCEPTED = 0.01  # relative excess above which the grid is refined
LITTLE = 0.025  # relative excess that is refined only while that helps
HELPED = 0.7  # most of an excess that a refinement that helps leaves
GAPS = (1e-6, 1e-5, 1e-4, 1e-3, 1e-2)  # least steps of the grids, in lengths of the path


@np.errstate(all="ignore")  # limits near the ends of the range of numbers: see motion._made
def fastest(path: Path, zones: Sequence[Zone]) -> Motion:
    """Returns a fast motion along `path` whose limits hold at every moment.

    toppra evaluates limits at the points of a grid. Where they are exceeded between two points,
    the grid is refined and the speed there is reduced. A small excess is refined only as long as
    that helps. The remaining excess slows down the whole motion.

    Raises NoMotionError if toppra finds none.
    """
    grid, window = path.grid(), _window(zones)
    grid, slowed, motion, excess = _found(path, zones, grid, np.ones(len(grid)), window)
    best = grid, motion, excess.max()
    for _ in range(REFINEMENTS):
        before = excess.max()
        if before <= ACCEPTED:
            break
        broken = np.flatnonzero(excess > ACCEPTED / 2)
        more = 1 + excess[broken].clip(max=1.0)
        slowed[broken] *= more
        slowed[broken + 1] *= more
        middles = (grid[broken] + grid[broken + 1]) / 2
        order = np.argsort(np.append(grid, middles), kind="stable")
        slowed = np.append(slowed, np.maximum(slowed[broken], slowed[broken + 1]))[order]
        grid = np.append(grid, middles)[order]
        try:
            grid, slowed, motion, excess = _found(path, zones, grid, slowed, window)
        except NoMotionError:
            break
        if motion.duration * (1 + excess.max()) < best[1].duration * (1 + best[2]):
            best = grid, motion, excess.max()
        if HELPED * before < excess.max() <= LITTLE:
            break
    grid, motion, most = best
    times = _moments(motion, grid, FINAL_CHECKS)
    if motion.window > ROUNDING * motion.duration:
        times = np.append(times, _inside(_jumps(motion), 1))
    most = max(most, _excess(motion, zones, times, paces=False).max())
    return motion.slower(1 + MARGIN + 1.1 * float(most))


def _window(zones: Sequence[Zone]) -> float:
    """Returns the time in which every coordinate may reverse its acceleration [s]."""
    times = [0.0]
    for zone in zones:
        acceleration, jerk = zone.limits.acceleration, zone.limits.jerk
        limited = np.isfinite(jerk)
        times += (2 * acceleration[limited] / jerk[limited]).tolist()
    return max(times)


def _found(
    path: Path, zones: Sequence[Zone], grid: Matrix, slowed: Matrix, window: float
) -> tuple[Matrix, Matrix, Motion, Matrix]:
    """Returns the result of `_solved`, after the grid and the factors for which it was found.

    Where steps are very short, rounding errors can hide every motion from toppra: then those grids
    are tried that have only some of the points.
    """
    some, factors = grid, slowed
    for gap in GAPS:
        with contextlib.suppress(NoMotionError):
            return some, factors, *_solved(path, zones, some, factors, window)
        kept = _spaced(grid, gap * path.length)
        some, factors = grid[kept], slowed[kept]
    return some, factors, *_solved(path, zones, some, factors, window)


def _spaced(grid: Matrix, gap: float) -> list[int]:
    """Returns indices of points that are more than `gap` apart, among them both ends."""
    kept = [0]
    for k in range(1, len(grid) - 1):
        if grid[k] - grid[kept[-1]] > gap and grid[-1] - grid[k] > gap:
            kept.append(k)
    return [*kept, len(grid) - 1]


def _solved(
    path: Path, zones: Sequence[Zone], grid: Matrix, slowed: Matrix, window: float
) -> tuple[Motion, Matrix]:
    """Returns the motion of toppra, smoothed, and its relative excess in the parts of the grid.

    `slowed` [M] are factors on the time that a unit of the path takes.
    """
    # The tolerances of toppra are absolute: the path gets length 1 and a duration of about 1.
    unit = _unit_of_time(path, zones)
    speed, acceleration = _limits(path, zones, grid, window)
    given = _Given(path)
    constraints = [
        _Speed(speed / slowed / path.length * unit, given.dof),
        _Acceleration(acceleration * unit**2),
    ]
    solver = TOPPRA(constraints, given, gridpoints=grid / path.length)
    result = solver.compute_parameterization(0, 0)
    speeds = result[1]
    if speeds is None or not np.isfinite(speeds).all():
        raise NoMotionError
    profile = profile_of(grid, np.maximum(speeds, 0.0) * path.length / unit)
    motion = Motion(path, profile, window)
    times = _moments(motion, grid, CHECKS)
    excess = _excess(motion, zones, times)
    return motion, excess.reshape(len(grid) - 1, -1).max(axis=1)


def _limits(
    path: Path, zones: Sequence[Zone], grid: Matrix, window: float
) -> tuple[Matrix, Matrix]:
    """Returns the largest speed [M] and accelerations [M, n] at the points of the grid.

    Each holds for half the window before and after its point.
    """
    most = bounds(path, zones, grid)
    d1, d2, d3 = (np.abs(path(grid, order)) for order in (1, 2, 3))
    pace = [
        np.full(len(grid), 1e-100),
        most.pace,
        (d1 / most.velocity).max(axis=1),
        np.sqrt(d2 / most.acceleration).max(axis=1),
        np.cbrt(d3 / most.jerk).max(axis=1),
    ]
    speed = 1 / np.max(pace, axis=0)
    acceleration = most.acceleration.copy()
    if window > 0:
        reach = speed * window / 2
        first = np.searchsorted(grid, grid - reach, "left")
        last = np.searchsorted(grid, grid + reach, "right")
        of_point = speed.copy()
        for k, (i, j) in enumerate(zip(first, last, strict=True)):
            np.minimum(speed[i:j], of_point[k], out=speed[i:j])
            np.minimum(acceleration[i:j], most.acceleration[k], out=acceleration[i:j])
    return speed, acceleration


def _unit_of_time(path: Path, zones: Sequence[Zone]) -> float:
    """Returns the time that the path takes from rest at its maximum accelerations [s]."""
    s = np.linspace(0.0, path.length, 50)
    slopes = np.abs(path(s, 1)) / bounds(path, zones, s, paces=False).acceleration
    return float(np.sqrt(path.length * slopes.max()))


def _moments(motion: Motion, grid: Matrix, checks: int) -> Matrix:
    """Returns times at which to check the motion [s]: `checks` + 2 in each part of the grid."""
    knots = _jumps(motion)
    knots = np.sort(np.append(knots, (knots[1:] + knots[:-1]) / 2))
    return _inside(np.interp(grid, motion.at(knots)[0], knots), checks)


def _jumps(motion: Motion) -> Matrix:
    """Returns the times at which the jerk along the path jumps [s]."""
    x = motion.profile.x
    jumps: Matrix = np.unique(np.concatenate([x, x + motion.window]))
    return jumps


def _inside(times: Matrix, checks: int) -> Matrix:
    """Returns `checks` + 2 times between each two, the first and the last just inside [s]."""
    parts = np.linspace(1e-6, 1 - 1e-6, checks + 2)
    inside: Matrix = (times[:-1, None] + np.diff(times)[:, None] * parts).ravel()
    return inside


def _excess(motion: Motion, zones: Sequence[Zone], times: Matrix, *, paces: bool = True) -> Matrix:
    """Returns the relative excess of a motion at `times` [N] [s]; 0.01 is one percent."""
    at = motion.at(times)
    _, *values = motion.coordinates_at(at)
    most = bounds(motion.path, zones, at[0], paces=paces)  # paces are slow to ask
    allowed = (most.velocity, most.acceleration, most.jerk)
    ratios = [
        (np.abs(value) / limit).max(axis=1) ** (1 / power)
        for power, (value, limit) in enumerate(zip(values, allowed, strict=True), 1)
    ]
    excess: Matrix = np.max([*ratios, at[1] * most.pace, np.ones(len(times))], axis=0) - 1
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


class _Speed(LinearConstraint):  # type: ignore[misc]
    """Limits of the speed along the path at the points of the grid [M]."""

    def __init__(self, speed: Matrix, dof: int) -> None:
        super().__init__()
        self.speed = speed.clip(1e-50, 1e4)  # whose squares are numbers
        self.dof = dof

    def compute_constraint_params(self, path: Any, gridpoints: Matrix) -> tuple[Any, ...]:
        limits = np.stack([np.zeros(len(gridpoints)), self.speed**2], axis=1)
        return None, None, None, None, None, None, limits


class _Acceleration(LinearConstraint):  # type: ignore[misc]
    """Limits of the accelerations at the points of the grid [M, n]."""

    def __init__(self, acceleration: Matrix) -> None:
        super().__init__()
        self.acceleration = acceleration.clip(1e-50, 1e6)
        self.dof = acceleration.shape[1]
        self.identical = True

    def compute_constraint_params(self, path: Any, gridpoints: Matrix) -> tuple[Any, ...]:
        slopes, bends = (path(gridpoints, order) / self.acceleration for order in (1, 2))
        both = np.vstack([np.eye(self.dof), -np.eye(self.dof)])
        parameters: tuple[Any, ...] = canlinear_colloc_to_interpolate(
            slopes, bends, np.zeros_like(slopes), both, np.ones(2 * self.dof), None, None,
            gridpoints, identical=True,
        )  # fmt: skip
        return parameters
