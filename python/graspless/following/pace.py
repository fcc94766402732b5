# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pace of a shifted path: as fast as planned where the limits of the joints allow for it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..timing import settings as timing
    from .correction import Correction
    from .course import Course
    from .hand import Hand

_STEP = 0.05  # between the moments of the path that are looked at [s]
_STALE = 2e-3, 2e-2  # change of the shift after which they are looked at again [m, rad]


class Pace:
    """Rate of the clock at which a shifted path keeps the limits.

    The limits are those of the timed path without a shift. Where the arm is near a singularity, a
    small shift of the hand may ask for much faster joints.

    Parameters
    ----------
    hand : Hand
    limits : timing.Settings
    seconds : float
        Time in which the clock stops and starts: so far it looks ahead [s].
    """

    def __init__(self, hand: Hand, limits: timing.Settings, seconds: float) -> None:
        self._hand, self._limits, self._ahead = hand, limits, seconds
        self._course: Course | None = None
        self._shift = np.zeros(4)
        self._known: dict[int, Matrix] = {}  # joints [dof] at multiples of _STEP

    def rate(self, course: Course, correction: Correction) -> float:
        """Returns a rate in (0, 1] for the shifted path from now on."""
        shift = np.append(correction.motion, correction.height)
        if not shift.any():
            return 1.0
        if course is not self._course or course.is_fading or self._is_stale(shift):
            self._course, self._shift, self._known = course, shift, {}
        now = int(course.clock / _STEP)
        moments = range(max(now - 1, 0), now + 3 + int(self._ahead / _STEP))
        self._known = {
            k: self._known[k] if k in self._known else self._at(course, k) for k in moments
        }
        rows = np.array(list(self._known.values()))
        speed = np.abs(np.diff(rows, axis=0)).max(axis=0) / _STEP
        bend = np.abs(np.diff(rows, 2, axis=0)).max(axis=0) / _STEP**2
        with np.errstate(divide="ignore"):
            by_speed = (self._limits.velocity / speed).min()
            by_bend = np.sqrt((self._limits.acceleration / bend).min())
        return float(min(1.0, by_speed, by_bend))

    def _is_stale(self, shift: Matrix) -> bool:
        moved = np.abs(shift - self._shift)
        most, turned = _STALE
        return bool(moved[[0, 1, 3]].max() > most or moved[2] > turned)

    def _at(self, course: Course, k: int) -> Matrix:
        """Returns the joints [dof] where the clock is at k steps; the shift is that of now."""
        q = course.position(k * _STEP - course.clock)
        return self._hand.shifted(q, self._shift[:3], float(self._shift[3]))
