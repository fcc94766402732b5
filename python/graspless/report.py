# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a plan found, in a few lines or as a dictionary."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from .plans import Plan, Segment


MOST = 5  # faults of one segment that are printed


def as_dict(plan: Plan) -> dict[str, Any]:
    """Status, statistics and the rows of each segment: what `--json` prints."""
    return {
        "status": plan.status,
        "reason": plan.reason,
        "seed": plan.fields.seed,
        "overhang": plan.overhang if plan else None,
        "stats": plan.statistics,
        "segments": [
            {"name": s.name, "rows": len(s), "least_seconds": least_seconds(plan, s)}
            for s in plan.segments
        ],
    }


def as_text(plan: Plan) -> str:
    """A few lines for people."""
    stats = plan.statistics
    lines = [f"{plan.status} in {_duration(stats.get('seconds', 0))}, seed {plan.fields.seed}"]
    if plan:
        lines += [_segment_line(plan, segment) for segment in plan.segments]
        lines.append(f"  {_slide_line(plan)}")
    else:
        lines.append(f"  {plan.reason}")
    names = [name for name in stats if name not in ("seconds", "refusals")]
    counters = [_count(stats[name], name.replace("_", " ")) for name in names]
    lines.append("  " + ", ".join(counters))
    refusals = stats.get("refusals", {})
    if refusals and not plan:
        lines.append("  refused:")
        width = max(map(len, refusals))
        order = sorted(refusals, key=lambda name: -refusals[name])
        lines += [f"    {name:{width}}  {refusals[name]}" for name in order]
    return "\n".join(lines)


def verdict(plan: Plan, faults: list[str]) -> str:
    """What `check` says about a plan."""
    if faults:
        return "\n".join(["does not hold:" if plan else "not solved:", *_shortened(faults)])
    if not plan:
        return "nothing to check: not solved"
    rows = sum(map(len, plan.segments))
    segments = _count(len(plan.segments), "segments")
    return f"holds: {segments}, {_count(rows, 'rows')}, replayed by code of its own"


def least_seconds(plan: Plan, segment: Segment) -> float | None:
    """How long a segment takes at least, at the joints' speed limits [s]; None without limits."""
    speed = np.asarray(plan.task.problem.robot.max_velocity)
    if len(segment) < 2 or not np.isfinite(speed).all() or (speed <= 0).any():
        return None
    return float((np.abs(np.diff(segment.positions, axis=0)) / speed).max(axis=1).sum())


def _shortened(faults: list[str]) -> list[str]:
    """The first faults of each segment, and how many there are."""
    segments: dict[str, list[str]] = {}
    for fault in faults:
        segments.setdefault(re.split(r"\W", fault, maxsplit=1)[0], []).append(fault)
    lines = []
    for name, found in segments.items():
        lines += found[:MOST]
        if len(found) > MOST:
            lines.append(f"{name}: {len(found) - MOST} more")
    return [*lines, _count(len(faults), "faults")] if len(faults) > 1 else lines


def _count(number: float, things: str) -> str:
    return f"{number} {things.removesuffix('s') if number == 1 else things}"


def _segment_line(plan: Plan, segment: Segment) -> str:
    seconds = least_seconds(plan, segment)
    least = "" if seconds is None else f", at least {seconds:.2f} s"
    return f"  {segment.name:10}{len(segment):5} {'row' if len(segment) == 1 else 'rows'}{least}"


def _slide_line(plan: Plan) -> str:
    start, goal = np.asarray(plan.task.problem.X_WO_start), plan.X_WO_goal
    distance = float(np.linalg.norm(goal[:3, 3] - start[:3, 3]))
    R = start[:3, :3].T @ goal[:3, :3]
    turn = math.degrees(math.atan2(R[1, 0], R[0, 0]))
    name = plan.task.problem.object.name
    moved = f"{name} slides {distance * 100:.1f} cm, turns {turn:.0f} deg"
    return f"{moved} and sticks out {plan.overhang * 100:.1f} cm"


def _duration(seconds: float) -> str:
    return f"{seconds * 1000:.1f} ms" if seconds < 1 else f"{seconds:.2f} s"
