# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the sliding planner found."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from . import least_seconds, refused, segment_line

if TYPE_CHECKING:
    from ..plans.slide import Plan


def details(plan: Plan) -> dict[str, Any]:
    """What `--json` prints of this kind alone."""
    return {
        "overhang": plan.overhang if plan else None,
        "warnings": plan.warnings,
        "segments": [
            {"name": s.name, "rows": len(s), "least_seconds": least_seconds(plan, s)}
            for s in plan.segments
        ],
    }


def lines(plan: Plan) -> list[str]:
    """A line a segment, how far it slides, and what to be careful of."""
    found = [*(segment_line(plan, segment) for segment in plan.segments), _slide_line(plan)]
    return [*found, *(f"warning: {warning}" for warning in plan.warnings)]


def lines_not_found(plan: Plan) -> list[str]:
    """Why roots and pairs were refused."""
    return refused(plan)


def _slide_line(plan: Plan) -> str:
    start, goal = np.asarray(plan.task.problem.X_WO_start), plan.X_WO_goal
    distance = float(np.linalg.norm(goal[:3, 3] - start[:3, 3]))
    R = start[:3, :3].T @ goal[:3, :3]
    turn = math.degrees(math.atan2(R[1, 0], R[0, 0]))
    name = plan.task.problem.object.name
    slides = [
        segment.object_poses[:, :3, 3] for segment in plan.segments if segment.name == "slide"
    ]
    way = sum(float(np.linalg.norm(np.diff(p, axis=0), axis=1).sum()) for p in slides)
    along = f" on a way of {way * 100:.1f} cm"
    moved = f"{name} slides {distance * 100:.1f} cm{along}, turns {turn:.0f} deg"
    return f"{moved} and sticks out {plan.overhang * 100:.1f} cm"
