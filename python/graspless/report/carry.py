# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of carries."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from . import refused, segment_details, segment_lines, the

if TYPE_CHECKING:
    from collections.abc import Collection

    from ..carry import Plan


def details(plan: Plan) -> dict[str, Any]:
    """Returns the fields of `--json` that only this kind has."""
    return {
        "reached": plan.reached,
        "place": plan.place,
        "segments": segment_details(plan),
    }


def lines(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns a line per segment, and how far the object moves."""
    return [*segment_lines(plan), f"the hand {moved(plan)}"]


def moved(plan: Plan) -> str:
    """Says in a few words how a solved plan moves its object."""
    problem = plan.task.problem
    start, goal = np.asarray(problem.object.X_WB), plan.segments[-1].object_poses[-1]
    name, length = problem.object.name, float(np.linalg.norm(goal[:3, 3] - start[:3, 3]))
    distance = f"{100 * length:.1f} cm"
    if problem.places is not None:
        return f"puts {the(name)} down on {problem.places.on}, {distance} away"
    angle = np.degrees(frames.angle(start, goal))
    if length < 5e-4:
        return f"turns {the(name)} by {angle:.0f} degrees"
    turned = f", turning it by {angle:.0f} degrees" if angle >= 0.5 else ""
    return f"carries {the(name)} {distance} along a straight path{turned}"


def lines_not_found(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns how far the arm can follow the path, and why steps were rejected."""
    reached = [f"reached: {100 * plan.reached:.0f} % of the path"]
    return [*(reached if plan.task.problem.places is None else []), *refused(plan)]
