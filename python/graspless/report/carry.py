# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of carries."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import least_seconds, refused, segment_line

if TYPE_CHECKING:
    from ..carry import Plan


def details(plan: Plan) -> dict[str, Any]:
    """Returns the fields of `--json` that only this kind has."""
    return {
        "reached": plan.reached,
        "segments": [
            {"name": s.name, "rows": len(s), "least_seconds": least_seconds(plan, s)}
            for s in plan.segments
        ],
    }


def lines(plan: Plan) -> list[str]:
    """Returns a line per segment, and how far the object moves."""
    problem = plan.task.problem
    start, goal = np.asarray(problem.object.X_WB), np.asarray(problem.X_WO_goal)
    distance = float(np.linalg.norm(goal[:3, 3] - start[:3, 3]))
    name = problem.object.name
    moved = f"the hand carries the {name} {distance * 100:.1f} cm along a straight path"
    return [*(segment_line(plan, segment) for segment in plan.segments), moved]


def lines_not_found(plan: Plan) -> list[str]:
    """Returns how far the arm can follow the path, and why steps were rejected."""
    return [f"reached: {100 * plan.reached:.0f} % of the path", *refused(plan)]
