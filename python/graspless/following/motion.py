# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Motion of a follower: a timed segment, shifted by a correction and averaged."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..timing.joints import zones_of
from ..timing.slide import touch
from .average import Average
from .correction import Correction
from .course import Course
from .pace import Pace

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..slide import Problem
    from ..timing import settings as timing
    from .hand import Hand
    from .settings import Settings


class Motion:
    """The segment that is followed, its correction, and the targets.

    The targets are means of an aim, so that their jerk is bounded.

    Attributes
    ----------
    course : Course
        Segment that is followed.
    correction : Correction
        Shift of its path.
    velocity : array [dof]
        Velocity of the aim [rad/s or m/s].
    target : array [dof]
        Last target of the joints [rad or m].
    lag : float
        Time after which the robot is where the aim was [s].
    """

    def __init__(
        self, problem: Problem, hand: Hand, limits: timing.Settings, settings: Settings, first: Any
    ) -> None:
        self._problem, self._hand, self._limits = problem, hand, limits
        q = np.array(first.positions[0])
        window = float(np.max(2 * limits.acceleration / limits.jerk))
        self._average = Average(window, q)
        self.lag = window / 2
        self.target = self._aim = q
        self.velocity = np.zeros_like(q)
        self._rate: Matrix = np.zeros_like(q)  # velocity of the target
        self.correction = Correction(settings)
        self._pace = Pace(hand, limits, 2 * settings.brake_seconds)
        self.course: Course
        self.take(first)

    @property
    def window(self) -> float:
        """Time after which the targets are where the aim is at rest [s]."""
        return self._average.window

    @property
    def rests(self) -> bool:
        """True if neither the segment nor its correction moves."""
        return self.correction.rests and (self.course.rate == 0 or self.course.has_ended)

    @property
    def base(self) -> Matrix:
        """Aim [dof] without the correction of the height."""
        return self._hand.shifted(self.course.position(), self.correction.motion, 0.0)

    @property
    def pace(self) -> float:
        """Rate of the course, up to 1, at which the shifted path keeps the limits."""
        return self._pace.rate(self.course, self.correction)

    def rest(self) -> None:
        """Stays at the last target, at rest, from where the motion starts again.

        For a robot that has had no new target for a while.
        """
        self.course.rest(self.target - self._aim)
        self.correction.rest()
        self._average = Average(self.window, self.target)
        self._aim = self.target
        self.velocity = self._rate = np.zeros_like(self.target)

    def take(self, segment: Any, q: Matrix | None = None, velocity: Matrix | None = None) -> None:
        """Goes on with another segment, at its first row or at q [dof] with a velocity [dof]."""
        places = np.array([self._hand.place(X) for X in segment.object_poses])
        zones = zones_of(segment, touch(self._problem, segment, self._limits), self._limits)
        self.course = Course(segment, places, zones, q, velocity)

    def command(self, seconds: float) -> Matrix:
        """Sets the target, some seconds after the last one; returns its velocity [dof].

        Both stay where no time has passed.
        """
        if seconds == 0:
            return self._rate
        aim, target = self._aim, self.target
        self._aim = self._hand.shifted(self.base, np.zeros(3), self.correction.height)
        self.velocity = (self._aim - aim) / seconds
        self.lag = self.window / 2 + seconds  # a target is reached when the next one comes
        self.target = self._average.add(seconds, self._aim)
        self._rate = (self.target - target) / seconds
        return self._rate
