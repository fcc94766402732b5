# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of rows: one segment, or several without a rest between them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .fastest import fastest
from .limits import tolerances
from .path import rounded, stretches

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from ..frames import Matrix
    from .limits import Zone
    from .motion import Motion
    from .rates import Rate


@dataclass(frozen=True)
class Clip:
    """Timed motion along rows: N samples.

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


def clip(points: Matrix, zones: Sequence[Zone], rate: Rate, marks: Sequence[int] = ()) -> Clip:
    """Returns the fastest motion through points [N, n], sampled at `rate` and at rows `marks`.

    It rests at its ends and where the points turn back. Equal points give a single sample.
    """
    parts: list[Clip] = []
    for rows in stretches(points):
        within = [part for zone in zones if (part := zone.within(rows))]
        path = rounded(points[rows], tolerances(within, points[rows].shape))
        if path is not None:
            inside = [mark - rows.start for mark in marks if rows.start < mark < rows.stop - 1]
            motion = fastest(path, within)
            reached = {mark: motion.reaches(path.place(mark)) for mark in inside}
            parts.append(sampled(motion, rows.start, rate, reached))
    return joined(parts) if parts else still(points)


def still(points: Matrix) -> Clip:
    """Returns a single sample at the last of equal points [N, n]."""
    none = np.zeros_like(points[:1])
    return Clip(np.zeros(1), np.array([len(points) - 1.0]), points[-1:], none, none)


def split(whole: Clip, marks: Sequence[int]) -> list[Clip]:
    """Splits a clip at rows where it has samples; the last mark is its last row.

    Rows are counted from the mark before, and times from its sample, which belongs to the part
    before.
    """
    parts, first, time, row = [], 0, 0.0, 0
    for mark in marks:
        last = int(np.searchsorted(whole.rows, mark + 1e-9, "right"))
        here = slice(first, last)
        parts.append(
            Clip(
                whole.times[here] - time,
                whole.rows[here] - row,
                whole.coordinates[here],
                whole.velocities[here],
                whole.accelerations[here],
            )
        )
        first, time, row = last, float(whole.times[last - 1]), mark
    return parts


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


def sampled(
    motion: Motion, start: int, rate: Rate, marks: Mapping[int, float] | None = None
) -> Clip:
    """Returns the samples of a motion along a path whose first row is `start`.

    `marks` are times [s] of additional samples, by the row that is reached then.
    """
    marks = marks or {}
    reached = np.array(list(marks.values()))
    times = np.union1d(rate.times(motion.duration), reached)
    rows = motion.path.row(motion.at(times)[0])
    rows[np.searchsorted(times, reached)] = list(marks)
    return Clip(times, start + rows, *motion.coordinates(times)[:3])
