# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Moving average of targets, which bounds their jerk."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ..frames import Matrix


class Average:
    """Mean of a motion over the last `window` [s].

    Where the acceleration of the motion is at most a, the mean has at most this acceleration, and a
    jerk of at most 2 a / window. It comes half a window later.

    Parameters
    ----------
    window : float
        Length [s], more than 0.
    q : array [dof]
        Where the motion rests at time 0.
    """

    def __init__(self, window: float, q: Matrix) -> None:
        self.window = window
        self._times, self._rows = np.array([-window, 0.0]), np.array([q, q])

    def add(self, seconds: float, q: Matrix) -> Matrix:
        """Takes the motion straight to q [dof] in some seconds, more than 0; returns the mean."""
        since = self._times[-1] + seconds - self.window
        first = int(np.searchsorted(self._times, since, side="right")) - 1
        self._times = np.append(self._times[first:], self._times[-1] + seconds)
        self._rows = np.vstack([self._rows[first:], q])
        start = (since - self._times[0]) / (self._times[1] - self._times[0])
        self._rows[0] += start * (self._rows[1] - self._rows[0])
        self._times[0] = since
        last, steps = self._rows[-1], np.diff(self._times)
        before = (self._rows[1:] + self._rows[:-1]) / 2 - last
        mean: Matrix = last + steps @ before / self.window
        return mean
