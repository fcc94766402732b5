# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of fingertip plans."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from . import count, head, warning_lines

if TYPE_CHECKING:
    from collections.abc import Collection

    from ..fingertip import JointSegment, Plan, Segment
    from ..frames import Matrix

UNITS = {"fingers.max_normal_force": " N", "min_stability": " N"}


def details(plan: Plan) -> dict[str, Any]:
    """Returns the fields of `--json` that only this kind has."""
    weakest = plan.weakest
    return {
        "cost": plan.cost,
        "lower_bound": plan.lower_bound,
        "regrasps": plan.regrasps,
        "withstands": plan.withstands,
        "place_tolerance": plan.place_tolerance,
        "weakest": None if weakest is None else {"segment": weakest[0], "row": weakest[1]},
        "warnings": list(plan.warnings),
        "limit": plan.limit,
        "relaxations": [{"field": r.field, "value": r.value} for r in plan.relaxations],
        "segments": [
            {
                "name": s.name,
                "rows": len(s),
                "finger": s.finger,
                "least_stability": float(s.stability.min()) if len(s) else None,
                "withstands": float(s.withstands.min()) if len(s) else None,
                "place_tolerance": float(s.place_tolerance.min()) if len(s) else None,
            }
            for s in plan.segments
        ],
        "joint_segments": [
            {"name": s.name, "rows": len(s), "scrub": s.scrub} for s in plan.joint_segments
        ],
    }


def lines(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns the cost, a line per segment, and the weakest row."""
    cost, bound = plan.cost or 0.0, plan.lower_bound
    optimal = bound is not None and cost - bound <= 1e-9 * max(1.0, cost)
    gap = (
        "the least possible on this lattice"
        if optimal
        else f"at least {_length(bound)} on any plan"
    )
    found = [f"cost {_cost(plan)}: {gap}"]
    found += warning_lines(plan, told)
    found += [_segment_line(segment) for segment in plan.segments]
    found += [_joint_line(segment) for segment in plan.joint_segments]
    if plan.weakest is not None:
        assert plan.withstands is not None  # both are set once a plan is solved
        assert plan.place_tolerance is not None
        k, row = plan.weakest
        weak = plan.segments[k]
        where = f"row {row} of {_name(weak)}" if len(plan.segments) == 1 else _place(k, row, weak)
        z, compliant = weak.stability[row], weak.compliant_stability[row]
        found.append(
            f"weakest at {where}: stability z {z:.3g} N "
            f"(at least {plan.task.options.min_stability:.3g} N needed), "
            f"{compliant:.3g} N with contacts as springs (compliant index)"
        )
        found.append(
            f"every row withstands {plan.withstands:.3g} N in any direction with the fingers in "
            f"place; without a push, each may be up to {1e6 * plan.place_tolerance:.3g} um out of "
            "place"
        )
    return found


def lines_not_found(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns the limit that rules out every plan, and the least changes that would help."""
    found = [f"limiting condition: {plan.limit}"] if plan.limit else []
    return found + [
        f"one change that would suffice: {r.field} {r.value:.4g}{UNITS.get(r.field, '')}"
        for r in plan.relaxations
    ]


def _segment_line(segment: Segment) -> str:
    title = f"{head(segment):21}"
    if segment.name == "regrasp":
        return f"{title} finger {segment.finger} moves, z {segment.stability.min():.3g} N"
    return f"{title} {_moved(segment)}, z {_range(segment.stability)} N, {_modes(segment)}"


def _joint_line(segment: JointSegment) -> str:
    slips = (
        f", a fingertip slips by up to {1000 * segment.scrub:.1f} mm"
        if segment.scrub > 5e-5
        else ""
    )
    return f"  arm: {head(segment)}{slips}"


def travelled(X_WO: Matrix, name: str) -> float:
    """Returns the length of a slide [cm], or the angle of any other motion [degrees]."""
    if name == "slide":
        return float(100 * np.linalg.norm(np.diff(X_WO[:, :3, 3], axis=0), axis=1).sum())
    return math.degrees(sum(frames.angle(a, b) for a, b in pairwise(X_WO)))


def _moved(segment: Segment) -> str:
    far = travelled(segment.X_WO, segment.name)
    return f"{far:.1f} cm" if segment.name == "slide" else f"{far:.0f} deg"


def _modes(segment: Segment) -> str:
    """Returns the control mode of each finger, in the order of the fingers."""
    changes = len({tuple(row) for row in segment.modes}) > 1
    shown = ", ".join(segment.modes[0]) if segment.modes else ""
    return f"control {shown}{' at first' if changes else ''}"


def _range(values: Any) -> str:
    return f"{values.min():.3g} to {values.max():.3g}"


def _name(segment: Segment) -> str:
    return f"the {segment.name}"


def _place(k: int, row: int, segment: Segment) -> str:
    return f"row {row} of segment {k}, {_name(segment)}"


def _cost(plan: Plan) -> str:
    """Returns the cost by Eqs. (9) and (10): motion, and a fixed cost per regrasp."""
    cost = plan.cost or 0.0
    if not plan.regrasps:
        return f"{_length(cost)} of motion, no regrasp"
    each = plan.task.options.regrasp_cost
    moved = _length(max(0.0, cost - each * plan.regrasps))
    return f"{_length(cost)} ({moved} of motion + {count(plan.regrasps, 'regrasps')} x {each:g} m)"


def _length(metres: float | None) -> str:
    return "nothing" if metres is None else f"{metres:.6g} m"
