# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Correction of the hand's path in place: a shift that moves smoothly."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from . import plane

if TYPE_CHECKING:
    from ..frames import Matrix
    from .settings import Settings


class Correction:
    """Shift of the hand's path, which follows a given step at bounded speed and acceleration.

    Attributes
    ----------
    motion : array [3]
        D: x, y [m] and yaw [rad]; acts from the left in the plane of the support.
    height : float
        Shift along the support's normal [m].
    """

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.height = self._climb = 0.0
        self.clear()

    def clear(self) -> None:
        """Begins anew, at rest, without a shift in the plane; the height stays."""
        self.motion = np.zeros(3)
        self._rate = np.zeros(3)

    def move(self, seconds: float, pivot: Matrix, step: Matrix, rise: float) -> None:
        """Moves the shift for some seconds; without step and rise it comes to rest.

        D moves so that the point at `pivot` [2] moves towards the end of `step` [3], and the
        height towards the end of `rise` [m].
        """
        s = self.settings
        x, y, turn = s.gain * step
        most = s.acceleration * seconds
        shift = _towards(self._rate[:2], _limited(np.array([x, y]), s.speed), most)
        turned = float(np.clip(turn, -s.turn_speed, s.turn_speed))
        turns = _towards(self._rate[2:], np.array([turned]), s.turn_acceleration * seconds)
        self._rate = np.concatenate([shift, turns])
        if np.any(self._rate):
            self.motion = plane.turned(self.motion, pivot, self._rate * seconds)
        climb = float(np.clip(2 * s.gain * rise, -s.speed, s.speed))
        self._climb += float(np.clip(climb - self._climb, -most, most))
        self.height += self._climb * seconds

    def rest(self) -> None:
        """Stays where it is."""
        self._rate, self._climb = np.zeros(3), 0.0

    @property
    def rests(self) -> bool:
        """True if the shift does not move."""
        return not (np.any(self._rate) or self._climb)

    def ahead(self, seconds: float, pivot: Matrix) -> Matrix:
        """Returns D [3] if it goes on as it moves now."""
        return plane.turned(self.motion, pivot, self._rate * seconds)


def _towards(rate: Matrix, asked: Matrix, most: float) -> Matrix:
    """Returns a rate that is at most `most` away from the one before, towards the asked one."""
    return rate + _limited(asked - rate, most)


def _limited(vector: Matrix, most: float) -> Matrix:
    """Returns a vector, shortened to a length of `most` if it is longer."""
    return vector * min(1.0, most / max(float(np.linalg.norm(vector)), 1e-12))
