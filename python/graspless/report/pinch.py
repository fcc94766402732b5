# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of pinches."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import refused, segment_details, segment_lines, the

if TYPE_CHECKING:
    from collections.abc import Collection

    from ..pinch import Plan


def details(plan: Plan) -> dict[str, Any]:
    """Returns the fields of `--json` that only this kind has."""
    return {
        "opening": plan.opening,
        "width": width(plan) if plan else None,
        "friction": plan.friction if plan else None,
        "segments": segment_details(plan),
    }


def lines(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns a line per segment, and what the pinch needs."""
    name = plan.task.problem.object.name
    friction = f"{plan.friction:.2f}"
    slanted = f"faces that slant: they need a coefficient of friction of {friction}"
    pinched = (
        f"the hand, which opens {1000 * plan.opening:.0f} mm, pinches {the(name)} where it is "
        f"{1000 * width(plan):.0f} mm wide, between "
        f"{'parallel faces' if friction == '0.00' else slanted}"
    )
    return [*segment_lines(plan), pinched]


def lines_not_found(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns why hand poses were rejected."""
    return refused(plan)


def width(plan: Plan) -> float:
    """Returns the distance of the contacts [m]."""
    first, second = np.asarray(plan.contacts_O)
    return float(np.linalg.norm(second - first))
