# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the sliding planner found."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from . import count

if TYPE_CHECKING:
    from ..plans.slide import Plan, Segment


def details(plan: Plan) -> dict[str, Any]:
    """What `--json` prints of this kind alone."""
    return {
        "overhang": plan.overhang if plan else None,
        "segments": [
            {"name": s.name, "rows": len(s), "least_seconds": least_seconds(plan, s)}
            for s in plan.segments
        ],
    }


def lines(plan: Plan) -> list[str]:
    """A line a segment, and how far it slides."""
    return [*(_segment_line(plan, segment) for segment in plan.segments), _slide_line(plan)]


def lines_not_found(plan: Plan) -> list[str]:
    """Why roots and pairs were refused."""
    refusals = plan.statistics.get("refusals", {})
    if not refusals:
        return []
    width = max(map(len, refusals))
    order = sorted(refusals, key=lambda name: -refusals[name])
    return ["refused:", *(f"  {name:{width}}  {refusals[name]}" for name in order)]


def least_seconds(plan: Plan, segment: Segment) -> float | None:
    """How long a segment takes at least, at the joints' speed limits [s]; None without limits."""
    speed = np.asarray(plan.task.problem.robot.max_velocity)
    if len(segment) < 2 or not np.isfinite(speed).all() or (speed <= 0).any():
        return None
    return float((np.abs(np.diff(segment.positions, axis=0)) / speed).max(axis=1).sum())


def _segment_line(plan: Plan, segment: Segment) -> str:
    seconds = least_seconds(plan, segment)
    least = "" if seconds is None else f", at least {seconds:.2f} s"
    number, _, rows = count(len(segment), "rows").partition(" ")
    return f"{segment.name:10}{number:>5} {rows}{least}"


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
