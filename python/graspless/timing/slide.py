# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of slides: parts in contact, or about to be, move slowly."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import joints, paces
from . import settings as defaults
from .joints import robot

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..slide import Plan
    from .fastest import Pace
    from .settings import Settings
    from .trajectory import Trajectory


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """Times the plan."""
    return joints.trajectory(plan, plan.segments, slow(plan, settings), settings)


def slow(plan: Plan, settings: Settings) -> dict[str, Sequence[Pace]]:
    """Returns the speed limits of each segment that touches something, by its name."""
    assert settings.robot is not None
    hand, speed = plan.task.problem.hand, settings.speed(defaults.CONTACT_SPEED)
    tip = [paces.frame_speed(settings.robot, hand.fingertip, speed)]
    return {
        "retreat": tip,
        "press": tip,
        "slide": tip,
        "lift": tip,
        "grasp": [paces.frame_speed(settings.robot, hand.grasp_frame, speed)],
        "close": [paces.link_speed(settings.robot, speed)],
    }


__all__ = ["robot", "slow", "trajectory"]
