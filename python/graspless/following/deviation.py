# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Deviation of the object from the plan, and how the hand has to move because of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from . import plane

if TYPE_CHECKING:
    from ..frames import Matrix
    from .course import Course
    from .settings import Settings

IN_CONTACT = ("slide",)  # the hand moves the object
_PAUSE = 0.05  # between segments [s]
ON_OBJECT = ("approach", "reach", "grasp")  # the hand moves to the object


@dataclass(frozen=True)
class Deviation:
    """Comparison of plan and estimate.

    Attributes
    ----------
    course : Course
        Segment that is followed.
    motion : array [3]
        Shift D of the hand's path.
    place : array [3]
        Estimated place of the object.
    away : array [2]
        Shift of the hand away from the object while it reaches [m].
    """

    course: Course
    motion: Matrix
    place: Matrix
    away: Matrix

    @property
    def commanded(self) -> Matrix:
        """Returns the place [3] of the object if it moved with the hand as planned."""
        return plane.compose(self.motion, self.course.place())

    @property
    def pivot(self) -> Matrix:
        """Returns the point [2] that errors and steps move."""
        at = self.commanded if self.course.name in ON_OBJECT else self.place
        return at[:2]

    @property
    def error(self) -> Matrix:
        """Returns the motion [3] that the hand lacks: displacement of the pivot, and turn."""
        if self.course.name in ON_OBJECT:
            return plane.difference(self.commanded, self.place)
        if self.course.name in IN_CONTACT:
            return plane.difference(self.place, self.course.place())
        return np.zeros(3)

    @property
    def step(self) -> Matrix:
        """Returns the motion [3] that the hand has to make: the error, and away in `reach`."""
        reaches = self.course.name == "reach"
        return self.error + np.append(self.away, 0.0) if reaches else self.error

    def is_large(self, settings: Settings) -> bool:
        """Returns True if the shift that is needed is more than what is done in place."""
        planned = self.course.place()
        needed = plane.turned(self.motion, self.pivot, self.error)
        off = plane.difference(planned, plane.compose(needed, planned))
        most, turned = settings.correct, settings.correct_angle
        if self.course.name in ("reach", "grasp"):
            most, turned = settings.grasp_correct, settings.grasp_correct_angle
        return bool(np.hypot(*off[:2]) > most or abs(off[2]) > turned)

    def has_settled(self, still: float, is_blind: bool, settings: Settings) -> bool:
        """Returns True if the next segment may begin, `still` seconds after the end of this one.

        After the slide the object has to be near its goal, unless there are no poses.
        """
        if self.course.name == "press":
            return still >= settings.settle_seconds
        if self.course.name != "slide":
            return still >= _PAUSE
        off, turn = np.hypot(*self.error[:2]), abs(self.error[2])
        near = is_blind or (off < settings.settled and turn < settings.settled_angle)
        return bool((still >= settings.settle_seconds and near) or still >= settings.settle_most)
