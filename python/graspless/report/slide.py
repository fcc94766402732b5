# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of slides."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from . import refused, segment_details, segment_lines, the, warning_lines

if TYPE_CHECKING:
    from collections.abc import Collection

    from ..slide import Plan


def details(plan: Plan) -> dict[str, Any]:
    """Returns the fields of `--json` that only this kind has."""
    return {
        "overhang": plan.overhang if plan and plan.task.problem.X_WO_end is None else None,
        "tube": {"position": list(plan.tube.position), "angle": list(plan.tube.angle)},
        "warnings": list(plan.warnings),
        "segments": segment_details(plan),
    }


def lines(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns a line per segment, the slide's distance and overhang, and the warnings."""
    found = [*segment_lines(plan), _slide_line(plan)]
    if plan.tube.position:
        found.append(_tube_line(plan))
    return [*found, *warning_lines(plan, told)]


def lines_not_found(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns why start and goal contacts and their pairs were rejected."""
    return refused(plan)


def _tube_line(plan: Plan) -> str:
    position, angle = 1000 * plan.tube.position[-1], math.degrees(plan.tube.angle[-1])
    return f"after the slide, it may be {position:.1f} mm and {angle:.1f} deg off this plan"


def _slide_line(plan: Plan) -> str:
    start, goal = plan.X_WO_start, plan.X_WO_goal
    distance = float(np.linalg.norm(goal[:3, 3] - start[:3, 3]))
    R = start[:3, :3].T @ goal[:3, :3]
    turn = math.degrees(math.atan2(R[1, 0], R[0, 0]))
    name = plan.task.problem.object.name
    slides = [
        segment.object_poses[:, :3, 3] for segment in plan.segments if segment.name == "slide"
    ]
    path = sum(float(np.linalg.norm(np.diff(p, axis=0), axis=1).sum()) for p in slides)
    along = f"along a path of {path * 100:.1f} cm"
    moved = f"{the(name)} slides {distance * 100:.1f} cm {along} and turns {turn:.0f} deg"
    if plan.task.problem.X_WO_end is not None:
        return f"{moved}, and is left there"
    needed = 100 * plan.task.options.min_overhang
    out = f"overhang {plan.overhang * 100:.1f} cm (at least {needed:.1f} cm needed to grasp it)"
    return f"{moved}; {out}"
