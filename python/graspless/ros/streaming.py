# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Execution in closed loop: targets of a Follower, streamed to the controllers' topics."""

from __future__ import annotations

import dataclasses
import time
from typing import TYPE_CHECKING, Any

import numpy as np
from trajectory_msgs.msg import JointTrajectory

from ..following import Follower
from ..plan_files import read_plan
from ..timing.squeeze import SECONDS, beyond
from .controllers import Part, parts_of, require_moved, turns_at_start
from .halting import HaltedError, Timer, positions
from .messages import RefusedError, trajectory_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from ..following import Target
    from ..frames import Matrix
    from .halting import Clock
    from .jobs import Found
    from .senses import Joints, ObjectPose
    from .settings import Settings
    from .workers import Alarm

_AHEAD = 2.0  # periods from a target to its time: one may come late
_HOLD = 10  # number of times that the last target is sent, at rest


class Streaming:
    """Publishers of targets.

    Parameters
    ----------
    node : rclpy.node.Node
    settings : Settings
    joints : Joints
    poses : ObjectPose
    clock : Clock
    """

    def __init__(
        self, node: Any, settings: Settings, joints: Joints, poses: ObjectPose, clock: Clock
    ) -> None:
        self._node, self._settings = node, settings
        self._joints, self._poses, self._clock = joints, poses, clock
        self._publishers = {
            each.name: node.create_publisher(JointTrajectory, each.topic, 1)
            for each in settings.controllers
            if each.topic
        }

    def destroy(self) -> None:
        """Destroys the publishers."""
        for publisher in self._publishers.values():
            self._node.destroy_publisher(publisher)

    def execute(self, found: Found, cancel: Alarm, tell: Callable[[str], object]) -> None:
        """Follows a slide by the measured poses of the object.

        Raises
        ------
        RefusedError
            The plan is no slide, or the state of the robot is not known; nothing was moved.
        HaltedError
            The follower has given up, the goal was cancelled, or the state of the robot was lost.
        """
        parts = self._require_ready(found)
        plan: Any = read_plan(found.plan, "plan")
        follower = Follower(plan, **self._settings.limits)
        turns = turns_at_start(found, self._joints, self._settings)
        target = None
        try:
            for planned in self._targets(follower, found, turns, cancel, tell):
                target = dataclasses.replace(planned, position=planned.position + turns)
                ahead = _AHEAD / self._settings.rate
                q = target.position + ahead * target.velocity
                self._send(parts, q, target.velocity, ahead)
                if target.status == "stopped":
                    raise HaltedError("stopped", target.reason)
        except RefusedError as error:
            raise HaltedError("stopped", str(error)) from None
        finally:
            self._hold(parts, target)

    def _require_ready(self, found: Found) -> list[Part]:
        if found.kind != "slide":
            raise RefusedError(f"closed_loop: {found.kind}: only slide plans can be followed")
        parts = parts_of(found, self._settings.controllers)
        require_moved(found, parts)
        for part in parts:
            publisher = self._publishers.get(part.controller.name)
            if publisher is None:
                raise RefusedError(f"parameter {part.controller.name}.topic is empty")
            if None in part.columns:
                raise RefusedError(f"{part.controller.name} has joints that the plan does not move")
            self._await_listener(publisher, part.controller.topic)
        return parts

    def _await_listener(self, publisher: Any, topic: str) -> None:
        end = time.monotonic() + self._settings.controller_seconds
        while not publisher.get_subscription_count():
            if time.monotonic() > end:
                raise RefusedError(f"nobody listens to {topic}")
            time.sleep(0.01)

    def _targets(
        self,
        follower: Follower,
        found: Found,
        turns: Matrix,
        cancel: Alarm,
        tell: Callable[[str], object],
    ) -> Any:
        """Yields targets at the rate of the loop, by the time of the node, without the turns."""
        timer, phase = Timer(self._clock), ""
        period, last = 1 / self._settings.rate, -1.0
        while True:
            if cancel.has_rung:
                raise HaltedError("canceled", "canceled during the execution")
            t = timer.elapsed()
            if t - last < period:
                cancel.wait(min(period, max(1e-3, period - (t - last))))
                continue
            last = t
            q = positions(
                self._joints, found.joint_names, self._settings.joint_state_seconds, timer
            )
            seen = self._poses.take()
            pose, covariance, age = (None, None, 0.0) if seen is None else seen
            target = follower.update(t, q - turns, pose, covariance, age)
            if target.phase != phase:
                phase = target.phase
                tell(phase)
            yield target
            if target.status == "done":
                yield from self._squeeze(target, found, follower.plan, cancel, timer)
                return

    def _squeeze(self, target: Target, found: Found, plan: Any, cancel: Alarm, timer: Timer) -> Any:
        """Yields targets that close the hand on."""
        period = 1 / self._settings.rate
        robot = plan.task.problem.robot
        closed = target.position + beyond(plan, self._settings.squeeze)
        closing = np.clip(closed, robot.lower, robot.upper) - target.position
        for share in np.linspace(0.0, 1.0, max(2, round(SECONDS * self._settings.rate))):
            if cancel.has_rung:
                raise HaltedError("canceled", "canceled during the execution")
            timer.elapsed()
            positions(self._joints, found.joint_names, self._settings.joint_state_seconds, timer)
            velocity = closing / SECONDS if share < 1 else 0 * closing
            position = target.position + share * closing
            yield dataclasses.replace(target, position=position, velocity=velocity)
            cancel.wait(period)

    def _send(self, parts: list[Part], q: Matrix, velocity: Matrix, seconds: float) -> None:
        """Has the robot be at q [dof] so many seconds from now."""
        for part in parts:
            columns = [k for k in part.columns if k is not None]
            message = trajectory_of(
                part.controller.joints, [seconds], [q[columns]], [velocity[columns]]
            )
            self._publishers[part.controller.name].publish(message)

    def _hold(self, parts: list[Part], target: Target | None) -> None:
        """Has the robot rest at the last target."""
        if target is None:
            return
        period = 1 / self._settings.rate
        for _ in range(_HOLD):
            self._send(parts, target.position, 0 * target.position, 10 * period)
            time.sleep(period)
