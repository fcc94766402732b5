# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Motion along a path to rest, computed in milliseconds, for timing anew while a robot moves.

Half of each acceleration limit is kept for bends, half for speeding up and slowing down. The
squared speed is then bounded at every point, and its slope along the path too: two passes over the
path give the largest squared speed within both bounds. `fastest` shares the limits better and takes
a hundred times as long. The jerk is not bounded here.
"""

from __future__ import annotations

from bisect import bisect_right
from itertools import accumulate
from typing import TYPE_CHECKING

import numpy as np

from .clip import Clip, still
from .limits import bounds, tolerances
from .motion import Ramps
from .path import rounded, stretches

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix
    from .limits import Zone
    from .path import Path


_NEAR = 1e-7  # distance of points that count as one, relative to the path's length
_SHARE = 0.97  # of paces and accelerations, which are larger between points of the grid


def ramps(path: Path, zones: Sequence[Zone], speed: float = 0.0) -> Ramps:
    """Returns a motion along `path` that begins at `speed` [1/s] and ends at rest.

    It begins slower if the path is too short, or its first bend too sharp, for that speed.
    """
    breaks = np.asarray(path.curve.x)
    # The ends are where a motion from rest gains its speed.
    ends = path.length * np.array([1e-3, 1e-2, 0.05])
    inner = [breaks[:-1] + share * np.diff(breaks) for share in (0.25, 0.5, 0.75)]
    points = [breaks, *inner, ends, path.length - ends]
    grid = np.unique(np.concatenate(points).clip(0.0, path.length))
    grid = np.append(grid[:-1][np.diff(grid) > _NEAR * path.length], path.length)
    most = bounds(path, zones, grid)
    slopes, bends = np.abs(path(grid, 1)), np.abs(path(grid, 2))
    with np.errstate(divide="ignore"):
        fast = np.min(most.velocity / slopes, axis=1)
        bent = np.min(_SHARE * most.acceleration / 2 / bends, axis=1)
        gains = np.min(_SHARE * most.acceleration / 2 / slopes, axis=1)
        paced = _SHARE / most.pace
    squares = np.minimum(np.minimum(fast, paced) ** 2, bent)
    squares[-1] = 0.0
    steps = 2 * np.diff(grid) * np.minimum(gains[1:], gains[:-1])
    for k in range(len(grid) - 2, -1, -1):
        squares[k] = min(squares[k], squares[k + 1] + steps[k])
    squares[0] = min(squares[0], speed**2)
    for k in range(len(grid) - 1):
        squares[k + 1] = min(squares[k + 1], squares[k] + steps[k])
    speeds = np.sqrt(squares)
    times = np.concatenate([[0.0], np.cumsum(2 * np.diff(grid) / (speeds[1:] + speeds[:-1]))])
    return Ramps(path, grid, speeds, times)


class Ramped:
    """Motion through points like that of `clip`, found quickly by `ramps`, to be asked at any time.

    Parameters
    ----------
    points : array [N, n]
    zones : sequence of Zone
        Limits of the points.
    velocity : array [n], optional
        The motion does not start from rest, but with as much of this velocity's part along the
        first points as the limits allow.

    Attributes
    ----------
    duration : float
        Time that it takes [s].
    """

    def __init__(
        self, points: Matrix, zones: Sequence[Zone], velocity: Matrix | None = None
    ) -> None:
        self._still = still(points)
        self._parts: list[tuple[int, Ramps]] = []  # with the first row of each
        for rows in stretches(points):
            within = [part for zone in zones if (part := zone.within(rows))]
            path = rounded(points[rows], tolerances(within, points[rows].shape))
            if path is not None:
                is_first = velocity is not None and not self._parts
                speed = max(0.0, float(velocity @ path(np.zeros(1), 1)[0])) if is_first else 0.0
                self._parts.append((rows.start, ramps(path, within, speed)))
        *self._starts, self.duration = accumulate((m.duration for _, m in self._parts), initial=0.0)

    def at(self, times: Matrix) -> Clip:
        """Returns the motion at increasing times [N] [s]; after its end it rests."""
        if not self._parts:
            rest, none = self._still, np.zeros(len(times), int)
            nothing = rest.velocities[none]
            return Clip(times, rest.rows[none], rest.coordinates[none], nothing, nothing)
        within = np.searchsorted(self._starts, times, side="right") - 1
        pieces = [self._piece(k, times[within == k]) for k in np.unique(within)]
        return Clip(times, *(np.concatenate(values) for values in zip(*pieces, strict=True)))

    def now(self, t: float) -> tuple[float, Matrix]:
        """Returns row and coordinates [n] at a time [s], as `at` does, but quickly."""
        if not self._parts:
            return float(self._still.rows[0]), self._still.coordinates[0]
        k = max(bisect_right(self._starts, t) - 1, 0)
        first, part = self._parts[k]
        s = part.at(np.array([t - self._starts[k]]))[0]
        return float(first + part.path.row(s)[0]), part.path(s)[0]

    def _piece(self, k: int, times: Matrix) -> tuple[Matrix, Matrix, Matrix, Matrix]:
        first, part = self._parts[k]
        t = times - self._starts[k]
        return first + part.path.row(part.at(t)[0]), *part.coordinates(t)
