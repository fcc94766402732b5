# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of the actions, from what was found and how it ended."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING, Any

from graspless_msgs.action import PickObject, PlanTask
from graspless_msgs.msg import Attempt, Margin, Motion

from .controllers import parts_of
from .messages import poses_of, trajectory_of

if TYPE_CHECKING:
    from .goals import Ending
    from .jobs import Found
    from .settings import Settings


def motion_of(ending: Ending, settings: Settings, stamp: Any) -> Any:
    """Returns the message Motion."""
    found = ending.found
    motion = Motion(status=ending.status, reason=ending.reason, seconds=ending.seconds)
    motion.warnings, motion.plan = list(found.warnings), found.plan
    motion.margins = [Margin(name=name, value=value) for name, value in found.margins]
    motion.object_poses.header.frame_id = settings.world_frame
    if found.times is None:
        return motion
    found = found.with_mimics(settings.joints)
    motion.object_poses = poses_of(found.object_poses, settings.world_frame, stamp)
    for name, names, columns in split(found, settings):
        motion.controllers.append(name)
        motion.trajectories.append(
            trajectory_of(
                names,
                found.times,
                found.positions[:, columns],
                found.velocities[:, columns],
                found.accelerations[:, columns],
            )
        )
    return motion


def split(found: Found, settings: Settings) -> list[tuple[str, list[str], list[int]]]:
    """Returns name, joints and columns of each controller; without any, of all joints."""
    if not settings.controllers:
        return [("", found.joint_names, list(range(len(found.joint_names))))]
    parts = []
    for part in parts_of(found, settings.controllers):
        columns = [k for k in part.columns if k is not None]
        parts.append((part.controller.name, [found.joint_names[k] for k in columns], columns))
    return parts


def task_result(ending: Ending, settings: Settings, stamp: Any) -> Any:
    """Returns the result of PlanTask."""
    return PlanTask.Result(motion=motion_of(ending, settings, stamp))


def pick_result(ending: Ending, settings: Settings, stamp: Any) -> Any:
    """Returns the result of PickObject."""
    found = ending.found
    result = PickObject.Result(motion=motion_of(ending, settings, stamp))
    result.name, result.strategy = found.name, found.strategy
    result.attempts = [
        Attempt(strategy=strategy, status=status, reason=reason, seconds=seconds)
        for strategy, status, reason, seconds in found.attempts
    ]
    result.objects = [name for name, _ in found.objects]
    result.poses = poses_of([X for _, X in found.objects], settings.world_frame, stamp)
    return result


class Kept:
    """The motions that are kept: the newest ones, since a motion takes megabytes in Python.

    Parameters
    ----------
    most : int
        Largest size of all as messages [bytes]. The newest one may be larger.
    """

    def __init__(self, most: int) -> None:
        self._most, self._size = most, 0
        self._motions: deque[tuple[int, Any]] = deque()

    def add(self, motion: Any) -> None:
        """Adds the message of a result. The oldest ones lose plan, trajectories and poses."""
        if not motion.plan:
            return
        self._motions.append((bytes_of(motion), motion))
        self._size += self._motions[-1][0]
        while len(self._motions) > 1 and self._size > self._most:
            size, oldest = self._motions.popleft()
            self._size -= size
            oldest.plan, oldest.controllers, oldest.trajectories = "", [], []
            oldest.object_poses.poses = []
            oldest.warnings.append("the motion is not kept any more: ask for results sooner")


def bytes_of(motion: Any) -> int:
    """Returns the size of plan, trajectories and poses in a Motion, without names [bytes]."""
    rows = sum(len(each.points) * (24 * len(each.joint_names) + 24) for each in motion.trajectories)
    return rows + 56 * len(motion.object_poses.poses) + len(motion.plan)
