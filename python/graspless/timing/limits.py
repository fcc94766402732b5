# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Limits of a motion, which may differ from one zone of its path to the next."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..frames import Matrix
    from .path import Path

    Pace = Callable[[Matrix, Matrix], Matrix]


@dataclass(frozen=True)
class Limits:
    """Limits of n coordinates.

    Attributes
    ----------
    velocity, acceleration, jerk : array [n]
        Limits of each coordinate and of its derivatives; inf for none.
    paces : list of callable
        Functions of coordinates [N, n] and their derivatives [N, n] along the path. Each returns
        the least time per unit of the path [N].
    """

    velocity: Matrix
    acceleration: Matrix
    jerk: Matrix
    paces: Sequence[Pace] = ()


@dataclass(frozen=True)
class Zone:
    """Rows of a path that share their limits.

    Attributes
    ----------
    rows : slice
        From the first row to the last, which the next zone shares.
    limits : Limits
    tolerance : array [n]
        Farthest that each coordinate may be from the polyline of the rows.
    """

    rows: slice
    limits: Limits
    tolerance: Matrix

    def within(self, rows: slice) -> Zone | None:
        """Returns the part of the zone in a slice of rows, counted from its start, or None."""
        first = max(self.rows.start, rows.start)
        last = min(self.rows.stop, rows.stop)
        if last - first < 2:
            return None
        return Zone(slice(first - rows.start, last - rows.start), self.limits, self.tolerance)


@dataclass(frozen=True)
class Bounds:
    """Limits at N places of a path: velocity, acceleration, jerk [N, n] and pace [N]."""

    velocity: Matrix
    acceleration: Matrix
    jerk: Matrix
    pace: Matrix


def bounds(path: Path, zones: Sequence[Zone], s: Matrix, *, paces: bool = True) -> Bounds:
    """Returns the limits at `s` [N]; where two zones meet, the stricter ones."""
    none = np.full((len(s), path.curve.c.shape[2]), np.inf)
    found = Bounds(none, none.copy(), none.copy(), np.zeros(len(s)))
    for zone in zones:
        here = (s >= path.place(zone.rows.start)) & (s <= path.place(zone.rows.stop - 1))
        for name in ("velocity", "acceleration", "jerk"):
            values = getattr(found, name)
            values[here] = np.minimum(values[here], getattr(zone.limits, name))
        if paces and here.any():
            q, dq = path(s[here]), path(s[here], 1)
            for pace in zone.limits.paces:
                found.pace[here] = np.maximum(found.pace[here], pace(q, dq))
    return found


def tolerances(zones: Sequence[Zone], shape: tuple[int, ...]) -> Matrix:
    """Returns how far rows of a shape [N, n] may be cut off: where zones meet, the lesser."""
    found = np.full(shape, np.inf)
    for zone in zones:
        found[zone.rows] = np.minimum(found[zone.rows], zone.tolerance)
    return found
