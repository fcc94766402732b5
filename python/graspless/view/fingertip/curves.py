# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The stability of a plan along its way."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..figures import INK
from . import bodies
from .moments import measure, progress

if TYPE_CHECKING:
    from ...plans.fingertip import Plan

STABLE = "#1f5f8b"
COMPLIANT = "#d98a1f"
LIMIT = "#b3261e"


def draw(axes: Any, plan: Plan) -> None:
    """z and the compliant index at every row, the limit, the regrasps, and who holds how."""
    each, unit = measure(plan.segments)
    along = [each * rows for rows in progress(plan.segments)]
    moving = [k for k, s in enumerate(plan.segments) if s.name != "regrasp" and len(s)]
    for n, k in enumerate(moving):
        segment, label = plan.segments[k], n == 0
        axes.plot(
            along[k], segment.stability, "o-", ms=3.2, lw=1.8, color=STABLE,
            label="stability z" if label else None,
        )  # fmt: skip
        axes.plot(
            along[k], segment.compliant_stability, "s--", ms=2.6, lw=1.3, color=COMPLIANT,
            label="compliant index" if label else None,
        )  # fmt: skip
    limit = plan.task.options.min_stability
    axes.axhline(limit, color=LIMIT, lw=1.1, ls=(0, (6, 3)), label="least allowed z")
    last = _end(plan) * each
    axes.set_xlim(0, max(last, 1e-9))
    top = max([limit, *(float(plan.segments[k].stability.max()) for k in moving)])
    axes.set_ylim(0, 1.28 * top)
    _draw_modes(axes, plan, along, 1.28 * top)
    _draw_regrasps(axes, plan, along)
    if plan.weakest is not None:
        k, row = plan.weakest
        place = (along[k][row], plan.segments[k].stability[row])
        axes.plot(*place, "o", ms=11, mfc="none", mec=LIMIT, mew=1.5)
        side = 1 if place[0] < 0.8 * last else -1
        rise = 1 if place[1] < 0.85 * top else -1  # the modes' bands are above
        axes.annotate(
            f"weakest: {place[1]:.3g} N", place, (14 * side, 12 * rise), textcoords="offset points",
            fontsize=9, color=LIMIT, ha="left" if side > 0 else "right",
            va="bottom" if rise > 0 else "top",
            bbox={"boxstyle": "round,pad=0.15", "fc": "white", "ec": "none", "alpha": 0.85},
        )  # fmt: skip
    axes.set_xlabel(unit, fontsize=9, color=INK)
    axes.set_ylabel("withstands [N]", fontsize=9, color=INK)
    axes.tick_params(labelsize=8)
    axes.set_yticks([tick for tick in axes.get_yticks() if 0 <= tick <= 1.08 * top])
    axes.grid(axis="y", color="#e4e6ea", lw=0.7)
    axes.set_axisbelow(True)
    for side_name in ("top", "right"):
        axes.spines[side_name].set_visible(False)
    axes.legend(
        loc="lower right", bbox_to_anchor=(1, 1), ncols=3, fontsize=9, frameon=False,
        borderaxespad=0.1,
    )  # fmt: skip


def _end(plan: Plan) -> int:
    return sum(len(segment.X_WO) - 1 for segment in plan.segments)


def _draw_regrasps(axes: Any, plan: Plan, along: list[Any]) -> None:
    places: dict[float, list[int]] = {}
    for k, segment in enumerate(plan.segments):
        if segment.name == "regrasp" and len(segment):
            places.setdefault(round(float(along[k][0]), 9), []).append(segment.finger + 1)
    for x, fingers in places.items():
        axes.axvline(x, color=INK, lw=1.1, ls=":")
        moved = " and ".join(f"finger {finger}" for finger in dict.fromkeys(fingers))
        axes.annotate(
            f"regrasp: {moved}", (x, plan.task.options.min_stability), (5, 5),
            textcoords="offset points", fontsize=9, color=INK, va="bottom",
            bbox={"boxstyle": "round,pad=0.15", "fc": "white", "ec": "none", "alpha": 0.85},
        )  # fmt: skip


def _draw_modes(axes: Any, plan: Plan, along: list[Any], top: float) -> None:
    """A band a finger, of the colour of its control."""
    count = plan.task.problem.fingers.count
    high = 0.045 * top
    for finger in range(count):
        bottom = top - (finger + 1) * 1.35 * high
        for k, segment in enumerate(plan.segments):
            if segment.name == "regrasp" or not len(segment):
                continue
            half = (along[k][1] - along[k][0]) / 2 if len(segment) > 1 else 0.5
            edges = np.append(along[k] - half, along[k][-1] + half)
            colors = [bodies.MODES[row[finger]] for row in segment.modes]
            for left, right, color in zip(edges[:-1], edges[1:], colors, strict=True):
                axes.fill_between(
                    [left, right], bottom, bottom + high, color=color, lw=0, alpha=0.85
                )
        axes.annotate(
            f"finger {finger + 1}", (0, bottom + high / 2), (-4, 0), textcoords="offset points",
            xycoords=("axes fraction", "data"), fontsize=8, color=INK, ha="right", va="center",
        )  # fmt: skip
