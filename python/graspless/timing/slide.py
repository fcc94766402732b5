# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of slides: parts in contact, or about to be, move slowly.

The joints rest when the finger has pressed, when it has slid, and before the hand closes: there
contacts change.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import joints, paces
from . import settings as defaults
from .joints import Touch, leaving, nearing, robot

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..slide import Plan, Problem
    from .settings import Settings
    from .trajectory import Trajectory


RESTS = ("press", "slide", "grasp")  # after which contact changes, or the hand


def trajectory(plan: Plan, settings: Settings) -> Trajectory:
    """Times the plan."""
    touches = [touch(plan.task.problem, segment, settings) for segment in plan.segments]
    return joints.trajectory(plan, plan.segments, touches, settings, rests=RESTS)


def touch(problem: Problem, segment: Any, settings: Settings) -> Touch | None:
    """Returns where a segment touches something or is about to, and its speed limits there."""
    assert settings.robot is not None
    robot, speed = settings.robot, settings.speed(defaults.CONTACT_SPEED)
    if segment.name == "close":
        return joints.closing(segment, robot, speed)
    if segment.name == "grasp":
        hand = paces.frame_speed(robot, problem.hand.grasp_frame, speed)
        return Touch(slice(0, len(segment)), [hand])
    if segment.name not in ("retreat", "press", "slide", "lift"):
        return None
    rows = slice(0, len(segment))
    if segment.name != "slide":
        near = nearing if segment.name == "press" else leaving
        rows = near(_heights(problem, segment.positions), defaults.GUARD)
    return Touch(rows, [paces.frame_speed(robot, problem.hand.fingertip, speed)])


def _heights(problem: Problem, positions: Matrix) -> Matrix:
    """Returns the heights of the fingertip over the face that it presses on [N] [m]."""
    tips = [problem.robot.pose(problem.hand.fingertip, q)[:3, 3] for q in positions]
    X_WS = problem.support.X_WS
    heights: Matrix = (np.array(tips) - X_WS[:3, 3]) @ X_WS[:3, 2] - problem.object.top
    return heights


__all__ = ["robot", "touch", "trajectory"]
