# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of pinches: as the last two segments of a slide, which are the same."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import joints
from .joints import robot
from .slide import touch

if TYPE_CHECKING:
    from ..pinch import Plan
    from .settings import Settings
    from .trajectory import Trajectory


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """Times the plan."""
    touches = [touch(plan.task.problem, segment, settings) for segment in plan.segments]
    return joints.trajectory(plan, plan.segments, touches, settings, rests=("grasp",))


__all__ = ["robot", "trajectory"]
