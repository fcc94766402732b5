# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Follower of a slide: targets of the joints from measured poses of the object."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np

from ..errors import TaskError, explain, shown
from ..plan_files import as_motion, as_plan
from .clock import Clock
from .course import limits_of
from .deviation import IN_CONTACT
from .pursuit import ELSEWHERE, HOPELESS, RETREAT, Pursuit
from .settings import Settings, Target
from .watch import Watch, without_pose

if TYPE_CHECKING:
    from pathlib import Path

    from ..frames import Matrix
    from ..slide import Plan
    from ..timing.settings import PerJoint

GRASP = "grasp"
_LONGEST = 0.1  # time without a new target after which the motion starts again from rest [s]
_LATE = 3.0  # usual times between calls, after which the motion slips
_FALLEN = 5  # successive poses off the support after which the object has fallen
_PLANNED_ANEW = ("approach", "slide", "reach", GRASP)  # where larger deviations lead to a new plan
_NO_STEP = np.zeros(3), 0.0


class Follower(Pursuit):
    """Follows a slide plan by an application's loop, and corrects it by measured poses.

    Call `update` at the rate of the loop and send the target to the robot. Small deviations of the
    object are corrected in place: the path of the hand is shifted and turned in the plane of the
    support, and along its normal, while the object is slid to the goal of the plan. Larger ones
    lead to a new plan, and so does a shift with which the hand or the object would touch anything
    else. Where the hand grasps, it goes back to the plan's own path instead, if the object is near
    enough to its planned place.

    Parameters
    ----------
    plan : slide.Plan, str or Path
        Solved plan, or the path of its file.
    settings : Settings, optional
        By default `Settings()`.
    max_velocity, max_acceleration, max_jerk, contact_speed
        Limits, as of `graspless.time`. Half of each acceleration limit is kept for bends. The
        targets are means over the time in which the jerk can turn an acceleration round.

    Raises
    ------
    TaskError
        The plan is not a solved slide plan that ends with a grasp, or a limit is not positive.

    Notes
    -----
    A follower is one motion in progress. It cannot be copied or pickled, which is a TypeError, and
    not be used by several threads at once.
    """

    def __init__(
        self,
        plan: Plan | str | Path,
        settings: Settings | None = None,
        *,
        max_velocity: PerJoint | None = None,
        max_acceleration: PerJoint | None = None,
        max_jerk: PerJoint | None = None,
        contact_speed: float | None = None,
    ) -> None:
        found: Any = as_plan(plan)
        if found.kind != "slide":
            raise TaskError(f"plan: {found.kind}: only slide plans can be followed")
        as_motion(found, "follow")
        problem = found.task.problem
        if problem.X_WO_end is not None:
            raise TaskError("plan: a slide that leaves the object at an `end` cannot be followed")
        if found.segments[0].name == RETREAT:
            raise TaskError("plan: a restart cannot be followed: a Follower restarts by itself")
        chosen = Settings() if settings is None else settings
        if not isinstance(chosen, Settings):
            raise TaskError(f"settings: {shown(chosen)}: should be following.Settings")
        limits = max_velocity, max_acceleration, max_jerk
        super().__init__(found, chosen, limits_of(problem.robot, *limits, contact_speed))
        self._watch = Watch(problem.robot, self._hand.arm, chosen)
        self._clock = Clock(chosen.joint_seconds)
        self._looked = -np.inf  # time since when it waits for poses at rest [s]
        self._is_held = False  # the clock was lost: the targets do not move any more

    def __repr__(self) -> str:
        what = "stopped" if self._stopped else "done" if self.is_done else self._course.name
        return f"<Follower of '{self.plan.task.problem.object.name}', {what}>"

    def __reduce_ex__(self, protocol: Any) -> NoReturn:
        raise TypeError("a Follower cannot be copied or pickled: make another one of its plan")

    def update(
        self, t: float, q: Any, pose: Any = None, covariance: Any = None, age: float = 0.0
    ) -> Target:
        """Returns the target of the joints. It never raises: faults are statuses with reasons.

        Parameters
        ----------
        t : float
            Time, increasing from call to call [s]. Where it does not, or jumps by more than 1 s,
            nothing moves in this call. The next one may go on from there; after a jump, from rest.
        q : array [dof]
            Measured joints, in the order of the plan's joint_names [rad or m].
        pose : array [4, 4], optional
            Measured pose X_WO of the object. Each pose is given once.
        covariance : array [6, 6], optional
            Covariance of its position and rotation vector in the world [m^2, rad^2]. Default: that
            of settings.noise.
        age : float
            Time that has passed since the pose was measured [s]. Down to -0.005 it counts as 0.
        """
        try:
            return self._update(t, q, pose, covariance, age)
        except Exception as error:  # in the middle of a motion a loop has to go on
            self._stop(explain(error))
            return self._target("none", np.zeros_like(self._motion.target))

    def _update(self, t: float, q: Any, pose: Any, covariance: Any, age: float) -> Target:
        late = _LATE * self._clock.period
        since, fault = self._clock.step(t)
        if fault:
            return self._untimed(fault, q, pose)
        if self._clock.was_set or since > max(_LONGEST, late):
            self._motion.rest()
        seconds, seen = min(since, _LONGEST, late), "none"
        self._t = self._clock.now
        if pose is not None:
            seen = self._camera.see(self._t, pose, covariance, age, self._motion.lag, self.estimate)
        waits = self._waits(q, min(since, _LONGEST))
        if self._camera.off >= _FALLEN and self._course.name != "close":
            self._stop(f"the object is off its support in {_FALLEN} successive poses")
        if self._is_looking:
            self._look(seconds, waits)
        elif seconds and not self._is_held:
            self._move(seconds, waits)
        velocity = self._motion.command(0.0 if self._is_held else seconds)
        return self._target(seen, velocity * (not self._is_held), waits)

    def _untimed(self, fault: str, q: Any, pose: Any) -> Target:
        """Moves nothing: it is not known how far. The joints are checked nevertheless."""
        waits, is_lost = self._watch.joints(self._clock.period, q, self._motion.target)
        if self._clock.is_lost:
            self._is_held = True
            self._stop(fault)
        if is_lost:
            self._stop(waits)
        seen = "none" if pose is None else "bad_time"
        return self._target(seen, np.zeros_like(self._motion.target), fault)

    def _waits(self, q: Any, seconds: float) -> str:
        """Returns the reason for which the motion has to wait, or an empty text."""
        waits, is_lost = self._watch.joints(seconds, q, self._motion.target)
        camera, is_failing = self._camera, self._is_looking and self._camera.is_failing
        if not waits and (is_failing or self._course.name in IN_CONTACT):
            since = self._t - camera.since
            lost = min(since, self._t - self._began)
            waits, is_lost = self._watch.poses(since, lost, camera.refused, is_failing)
        if waits and is_lost:
            self._stop(waits)
        return waits

    def _look(self, seconds: float, waits: str) -> None:
        """Waits at rest until the object was seen often enough, then begins."""
        s = self.settings
        self._correction.move(seconds, self._deviation.pivot, *_NO_STEP)
        if not np.isfinite(self._looked):
            self._looked = self._t
        has_waited = self._t - self._looked >= s.look_seconds and not self._camera.is_failing
        if waits or self._stopped or not (self._camera.used >= s.look_poses or has_waited):
            return
        if self._course.name == RETREAT and not self._camera.used:
            self._stop(without_pose(f"in {s.look_seconds:g} s", self._camera.refused))
        elif self._course.name in IN_CONTACT and self._deviation.is_large(s):
            self._resume(at_rest=True)
            if self._restart:
                self._begin_anew()
        elif self._course.name == RETREAT or self._deviation.is_large(s):
            self._plan_anew()
        else:  # a search may be under way, for a pose of which later ones differ
            self._replanner.forget()
        self._is_looking = self._replanner.is_searching
        if not self._is_looking:
            self._looked = -np.inf

    def _move(self, seconds: float, waits: str) -> None:
        """Goes on along the segment, corrects, and decides on new plans and the next segment."""
        self._brake_before_contact()
        halted = bool(waits or self._stopped or self._restart or self._is_braking)
        step = _NO_STEP if halted or self._is_blocked else self._step()
        if self._is_stuck:
            step = step[0] * [1.0, 1.0, 0.0], step[1]
        halted = halted or (self._goes_back and not self._deviation.is_back)
        before = self._deviation.commanded
        self._correction.move(seconds, self._deviation.pivot, *step)
        halted = halted or bool(self._restart or self._is_braking)
        braking = self.settings.brake_seconds
        if halted:
            self._course.advance(seconds, 0.0, braking)
        else:
            self._course.advance(seconds, self._motion.pace, 2 * braking)
        if self._course.name in IN_CONTACT:
            self.estimate.carry(self._t, before, self._deviation.commanded)
        if waits or self._stopped:
            return
        if self._course.rate == 0 and self._is_braking:
            self._resume(at_rest=True)
        elif self._restart and self._motion.rests:
            self._begin_anew()
        elif self._course.has_ended and not halted:
            self._settle(seconds)
            is_blind, settings = not self._camera.used or self._goes_back, self.settings
            if self._still < self._motion.window:
                return
            if self._deviation.has_settled(self._still, is_blind, settings, self._is_stuck):
                self._end()
                if self.is_done:
                    self._reason = self._doubt()

    def _doubt(self) -> str:
        """Returns why the hand may have closed on nothing, or an empty text."""
        if self._camera.off >= _FALLEN:
            return f"the hand has closed; the object is off its support in {_FALLEN} poses"
        off = float(np.hypot(*(self._deviation.commanded - self.estimate.place)[:2]))
        if off > self.settings.grasp_correct:
            return f"the hand has closed; the object is {1e3 * off:.0f} mm from its place in it"
        return ""

    def _settle(self, seconds: float) -> None:
        """Counts the time since the segment ended, and notes an object that does not turn."""
        deviation = self._deviation
        if self._still == 0:
            self._at_end = float(deviation.motion[2]), float(deviation.error[2])
        self._still += seconds
        self._is_stuck = self._is_stuck or deviation.is_stuck(self._at_end)

    def _brake_before_contact(self) -> None:
        """Ends the motion if its shifted path touches anything before it could come to rest."""
        deviation, settings = self._deviation, self.settings
        waits = self._goes_back and not deviation.is_back
        if self._is_blocked or self._stopped or waits:
            return
        touching = self._guard.ahead(deviation, self._correction, settings.brake_seconds)
        if not touching:
            return
        reason = f"the shifted path would touch: {touching}"
        is_slight = self._course.name == GRASP and deviation.is_slight(settings)
        if is_slight and not self._goes_back:
            self._goes_back, self._reason = True, f"goes back to the plan's path: {reason}"
            return
        self._is_blocked = True
        if self._course.name in IN_CONTACT:
            self._is_braking, self._reason = True, reason
        elif self._course.name in _PLANNED_ANEW:
            self._restart = self._restart or reason
        else:
            self._stop(reason)

    def _target(self, seen: str, velocity: Matrix, waits: str = "") -> Target:
        if self._stopped:
            status, reason = "stopped", self._stopped
        elif self.is_done:
            status, reason = "done", self._reason
        elif waits or self._restart:
            status, reason = "waiting", waits or self._restart
        else:
            status, reason = "looking" if self._is_looking else "moving", self._reason
        return Target(self._motion.target.copy(), velocity, status, reason, self._course.name, seen)

    def _step(self) -> tuple[Matrix, float]:
        """Returns step [3] and rise of the correction; larger deviations are planned anew."""
        deviation, name, rise = self._deviation, self._course.name, 0.0
        if self._goes_back:
            return deviation.back, rise
        if name == "approach":
            off, spread = self.estimate.height, self.estimate.spread[2]
            rise = (off if abs(off) > 2 * spread else 0.0) - self._correction.height
        is_new = name in _PLANNED_ANEW and self._camera.used
        if not (is_new and deviation.is_large(self.settings)):
            return deviation.bounded_step(self.settings), rise
        if self._replanner.is_searching or self._t - self._planned > self.settings.between:
            self._planned = self._t
            if name in IN_CONTACT:
                self._resume()
            else:
                self._restart = ELSEWHERE
        deviation = self._deviation  # from a new plan, if one was found
        halts = self._restart or self._is_braking or name not in IN_CONTACT
        if halts or deviation.is_large(self.settings, HOPELESS):
            return np.zeros(3), rise
        return deviation.bounded_step(self.settings), rise
