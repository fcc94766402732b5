# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""When a robot that is as fast as its limits allow is at each row of a plan."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import TaskError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..frames import Matrix
    from ..plans import Plan
    from ..timing import Trajectory

LONGEST = 30.0  # that a replay takes [s]


class Clock:
    """Times of rows, shortened where the whole would be too long to watch.

    Attributes
    ----------
    pace : float
        How much faster than the robot.
    """

    def __init__(self, trajectory: Trajectory) -> None:
        self.trajectory = trajectory
        self.pace = pace_of(trajectory.duration)

    def times(self, segment: int, rows: ArrayLike) -> Matrix:
        """[N] seconds of rows, which may lie between rows, of one of the trajectory's segments."""
        here = self.trajectory.segment_index == segment
        times = self.trajectory.times[here] / self.pace
        found: Matrix = np.interp(np.asarray(rows, dtype=float), self.trajectory.rows[here], times)
        return found


def clock_of(plan: Plan) -> Clock | None:
    """None where a plan has no motion, cannot be timed, or toppra is not installed."""
    if not plan:
        return None
    try:
        from .. import timing

        return Clock(timing.time(plan))
    except (ImportError, TaskError):
        return None


def pace_of(seconds: float) -> float:
    """How much faster to show what takes so long."""
    return max(1.0, seconds / LONGEST)


def tell_pace(pace: float | None) -> str:
    """What a caption says of the pace: nothing where it is that of what is shown."""
    return "" if pace is None or pace < 1.05 else f"  ({pace:.1f} x as fast)"
