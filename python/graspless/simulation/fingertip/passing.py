# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slow motion past one row of a plan."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ... import frames
from .script import Script, blended, joined, moving, still

if TYPE_CHECKING:
    from ...fingertip import Plan, Segment
    from ...frames import Matrix
    from ..settings import Break

_AWAY = np.array([0.0, 0.0, 10.0])  # [m]


def passing(plan: Plan, segment: Segment, row: int, settings: Break) -> Script:
    """Returns a script that loads the fingers and then moves the object slowly past the row."""
    end = settings.until + settings.goes_on - settings.still
    times = np.arange(0, end, settings.sampling)
    along = slow_way(plan, segment, row, times, settings)
    arcs = max(len(segment.X_WO) - 1, 1)
    poses = frames.along(segment.X_WO, along)
    problem = plan.task.problem
    rows = along * len(segment) / arcs - 0.5  # as a whole motion: forces change from row to row
    move = moving(segment, times, rows, poses, problem.fingers.radius)
    move.centers[:, ~segment.touches[0]] += _AWAY  # a finger that regrasps: else within the object
    nothing = still(move, 0, 0.0, "none")
    nothing.forces[:] = 0
    load = blended(nothing, move, settings.load_seconds)
    settle = still(move, 0, settings.still - settings.load_seconds, "settle")
    return joined([load, settle, move])


def slow_way(plan: Plan, segment: Segment, row: int, times: Matrix, settings: Break) -> Matrix:
    """Returns how many arcs of a segment are behind the object [T]: at the row halfway through the
    wrench, with limited speed.
    """
    arcs = len(segment.X_WO) - 1
    if arcs == 0:
        return np.full(len(times), 0.5)
    at = (row + 0.5) * arcs / len(segment)
    k = min(int(at), arcs - 1)
    step = segment.X_WO[k + 1] - segment.X_WO[k]
    hull = np.asarray(plan.task.problem.object.hull)
    length = np.linalg.norm(hull @ step[:3, :3].T + step[:3, 3], axis=1).max()
    middle = (settings.begin + settings.until) / 2 - settings.still
    rate = settings.speed / length
    along: Matrix = at + (times - middle) * rate
    last = at + (settings.until - settings.still - middle) * rate
    along += max(0.0, -along[0]) - max(0.0, last - arcs)
    along = along.clip(0, arcs)  # what goes on for longer stops at the end
    return along
