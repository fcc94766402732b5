# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clasps in time: the hand closes slowly."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import joints, paces

if TYPE_CHECKING:
    from ..plans.clasp import Plan
    from ..robot import Robot
    from .settings import Settings
    from .trajectory import Trajectory


def robot(plan: Plan) -> Robot:
    """That the plan was made for."""
    mine: Robot = plan.task.problem.robot
    return mine


def trajectory(plan: Plan, settings: Settings, rate: float, pause: float) -> Trajectory:
    """The plan in time."""
    assert settings.robot is not None
    slow = {"close": [paces.link_speed(settings.robot, settings.contact_speed)]}
    return joints.trajectory(plan, plan.segments, slow, settings, rate, pause)
