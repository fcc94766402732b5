# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of chains: one stage after the other, each by its own kind."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

import numpy as np

from ..kinds import part
from .trajectory import concatenated

if TYPE_CHECKING:
    from .._core.robot import Robot
    from ..chain import Plan
    from .settings import Settings
    from .trajectory import Trajectory


def robot(plan: Plan, fingers: bool) -> Robot | None:
    """Returns the robot that all stages share."""
    robots = [part("timing", stage.kind).robot(stage, fingers) for stage in plan.stages]
    first: Robot | None = robots[0]
    return first


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """Times the plan. Object poses are those of the object of the first stage."""
    stages = [part("timing", stage.kind).trajectory(stage, settings) for stage in plan.stages]
    of_first = [
        dataclasses.replace(stage, object_poses=stage.object_poses @ np.linalg.inv(X_OO))
        for stage, X_OO in zip(stages, plan.object_frames, strict=True)
    ]
    return concatenated(plan, of_first, settings.pause)
