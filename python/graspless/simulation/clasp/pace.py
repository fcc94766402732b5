# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A slow steady pace, until graspless.time() is there."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...timing import Trajectory

if TYPE_CHECKING:
    from ...plans import Plan

_SPEED = 0.6  # of the fastest joint [rad/s]


def timed(plan: Plan) -> Trajectory:
    """Every row after the one before at one speed of the fastest joint."""
    q = np.concatenate([s.positions for s in plan.segments])
    poses = np.concatenate([s.object_poses for s in plan.segments])
    index = np.concatenate([np.full(len(s), i) for i, s in enumerate(plan.segments)])
    rows = np.concatenate([np.arange(len(s), dtype=float) for s in plan.segments])
    steps = np.maximum(np.abs(np.diff(q, axis=0)).max(axis=1) / _SPEED, 1e-3)
    times = np.concatenate([[0.0], np.cumsum(steps)])
    zero = np.zeros_like(q)
    names = plan.task.problem.robot.joint_names
    return Trajectory(plan, plan.segments, times, index, rows, list(names), q, zero, zero, poses)
