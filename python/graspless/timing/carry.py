# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of carries: the held object moves slowly."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import joints, paces
from . import settings as defaults
from .joints import Touch, robot

if TYPE_CHECKING:
    from ..carry import Plan
    from .settings import Settings
    from .trajectory import Trajectory


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """Times the plan."""
    assert settings.robot is not None
    speed = settings.speed(defaults.CONTACT_SPEED)
    slow = [paces.frame_speed(settings.robot, plan.task.problem.frame, speed)]
    touches = [
        Touch(slice(0, len(segment)), slow) if segment.name == "carry" else None
        for segment in plan.segments
    ]
    return joints.trajectory(plan, plan.segments, touches, settings)


__all__ = ["robot", "trajectory"]
