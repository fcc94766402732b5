# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of segments of joint positions, as in slide and clasp plans."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .. import frames
from ..errors import TaskError
from . import settings as defaults
from .clip import clip, split
from .limits import Limits, Zone
from .paces import link_speed
from .trajectory import assembled

if TYPE_CHECKING:
    from collections.abc import Collection, Sequence
    from typing import Any

    from .._core.robot import Robot
    from .._plan import Plan
    from ..frames import Matrix
    from .limits import Pace
    from .settings import Settings
    from .trajectory import Trajectory


def robot(plan: Any, fingers: bool) -> Robot:
    """Returns the robot of the plan."""
    if fingers:
        raise TaskError(f"fingers: {fingers}: a {plan.kind} plan has no bare fingertips")
    mine: Robot = plan.task.problem.robot
    return mine


@dataclass(frozen=True)
class Touch:
    """Rows of a segment in which something touches, or is about to.

    Attributes
    ----------
    rows : slice
    paces : list of callable
        Speed limits of what touches.
    """

    rows: slice
    paces: Sequence[Pace]


def trajectory(
    plan: Plan,
    segments: Sequence[Any],
    touches: Sequence[Touch | None],
    settings: Settings,
    rests: Collection[str] = (),
) -> Trajectory:
    """Times segments of `positions` [N, dof] and `object_poses` [N, 4, 4].

    The joints rest after the segments named in `rests`, where contacts change.
    """
    assert settings.robot is not None
    clips, pauses = [], []
    for run in _runs(segments, rests):
        points = np.concatenate([s.positions[min(k, 1) :] for k, s in enumerate(segments[run])])
        marks = np.cumsum([len(s.positions) - 1 for s in segments[run]]).tolist()
        zones = [
            zone
            for start, segment, touch in zip([0, *marks], segments[run], touches[run], strict=False)
            for zone in zones_of(segment, touch, settings, start)
        ]
        whole = clip(points, zones, settings.rate, marks[:-1])
        clips += split(whole, marks)
        pauses += [0.0] * (len(marks) - 1) + [settings.pause]
    poses = [
        frames.along(segment.object_poses, timed.rows)
        for segment, timed in zip(segments, clips, strict=True)
    ]
    names = list(settings.robot.joint_names)
    return assembled(plan, list(segments), names, clips, poses, pauses)


def closing(segment: Any, robot: Robot, speed: float) -> Touch:
    """Returns where a closing hand is about to touch: no point of a link moves by more after it."""
    reach = np.array([robot.reach(frame) for frame in robot.frame_names])
    left = (np.abs(segment.positions - segment.positions[-1]) @ reach.T).max(axis=1)
    return Touch(nearing(left, defaults.GUARD), [link_speed(robot, speed)])


def nearing(distances: Matrix, guard: float) -> slice:
    """Returns the rows from the last one that is farther than `guard` from the contact [N]."""
    far = np.flatnonzero(distances > guard)
    return slice(int(far[-1]) if len(far) else 0, len(distances))


def leaving(distances: Matrix, guard: float) -> slice:
    """Returns the rows up to the first one that is farther than `guard` from the contact [N]."""
    far = np.flatnonzero(distances > guard)
    return slice(0, int(far[0]) + 1 if len(far) else len(distances))


def _runs(segments: Sequence[Any], rests: Collection[str]) -> list[slice]:
    """Returns segments that are timed as one motion; one that does not move is on its own."""
    runs, first = [], 0
    for k, segment in enumerate(segments):
        last = k + 1 == len(segments)
        if last or segment.name in rests or not (_moves(segment) and _moves(segments[k + 1])):
            runs.append(slice(first, k + 1))
            first = k + 1
    return runs


def _moves(segment: Any) -> bool:
    return bool(np.ptp(segment.positions, axis=0).max() > 1e-6)


def zones_of(segment: Any, touch: Touch | None, settings: Settings, start: int = 0) -> list[Zone]:
    """Returns the zones of a segment whose first row has the number `start`."""
    count, dof = len(segment.positions), len(settings.velocity)
    free = Limits(settings.velocity, settings.acceleration, settings.jerk)
    if touch is None:
        return [Zone(slice(start, start + count), free, np.full(dof, defaults.TOLERANCE))]
    share = defaults.CONTACT_SHARE
    slow = Limits(
        settings.velocity, settings.acceleration * share, settings.jerk * share, touch.paces
    )
    near, far = np.full(dof, defaults.CONTACT_TOLERANCE), np.full(dof, defaults.TOLERANCE)
    first, stop = start + touch.rows.start, start + touch.rows.stop
    zones = [
        Zone(slice(start, first + 1), free, far),
        Zone(slice(first, stop), slow, near),
        Zone(slice(stop - 1, start + count), free, far),
    ]
    return [zone for zone in zones if zone.rows.stop - zone.rows.start > 1] or zones[1:2]
