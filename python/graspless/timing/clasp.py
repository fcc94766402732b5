# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clasps in time: the hand closes slowly."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..errors import TaskError
from . import joints, paces
from . import settings as defaults

if TYPE_CHECKING:
    from ..plans.clasp import Plan
    from ..robot import Robot
    from .settings import Settings
    from .trajectory import Trajectory


def robot(plan: Plan, fingers: bool) -> Robot:
    """That the plan was made for."""
    if fingers:
        raise TaskError(f"fingers: {fingers}: a {plan.kind} plan has no bare fingertips")
    mine: Robot = plan.task.problem.robot
    return mine


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """The plan in time."""
    assert settings.robot is not None
    slow = {"close": [paces.link_speed(settings.robot, settings.speed(defaults.CONTACT_SPEED))]}
    return joints.trajectory(plan, plan.segments, slow, settings)
