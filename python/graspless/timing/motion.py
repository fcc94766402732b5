# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timed paths."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from scipy.interpolate import PPoly
from scipy.optimize import brentq

from .settings import NoMotionError

if TYPE_CHECKING:
    from ..frames import Matrix
    from .path import Path


@dataclass(frozen=True)
class Motion:
    """A timed path.

    Attributes
    ----------
    path : Path
    profile : PPoly
        From time to the path's parameter, before it is averaged.
    window : float
        Time over which it is averaged [s].
    """

    path: Path
    profile: PPoly
    window: float

    @property
    def duration(self) -> float:
        """Duration [s]."""
        return float(self.profile.x[-1]) + self.window

    @cached_property
    def _integral(self) -> PPoly:
        return self.profile.antiderivative()

    def slower(self, factor: float) -> Motion:
        """Returns the motion with all times multiplied by a factor."""
        powers = factor ** np.arange(2.0, -1.0, -1.0)
        profile = _made(self.profile.c / powers[:, None], self.profile.x * factor)
        return Motion(self.path, profile, self.window * factor)

    def reaches(self, s: float) -> float:
        """Returns the time at which the path's parameter becomes `s` [s]."""
        return float(brentq(lambda t: self.place(np.array([t]))[0] - s, 0.0, self.duration))

    def place(self, t: Matrix) -> Matrix:
        """Returns the path's parameter [N] at `t` [N] [s]."""
        place = self._derivative(t, 0).clip(0.0, self.path.length)
        return np.where(t < self.duration, place, self.path.length)

    def at(self, t: Matrix) -> Matrix:
        """Returns the path's parameter and its first three derivatives [4, N] at `t` [N] [s]."""
        return np.array([self.place(t), *(self._derivative(t, order) for order in (1, 2, 3))])

    def coordinates(self, t: Matrix) -> tuple[Matrix, Matrix, Matrix, Matrix]:
        """Returns coordinates, velocities, accelerations and jerks [N, n] at `t` [N] [s]."""
        return self.coordinates_at(self.at(t))

    def coordinates_at(self, at: Matrix) -> tuple[Matrix, Matrix, Matrix, Matrix]:
        """Returns the same, given the result [4, N] of `at`."""
        s, (v, a, j) = at[0], at[1:, :, None]
        d1, d2, d3 = (self.path(s, order) for order in (1, 2, 3))
        return self.path(s), d1 * v, d2 * v**2 + d1 * a, d3 * v**3 + 3 * d2 * v * a + d1 * j

    def _derivative(self, t: Matrix, order: int) -> Matrix:
        """Returns a derivative of the averaged profile [N], which rests before and after it."""
        if self.window == 0:
            inside: Matrix = self.profile(t.clip(0.0, float(self.profile.x[-1])), order)
            return inside if order < 3 else np.zeros_like(t)
        after, before = (_held(self._integral, at, order) for at in (t, t - self.window))
        return (after - before) / self.window


@dataclass(frozen=True)
class Ramps:
    """A timed path whose squared speed is linear between points of a grid.

    Attributes
    ----------
    path : Path
    grid : array [M]
        Parameters of the path, from 0 to its length.
    speeds : array [M]
        Speeds along the path there [1/s].
    times : array [M]
        Times there [s].
    """

    path: Path
    grid: Matrix
    speeds: Matrix
    times: Matrix

    @property
    def duration(self) -> float:
        """Duration [s]."""
        return float(self.times[-1])

    @cached_property
    def _slopes(self) -> Matrix:
        return np.diff(self.speeds**2) / (2 * np.diff(self.grid))

    def at(self, t: Matrix) -> tuple[Matrix, Matrix, Matrix]:
        """Returns position, speed and acceleration along the path [N] at times `t` [N] [s]."""
        t = np.clip(t, 0.0, self.duration)
        k = np.clip(np.searchsorted(self.times, t, side="right") - 1, 0, len(self.grid) - 2)
        since = t - self.times[k]
        slopes = self._slopes[k]
        s = self.grid[k] + self.speeds[k] * since + slopes * since**2 / 2
        return s.clip(0.0, self.path.length), self.speeds[k] + slopes * since, slopes

    def coordinates(self, t: Matrix) -> tuple[Matrix, Matrix, Matrix]:
        """Returns coordinates, velocities and accelerations [N, n] at times `t` [N] [s]."""
        s, ds, dds = self.at(t)
        dq = self.path(s, 1)
        accelerations = self.path(s, 2) * ds[:, None] ** 2 + dq * dds[:, None]
        return self.path(s), dq * ds[:, None], accelerations


def _held(integral: PPoly, t: Matrix, order: int) -> Matrix:
    """Returns derivatives of the integral of a position that rests before and after its motion."""
    end = float(integral.x[-1])
    inside: Matrix = integral(t.clip(0.0, end), order)
    if order == 0:
        return inside + (t - end).clip(min=0.0) * float(integral(end, 1))
    return inside if order == 1 else np.where((t > 0) & (t < end), inside, 0.0)


def profile_of(grid: Matrix, speeds: Matrix) -> PPoly:
    """Returns the path's parameter over time, with a constant acceleration between grid points."""
    steps = 2 * np.diff(grid) / (speeds[1:] + speeds[:-1])
    pieces = np.array([np.diff(speeds) / steps / 2, speeds[:-1], grid[:-1]])
    return _made(pieces, np.concatenate([[0.0], np.cumsum(steps)]))


def _made(pieces: Matrix, times: Matrix) -> PPoly:
    """Returns a profile; raises NoMotionError if numbers cannot express it."""
    if not (np.isfinite(pieces).all() and np.isfinite(times).all() and (np.diff(times) > 0).all()):
        raise NoMotionError
    return PPoly(pieces, times)
