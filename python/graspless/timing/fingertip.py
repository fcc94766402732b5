# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of fingertip plans, with or without an arm: slow relative to their stability."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from . import settings as defaults
from .clip import Clip, clip
from .limits import Limits, Zone
from .object_path import ObjectPath
from .paces import frame_speed
from .regrasp import regrasp
from .trajectory import assembled

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .._core.robot import Robot
    from ..fingertip import JointSegment, Plan, Segment
    from ..frames import Matrix
    from .settings import Settings
    from .trajectory import Trajectory


def robot(plan: Plan, fingers: bool) -> Robot | None:
    """Returns the robot of the plan; None for bare fingertips."""
    if fingers or not plan.joint_segments:
        return None
    mine: Robot = plan.task.arm.robot
    return mine


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """Times the plan."""
    if settings.robot is None:
        segments: list[Any] = list(plan.segments)
        timed = [_bare(plan, i, settings) for i in range(len(segments))]
        names = []
    else:
        segments = list(plan.joint_segments)
        timed = [_carried(plan, segment, settings) for segment in segments]
        names = list(settings.robot.joint_names)
    clips, poses = zip(*timed, strict=True)
    return assembled(plan, segments, names, list(clips), list(poses), [settings.pause] * len(clips))


def _bare(plan: Plan, index: int, settings: Settings) -> tuple[Clip, Matrix]:
    """Times a segment without joints; returns it with the poses of the object."""
    segment = plan.segments[index]
    if segment.name == "regrasp":
        timed = regrasp(plan, index, settings)
        return timed, np.repeat(segment.object_poses[:1], len(timed.times), axis=0)
    ends = segment.X_WO[:1], segment.object_poses, segment.X_WO[-1:]
    path = ObjectPath(plan.task.problem.object, np.concatenate(ends))
    points = path.coordinates()
    zone = Zone(slice(0, len(points)), _limits(path, segment, settings), _object_tolerance())
    timed = clip(points, [zone], settings.rate)
    poses = path.at(timed.coordinates, timed.rows)
    last = len(path.poses) - 1  # rows lie in the middle of their parts of the way: half a row
    rows = np.interp(timed.rows, np.arange(last + 1), [-0.5, *range(last - 1), last - 1.5])
    return Clip(timed.times, rows, *(np.zeros((len(rows), 0)) for _ in range(3))), poses


def _limits(path: ObjectPath, segment: Segment, settings: Settings) -> Limits:
    acceleration = path.acceleration(float(segment.stability.min()))
    slow = path.slow(segment.name, settings.speed(defaults.FINGERTIP_SPEED))
    return Limits(np.full(6, np.inf), acceleration, np.full(6, np.inf), [slow])


def _carried(plan: Plan, segment: JointSegment, settings: Settings) -> tuple[Clip, Matrix]:
    """Times a segment of joint motion; returns it with the poses of the object."""
    moved = plan.segments[segment.plan_segment] if segment.plan_segment >= 0 else None
    if moved is None or moved.name == "regrasp":
        return _free(plan, segment, settings)
    path = ObjectPath(plan.task.problem.object, segment.object_poses)
    of_object = _limits(path, moved, settings)
    dof = len(settings.velocity)
    limits = Limits(
        np.append(settings.velocity, of_object.velocity),
        np.append(settings.acceleration * defaults.CONTACT_SHARE, of_object.acceleration),
        np.append(settings.jerk * defaults.CONTACT_SHARE, of_object.jerk),
        of_object.paces,
    )
    tolerance = np.append(np.full(dof, defaults.CONTACT_TOLERANCE), _object_tolerance())
    points = np.hstack([segment.positions, path.coordinates()])
    timed = clip(points, [Zone(slice(0, len(points)), limits, tolerance)], settings.rate)
    return timed, path.at(timed.coordinates[:, dof:], timed.rows)


def _free(plan: Plan, segment: JointSegment, settings: Settings) -> tuple[Clip, Matrix]:
    """Times joint motion while the object rests."""
    assert settings.robot is not None
    share, tolerance = 1.0, defaults.TOLERANCE
    tips: Sequence[str] = ()
    if segment.name in ("touch", "release"):
        tips = plan.task.arm.carrier.fingertips
    if tips or segment.plan_segment >= 0:  # in a regrasp the other fingers hold
        share, tolerance = defaults.CONTACT_SHARE, defaults.CONTACT_TOLERANCE
    speed = settings.speed(defaults.FINGERTIP_SPEED)
    paces = [frame_speed(settings.robot, tip, speed) for tip in tips]
    limits = Limits(settings.velocity, settings.acceleration * share, settings.jerk * share, paces)
    zone = Zone(slice(0, len(segment)), limits, np.full(len(settings.velocity), tolerance))
    timed = clip(segment.positions, [zone], settings.rate)
    return timed, frames.along(segment.object_poses, timed.rows)


def _object_tolerance() -> Matrix:
    return np.full(6, defaults.OBJECT_TOLERANCE)
