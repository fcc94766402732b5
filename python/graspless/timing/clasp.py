# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of clasps: the hand closes slowly."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import joints
from . import settings as defaults
from .joints import robot

if TYPE_CHECKING:
    from ..clasp import Plan
    from .settings import Settings
    from .trajectory import Trajectory


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """Times the plan."""
    assert settings.robot is not None
    robot, speed = settings.robot, settings.speed(defaults.CONTACT_SPEED)
    touches = [
        joints.closing(segment, robot, speed) if segment.name == "close" else None
        for segment in plan.segments
    ]
    return joints.trajectory(plan, plan.segments, touches, settings)


__all__ = ["robot", "trajectory"]
