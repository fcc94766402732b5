# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of segments of joint positions, as in slide and clasp plans."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import frames
from ..errors import TaskError
from . import settings as defaults
from .clip import clip
from .fastest import Limits
from .trajectory import assembled

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

    from .._plan import Plan
    from ..frames import Matrix
    from ..robot import Robot
    from .fastest import Pace
    from .settings import Settings
    from .trajectory import Trajectory


def robot(plan: Any, fingers: bool) -> Robot:
    """Returns the robot of the plan."""
    if fingers:
        raise TaskError(f"fingers: {fingers}: a {plan.kind} plan has no bare fingertips")
    mine: Robot = plan.task.problem.robot
    return mine


def trajectory(
    plan: Plan,
    segments: Sequence[Any],
    slow: Mapping[str, Sequence[Pace]],
    settings: Settings,
) -> Trajectory:
    """Times segments of `positions` [N, dof] and `object_poses` [N, 4, 4].

    `slow` are the speed limits of a segment, by its name.
    """
    assert settings.robot is not None
    clips = [
        clip(segment.positions, *of_segment(segment.name, slow, settings), settings.rate)
        for segment in segments
    ]
    poses = [
        frames.along(segment.object_poses, timed.rows)
        for segment, timed in zip(segments, clips, strict=True)
    ]
    names = list(settings.robot.joint_names)
    return assembled(plan, list(segments), names, clips, poses, settings.pause)


def of_segment(
    name: str, slow: Mapping[str, Sequence[Pace]], settings: Settings
) -> tuple[Matrix, Limits]:
    """Returns the tolerance [dof] of a segment's corners, and the limits of its motion."""
    touching = name in slow
    tolerance = defaults.CONTACT_TOLERANCE if touching else defaults.TOLERANCE
    acceleration = settings.acceleration * (defaults.CONTACT_SHARE if touching else 1.0)
    tolerances = np.full(len(settings.velocity), tolerance)
    return tolerances, Limits(settings.velocity, acceleration, slow.get(name, ()))
