# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of carries: the held object moves slowly, and so does a hand that opens."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import joints, paces
from . import settings as defaults
from .joints import Touch, robot

if TYPE_CHECKING:
    from ..carry import Plan
    from .settings import Settings
    from .trajectory import Trajectory


RESTS = ("lower", "open")  # after which contact changes


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """Times the plan."""
    assert settings.robot is not None
    touches = [_touch(plan, segment, settings) for segment in plan.segments]
    return joints.trajectory(plan, plan.segments, touches, settings, rests=RESTS)


def _touch(plan: Plan, segment: Any, settings: Settings) -> Touch:
    assert settings.robot is not None
    default = defaults.CARRY_SPEED if segment.name == "transfer" else defaults.CONTACT_SPEED
    speed, rows = settings.speed(default), slice(0, len(segment))
    if segment.name == "open":
        return Touch(rows, [paces.link_speed(settings.robot, speed)])
    return Touch(rows, [paces.frame_speed(settings.robot, plan.task.problem.frame, speed)])


__all__ = ["robot", "trajectory"]
