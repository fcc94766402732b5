# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times of a plan's rows, for a robot that moves as fast as its limits allow."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import TaskError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .._plan import Plan
    from ..frames import Matrix
    from ..timing import Trajectory

LONGEST = 30.0  # longest duration of a replay [s]


class Clock:
    """Times of rows, scaled down if the whole would be too long to watch.

    Attributes
    ----------
    pace : float
        Speed of the replay over that of the robot.
    """

    def __init__(self, trajectory: Trajectory) -> None:
        self.trajectory = trajectory
        self.pace = pace_of(trajectory.duration)

    def times(self, segment: int, rows: ArrayLike) -> Matrix:
        """Returns the times of rows of a segment, [N] [s]; rows may be fractional."""
        here = self.trajectory.segment_index == segment
        times = self.trajectory.times[here] / self.pace
        found: Matrix = np.interp(np.asarray(rows, dtype=float), self.trajectory.rows[here], times)
        return found


def clock_of(plan: Plan) -> Clock | None:
    """Returns None if the plan has no motion, cannot be timed, or toppra is not installed."""
    if not plan:
        return None
    try:
        from .. import timing

        return Clock(timing.time(plan))
    except (ImportError, TaskError):
        return None


def pace_of(seconds: float) -> float:
    """Returns the speed-up for a motion of this duration [s]."""
    return max(1.0, seconds / LONGEST)


def tell_pace(pace: float | None) -> str:
    """Returns the caption's note on the speed; empty at the robot's own speed."""
    return "" if pace is None or pace < 1.05 else f"  ({pace:.1f} x robot speed)"
