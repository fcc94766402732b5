# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A slide in closed loop: a camera that is late, noisy and biased, and a follower that uses it."""

from __future__ import annotations

import time
from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ... import frames
from ...following import Follower, Settings
from ...following.pursuit import RETREAT
from .execution import Execution
from .program import HOLD, Command, Program, make_end

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...following import Target
    from ...frames import Matrix
    from ...slide import Plan
    from ..settings import Slide
    from ..variation import Variation
    from .program import Senses
    from .truth import Truth

STOPPED = "stop"  # phase of a follower that has given up
_STOP_SECONDS = 0.5  # after which the trial ends [s]
_RATE = 100.0  # of updates [1/s]
_LONGEST = 120.0  # trial [s]
# Time stands still while the follower searches: parts of a search would depend on the computer.
_FOLLOWING = Settings(search_seconds=Settings().plan_seconds)


@dataclass(frozen=True)
class CameraModel:
    """Camera that measures the pose of the object.

    Attributes
    ----------
    rate : float
        Poses per second [1/s].
    position, angle : float
        Standard deviations of the noise, per axis [m, rad].
    bias : float
        Length of a constant error of each trial, in a random direction [m].
    lag : float
        Time from exposure to delivery [s].
    lost : float
        Probability that a pose is not delivered.
    burst, burst_seconds : float
        Probability that none is delivered for `burst_seconds` [s] after a pose.
    """

    rate: float = 30.0
    position: float = 0.002
    angle: float = 0.01745
    bias: float = 0.0015
    lag: float = 0.1
    lost: float = 0.1
    burst: float = 0.01
    burst_seconds: float = 0.3


class Camera:
    """Camera of one trial.

    Parameters
    ----------
    model : CameraModel
    seed : sequence of int
        Seed of noise, bias and dropouts.
    """

    def __init__(self, model: CameraModel, seed: Sequence[int]) -> None:
        self.model = model
        self._random = np.random.default_rng(seed)
        direction = self._random.normal(size=3)
        self.bias = model.bias * direction / np.linalg.norm(direction)
        self._next = self._dark = 0.0
        self._waiting: deque[tuple[float, Matrix]] = deque()

    def look(self, t: float, senses: Senses) -> tuple[Matrix, float] | None:
        """Exposes when it is time; returns the newest pose that arrives now, and its age [s]."""
        while t >= self._next:
            self._next += 1 / self.model.rate
            pose = self._exposed(senses.object_pose())
            if t >= self._dark and self._random.uniform() >= self.model.lost:
                self._waiting.append((t, pose))
            if self._random.uniform() < self.model.burst:
                self._dark = t + self.model.burst_seconds
        if not self._waiting or t < self._waiting[0][0] + self.model.lag - 1e-9:
            return None
        taken, pose = self._waiting.popleft()
        return pose, t - taken

    def _exposed(self, X_WO: Matrix) -> Matrix:
        turn = self._random.normal(size=3) * self.model.angle
        seen: Matrix = X_WO @ frames.from_rpy(turn.tolist())
        seen[:3, 3] += self._random.normal(size=3) * self.model.position + self.bias
        return seen


class Followed:
    """Controller that follows a plan by the camera, then adds squeeze, raise and hold."""

    def __init__(self, plan: Plan, camera: Camera, timestep: float, settings: Slide) -> None:
        self.follower = Follower(plan, _FOLLOWING)
        self._plan, self._camera, self._settings = plan, camera, settings
        self._timestep = timestep
        self._every = max(1, round(1 / _RATE / timestep))
        self._end: Program | None = None
        self._began = 0
        self.target: Target | None = None
        self.seconds: list[float] = []  # of each update, on the processor
        self._at = self._stopped_at = 0.0
        self.start: Matrix = np.array(plan.segments[0].positions[0])

    @property
    def X_WO_goal(self) -> Matrix:
        """Pose that the object is to have after the slide, in the plan that is followed now."""
        return self.follower.plan.X_WO_goal

    @property
    def raised(self) -> float:
        """How high the arm can lift straight up [m]."""
        return 0.0 if self._end is None else self._end.raised

    def command(self, step: int, senses: Senses) -> Command | None:
        """Returns the command of a step; None after the last."""
        if self._end is not None:
            return self._end.command(step - self._began)
        t = step * self._timestep
        if step % self._every == 0:
            seen = self._camera.look(t, senses)
            pose, age = (None, 0.0) if seen is None else seen
            q = senses.positions()
            began = time.thread_time()
            self.target = self.follower.update(t, q, pose, age=age)
            self.seconds.append(time.thread_time() - began)
            self._at = t
            if self.target.status == "done":
                q = self.target.position
                self._end = make_end(self._plan, q, self._timestep, self._settings)
                self._began = step
                return self._end.command(0)
        return self._held(t)

    def _held(self, t: float) -> Command | None:
        """Returns the target, carried on to now at its velocity."""
        assert self.target is not None
        target = self.target
        has_stopped = target.status == "stopped"
        if not has_stopped:
            self._stopped_at = t
        if t > _LONGEST or t - self._stopped_at > _STOP_SECONDS:
            return None
        position = target.position + (t - self._at) * target.velocity
        return Command(position, target.velocity, STOPPED if has_stopped else target.phase)


class FollowedExecution(Execution):
    """Execution in closed loop. A contact that was lost is no failure if it is found again."""

    def __init__(
        self,
        plan: Plan,
        variation: Variation,
        settings: Slide,
        seed: Sequence[int],
        truth: Truth | None = None,
    ) -> None:
        camera = Camera(CameraModel(), seed)

        def control(timestep: float) -> Followed:
            self.followed = Followed(plan, camera, timestep, settings)
            return self.followed

        super().__init__(plan, variation, settings, control=control, truth=truth)

    def run(self, until: str = HOLD) -> None:
        """Runs to the end of a phase, or until the object has fallen or the follower stopped."""
        super().run(until)
        follower = self.followed.follower
        self.measures |= {
            "resumes": float(follower.resumes),
            "restarts": float(follower.restarts),
            "update": max(self.followed.seconds, default=0.0),
        }
        for kind, seconds in follower.search_seconds.items():
            if seconds:
                self.measures[f"{kind}_seconds"] = max(seconds)
        target = self.followed.target
        if target is not None and target.status == "stopped":
            self.judge.note("stopped")

    def _end_of(self, phase: str, following: str) -> None:
        super()._end_of(phase, following)
        if following == RETREAT:
            self.judge.withdraw("tip_lost")
            self._let_finger_slide()
