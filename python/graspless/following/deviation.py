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
_IN_VAIN = 0.8  # of the largest turn
_BACK = 1e-4, 1e-3  # of the plan's own path, where the hand counts as on it [m, rad]
_TRIED = 0.05  # turn of the hand after which it is known how far the object follows [rad]
_FOLLOWS = 0.3  # part of it that an object has to follow at least
_NEAR = 0.5  # of what is corrected in place, where the hand may close
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

    @property
    def back(self) -> Matrix:
        """Returns the motion [3] that takes the hand back to the plan's own path."""
        return plane.difference(self.commanded, self.course.place())

    @property
    def is_back(self) -> bool:
        """True if the hand is on the plan's own path."""
        most, turned = _BACK
        return bool(np.hypot(*self.back[:2]) < most and abs(self.back[2]) < turned)

    def is_slight(self, settings: Settings) -> bool:
        """Returns True if the object is about where it was planned: no correction is needed.

        An open hand that stays on the plan's own path still closes on it.
        """
        off = plane.difference(self.course.place(), self.place)
        is_near = np.hypot(*off[:2]) <= settings.correct
        return bool(is_near and abs(off[2]) <= settings.correct_angle)

    def bounded_step(self, settings: Settings) -> Matrix:
        """Returns the step [3], in contact only as far as the shift of the hand may go.

        The finger would leave its place on an object that does not follow it.
        """
        if self.course.name not in IN_CONTACT:
            return self.step
        shift = plane.difference(self.course.place(), self.commanded)
        asked = shift + self.step
        asked[:2] *= min(1.0, settings.shift / max(float(np.hypot(*asked[:2])), 1e-12))
        asked[2] = np.clip(asked[2], -settings.shift_angle, settings.shift_angle)
        bounded: Matrix = asked - shift
        return bounded

    def is_large(self, settings: Settings, times: float = 1.0) -> bool:
        """Returns True if the deviation is more than `times` what is corrected in place.

        It is that of the object from its path in contact, else the shift of the hand that is
        needed. An angle that the hand cannot change is never more than the grasp allows for.
        """
        planned = self.course.place()
        needed = plane.turned(self.motion, self.pivot, self.error)
        off = plane.difference(planned, plane.compose(needed, planned))
        most, turned = settings.correct, settings.correct_angle
        if self.course.name in ("reach", "grasp"):
            most, turned = settings.grasp_correct, settings.grasp_correct_angle
        turned *= times
        if self.course.name in IN_CONTACT:
            off = self.error
            turned = settings.grasp_correct_angle if self._turns_in_vain(settings) else turned
        return bool(np.hypot(*off[:2]) > times * most or abs(off[2]) > turned)

    def _turns_in_vain(self, settings: Settings) -> bool:
        """Returns True if the hand has turned as far as it may, and the object did not follow.

        It would not follow a new plan either. The grasp allows for its turn.
        """
        turn = plane.difference(self.course.place(), self.commanded)[2]
        return bool(np.sign(self.error[2]) * turn > _IN_VAIN * settings.shift_angle)

    def is_stuck(self, before: tuple[float, float]) -> bool:
        """Returns True if the object has hardly followed the turn of the hand since `before`.

        These were the turn of the hand and the error of the object [rad]. A pad that turns on and
        on rolls a narrow handle over.
        """
        turned = abs(float(self.motion[2]) - before[0])
        followed = abs(before[1]) - abs(float(self.error[2]))
        return self.course.name in IN_CONTACT and turned > _TRIED and followed < _FOLLOWS * turned

    def has_settled(
        self, still: float, is_blind: bool, settings: Settings, is_stuck: bool = False
    ) -> bool:
        """Returns True if the next segment may begin, `still` seconds after the end of this one.

        After the slide the object has to be near its goal, unless there are no poses, or it does
        not turn with the hand. After the grasp the hand has to be near the object.
        """
        if self.course.name == "press":
            return still >= settings.settle_seconds
        off, turn = np.hypot(*self.error[:2]), abs(self.error[2])
        if self.course.name == "grasp":
            near = off < _NEAR * settings.correct and turn < _NEAR * settings.correct_angle
            return still >= (_PAUSE if near or is_blind else settings.settle_most)
        if self.course.name != "slide":
            return still >= _PAUSE
        is_turned = is_stuck or turn < settings.settled_angle
        near = is_blind or (off < settings.settled and is_turned)
        return bool((still >= settings.settle_seconds and near) or still >= settings.settle_most)
