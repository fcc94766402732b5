# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of one segment."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .fastest import fastest
from .path import rounded, stretches

if TYPE_CHECKING:
    from ..frames import Matrix
    from .fastest import Limits, Motion
    from .ramps import Ramps
    from .rates import Rate


@dataclass(frozen=True)
class Clip:
    """Timed motion of one segment from rest to rest: N samples.

    Attributes
    ----------
    times : array [N]
        Times from 0 [s].
    rows : array [N]
        Fractional index of the given points: 2.25 is a quarter of the way from point 2 to 3.
    coordinates, velocities, accelerations : array [N, n]
    """

    times: Matrix
    rows: Matrix
    coordinates: Matrix
    velocities: Matrix
    accelerations: Matrix


def clip(points: Matrix, tolerance: Matrix, limits: Limits, rate: Rate) -> Clip:
    """Returns the fastest motion through points [N, n], sampled at `rate`.

    It rests at its ends and where the points turn back. Equal points give a single sample.
    """
    parts: list[Clip] = []
    for rows in stretches(points):
        path = rounded(points[rows], tolerance)
        if path is not None:
            parts.append(sampled(fastest(path, limits), rows.start, rate))
    return joined(parts) if parts else still(points)


def still(points: Matrix) -> Clip:
    """Returns a single sample at the last of equal points [N, n]."""
    none = np.zeros_like(points[:1])
    return Clip(np.zeros(1), np.array([len(points) - 1.0]), points[-1:], none, none)


def joined(parts: list[Clip]) -> Clip:
    """Joins clips. Each begins at the end of the one before, in place and time."""
    starts = np.cumsum([0.0, *(part.times[-1] for part in parts[:-1])])
    first = [0] + [1] * (len(parts) - 1)
    times = [part.times[k:] + t for k, t, part in zip(first, starts, parts, strict=True)]
    others = ("rows", "coordinates", "velocities", "accelerations")
    values = [
        np.concatenate([getattr(part, name)[k:] for k, part in zip(first, parts, strict=True)])
        for name in others
    ]
    return Clip(np.concatenate(times), *values)


def sampled(motion: Motion | Ramps, row: int, rate: Rate) -> Clip:
    """Returns the samples of a motion along a path that starts at a `row`."""
    times = rate.times(motion.duration)
    rows = row + motion.path.row(motion.at(times)[0])
    return Clip(times, rows, *motion.coordinates(times))
