# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Chains in time: stage after stage, each as its own kind."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..kinds import part
from .trajectory import concatenated

if TYPE_CHECKING:
    from ..plans.chain import Plan
    from ..robot import Robot
    from .settings import Settings
    from .trajectory import Trajectory


def robot(plan: Plan, fingers: bool) -> Robot | None:
    """That all stages were made for."""
    robots = [part("timing", stage.kind).robot(stage, fingers) for stage in plan.stages]
    first: Robot | None = robots[0]
    return first


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """The plan in time."""
    stages = [part("timing", stage.kind).trajectory(stage, settings) for stage in plan.stages]
    return concatenated(plan, stages, settings.pause)
