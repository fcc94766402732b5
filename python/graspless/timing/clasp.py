# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of clasps: the hand closes slowly."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import joints, paces
from . import settings as defaults
from .joints import robot

if TYPE_CHECKING:
    from ..clasp import Plan
    from .settings import Settings
    from .trajectory import Trajectory


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """Times the plan."""
    assert settings.robot is not None
    slow = {"close": [paces.link_speed(settings.robot, settings.speed(defaults.CONTACT_SPEED))]}
    return joints.trajectory(plan, plan.segments, slow, settings)


__all__ = ["robot", "trajectory"]
