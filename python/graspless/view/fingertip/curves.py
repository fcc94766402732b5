# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Chart of a plan's stability along its motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..figures import INK
from . import bodies
from .moments import measure, progress

if TYPE_CHECKING:
    from ...fingertip import Plan

STABLE = "#1f5f8b"
COMPLIANT = "#d98a1f"
LIMIT = "#b3261e"
HEADROOM = 1.6  # of the axes over the largest value: for bands and labels
LABEL = 0.1  # width of a label over that of the axes


def draw(axes: Any, plan: Plan) -> None:
    """Draws z and the compliant index of every row, the limit, the regrasps and the modes."""
    each, unit = measure(plan.segments)
    along = [each * rows for rows in progress(plan.segments)]
    count = plan.task.options.cone_edges
    edges = "six" if count == 6 else count
    moving = [k for k, s in enumerate(plan.segments) if s.name != "regrasp" and len(s)]
    for n, k in enumerate(moving):
        segment, label = plan.segments[k], n == 0
        axes.plot(
            along[k], segment.stability, "o-", ms=3.2, lw=1.8, color=STABLE,
            label=f"stability z: best forces, friction cones of {edges} edges" if label else None,
        )  # fmt: skip
        axes.plot(
            along[k], segment.compliant_stability, "s--", ms=2.6, lw=1.3, color=COMPLIANT,
            label="compliant index: contacts as springs, round cones" if label else None,
        )  # fmt: skip
    limit = plan.task.options.min_stability
    axes.axhline(
        limit, color=LIMIT, lw=1.1, ls=(0, (6, 3)), label="least allowed z (min_stability)"
    )
    last = _end(plan) * each
    axes.set_xlim(0, max(last, 1e-9))
    shown = [(s.stability, s.compliant_stability) for s in (plan.segments[k] for k in moving)]
    top = max([limit, *(float(np.max(curves)) for curves in shown)])
    axes.set_ylim(0, HEADROOM * top)
    _draw_modes(axes, plan, along, HEADROOM * top)
    _draw_regrasps(axes, plan, along, 1.2 * top)
    if plan.weakest is not None:
        k, row = plan.weakest
        _draw_weakest(axes, float(along[k][row]), plan.segments[k].stability[row], last, top)
    axes.set_xlabel(unit, fontsize=9, color=INK)
    axes.set_ylabel("disturbance [N]", fontsize=9, color=INK)
    axes.tick_params(labelsize=8)
    axes.set_yticks([tick for tick in axes.get_yticks() if 0 <= tick <= 1.08 * top])
    axes.grid(axis="y", color="#e4e6ea", lw=0.7)
    axes.set_axisbelow(True)
    for side_name in ("top", "right"):
        axes.spines[side_name].set_visible(False)
    axes.legend(
        loc="lower right", bbox_to_anchor=(1, 1), ncols=5, fontsize=9, frameon=False,
        borderaxespad=0.1, columnspacing=1.4, handlelength=1.8,
    )  # fmt: skip


def _draw_weakest(axes: Any, x: float, z: float, last: float, top: float) -> None:
    """Marks the weakest row; its label is above all curves, which it must not cover."""
    axes.plot(x, z, "o", ms=11, mfc="none", mec=LIMIT, mew=1.5, ls="", label="weakest row")
    axes.plot([x, x], [z, 1.1 * top], lw=0.8, color=LIMIT)
    side = 1 if x < 0.8 * last else -1
    axes.annotate(
        f"weakest: {z:.3g} N", (x, 1.1 * top), (4 * side, 0), textcoords="offset points",
        fontsize=9, color=LIMIT, ha="left" if side > 0 else "right", va="center",
    )  # fmt: skip


def _end(plan: Plan) -> int:
    return sum(len(segment.X_WO) - 1 for segment in plan.segments)


def _draw_regrasps(axes: Any, plan: Plan, along: list[Any], height: float) -> None:
    """Marks each regrasp by a line; its label is above all curves."""
    places: dict[float, list[int]] = {}
    for k, segment in enumerate(plan.segments):
        if segment.name == "regrasp" and len(segment):
            places.setdefault(round(float(along[k][0]), 9), []).append(segment.finger)
    low, high = axes.get_xlim()
    for n, (x, fingers) in enumerate(sorted(places.items())):
        axes.axvline(x, color=INK, lw=1.1, ls=":", label="" if n else "regrasp")
        later = [other for other in places if other > x]
        room = min([*later, high]) - x > LABEL * (high - low)
        moved = " and ".join(f"{finger}" for finger in dict.fromkeys(fingers))
        axes.annotate(
            f"finger {moved} regrasps", (x, height), (4 if room else -4, 0),
            textcoords="offset points", fontsize=9, color=INK, va="center",
            ha="left" if room else "right",
        )  # fmt: skip


def _draw_modes(axes: Any, plan: Plan, along: list[Any], top: float) -> None:
    """Draws a band for each finger in the colour of its control mode."""
    count = plan.task.problem.fingers.count
    high = 0.038 * top
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
            f"finger {finger}", (0, bottom + high / 2), (-4, 0), textcoords="offset points",
            xycoords=("axes fraction", "data"), fontsize=8, color=INK, ha="right", va="center",
        )  # fmt: skip
