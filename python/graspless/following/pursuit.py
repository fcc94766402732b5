# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pursuit of a plan: its segments one after the other, and new plans in its place."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .camera import Camera
from .course import goes_on
from .deviation import IN_CONTACT, Deviation
from .estimate import Estimate
from .guard import Guard
from .hand import Hand
from .motion import Motion
from .replan import Replanner

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..slide import Plan
    from ..timing import settings as timing
    from .correction import Correction
    from .course import Course
    from .settings import Settings

RETREAT = "retreat"
HOPELESS = 2.0  # times what is corrected in place: where a slide does not go on without new plan
ELSEWHERE = "the object is not where the plan has it"
_FALLS = (
    "the centre of mass is beyond the support's edge: the object falls when the finger leaves it"
)


class Pursuit:
    """The plan that is followed, the segment that the hand is in, and the reasons to leave them.

    Attributes
    ----------
    plan : slide.Plan
        Plan that is followed: the one given, or the last that was made on the way.
    settings : Settings
    estimate : Estimate
        Place of the object.
    resumes, restarts : int
        Numbers of new plans so far, without and with lifting off.
    search_seconds : dict
        Processor times of the searches for them, as of `Replanner`.
    """

    def __init__(self, plan: Plan, settings: Settings, limits: timing.Settings) -> None:
        self.plan, self.settings = plan, settings
        problem = plan.task.problem
        self._hand = Hand(problem)
        self._guard = Guard(plan, self._hand)
        self._replanner = Replanner(plan, self._hand, self._guard, settings)
        self.search_seconds = self._replanner.seconds
        self.resumes = self.restarts = 0
        self.estimate = Estimate(self._hand.place(plan.X_WO_start), settings.noise)
        self._motion = Motion(problem, self._hand, limits, settings, plan.segments[0])
        self._camera = Camera(problem, self._hand)
        self._t = self._planned = -np.inf
        self._began = -np.inf  # time at which the slide, or another segment, began [s]
        self._still = 0.0  # time since the segment ended
        self._at_end = 0.0, 0.0  # turn of the hand and error of the object then [rad]
        self._is_stuck = False  # the object has not followed the turn of the hand since
        self._stopped = ""
        self._reason = ""
        self._is_looking = True
        self._restart = ""  # reason for which the motion brakes, to begin anew
        self._is_braking = False  # to go on from rest
        self._is_blocked = False  # the shifted path of this segment would touch something
        self._goes_back = False  # to the plan's own path, which touches nothing
        self._index = 0

    @property
    def is_done(self) -> bool:
        """True if the hand has closed."""
        return self._index >= len(self.plan.segments)

    @property
    def _course(self) -> Course:
        return self._motion.course

    @property
    def _correction(self) -> Correction:
        return self._motion.correction

    @property
    def _deviation(self) -> Deviation:
        away = self._hand.away(self.plan.X_WH_grasp, self.settings.stand_off)
        return Deviation(self._course, self._correction.motion, self.estimate.place, away)

    def _end(self) -> None:
        """Goes on to the next segment."""
        if self._course.name == RETREAT:
            self._is_looking = True
            self._camera.forget()
            return
        if self._course.name in IN_CONTACT and self._guard.falls(self.estimate.place):
            self._stop(_FALLS)
            return
        self._index, self._began = self._index + 1, self._t
        if not self.is_done:
            self._begin(self._index)

    def _begin(self, index: int, q: Matrix | None = None, velocity: Matrix | None = None) -> None:
        self._index = index
        self._take(self.plan.segments[index], q, velocity)

    def _take(self, segment: Any, q: Matrix | None = None, velocity: Matrix | None = None) -> None:
        self._still, self._is_blocked = 0.0, False
        self._is_stuck = self._goes_back = False
        self._replanner.forget()
        self._motion.take(segment, q, velocity)

    def _resume(self, at_rest: bool = False) -> None:
        """Plans the rest of the slide, or brakes to begin anew."""
        if self.resumes >= self.settings.resumes:
            self._is_braking = False
            self._restart = f"the object did not follow {self.resumes} plans"
            return
        q = self._motion.base
        plan, fault = self._replanner.resume(self.plan, q, self.estimate.place)
        if self._replanner.is_searching:
            return  # it goes on in the next update
        self._is_braking = False
        if plan is None:
            is_hopeless = at_rest or self._deviation.is_large(self.settings, HOPELESS)
            self._restart = fault if is_hopeless else ""
        elif not (at_rest or goes_on(plan.segments[0], self._motion.velocity)):
            self._is_braking = True
        else:
            self.resumes += 1
            self._reason = f"planned the rest anew: {ELSEWHERE}"
            self.plan = plan
            self._correction.clear()
            self._begin(0, q, self._motion.velocity)

    def _begin_anew(self) -> None:
        """Lifts the hand straight up if it may touch the object, to begin anew from there.

        The finger stays on an object that only it holds.
        """
        reason, self._restart = self._restart, ""
        lifts, place = self._course.name in IN_CONTACT, self.estimate.place
        if lifts and self._guard.falls(place):
            self._stop(f"{_FALLS}; {reason}")
            return
        if self.restarts >= self.settings.restarts:
            self._stop(f"began anew {self.restarts} times; now {reason}")
            return
        self.restarts += 1
        self._reason = f"begins anew: {reason}"
        segment = self._replanner.retreat(self._motion.base, place, lifts)
        self._index = -1
        self._correction.clear()
        self._take(segment)
        self.estimate.loosen()

    def _plan_anew(self) -> None:
        plan, fault = self._replanner.anew(self._motion.base, self.estimate.place)
        if self._replanner.is_searching:
            return
        if plan is None:
            self._stop(fault)
            return
        self._reason = f"planned anew: {ELSEWHERE}"
        self.plan, self._planned = plan, self._t
        self._correction.clear()
        self._begin(0)

    def _stop(self, reason: str) -> None:
        self._stopped = self._stopped or ("" if self.is_done else reason)
