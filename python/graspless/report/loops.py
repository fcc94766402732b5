# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of a cloud's loops."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from . import count

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .. import geometry

MOST = 4  # intervals of the Betti curve that are printed


def loop_line(loops: Sequence[geometry.Loop], index: int) -> str:
    """Describes one loop: its number, its length, and the thickness of the part it runs along."""
    loop = loops[index]
    which = "the loop" if len(loops) == 1 else f"loop {index} of {len(loops)} (counted from 0)"
    return f"{which}, {loop.length:.3g} m long, {_thickness(loop)}"


def _thickness(loop: geometry.Loop) -> str:
    if loop.thickness == 0:
        return "along a part of unknown thickness"
    return f"along a part {100 * loop.thickness:.2g} cm thick"


def betti_line(loops: geometry.Loops) -> list[str]:
    """Returns the numbers of loops on the widest ranges of the longest edge (Betti curve)."""
    edges, numbers = list(loops.betti.max_edge_length), list(loops.betti.loops)
    stretches = [
        (upper / lower, lower, upper, number)
        for lower, upper, number in zip(edges, [*edges[1:], math.inf], numbers, strict=False)
        if number > 0 and lower > 0 and math.isfinite(upper)
    ]
    if not stretches:
        return ["no holes at any longest edge of the complex"]
    widest = sorted(stretches, reverse=True)[:MOST]
    shown = [
        f"{count(number, 'loops')} from {lower:.4g} to {upper:.4g} m"
        for _, lower, upper, number in sorted(widest, key=lambda stretch: stretch[1])
    ]
    return ["loops by longest edge of the complex: " + ", ".join(shown)]


def as_dict(loops: geometry.Loops) -> dict[str, Any]:
    """Returns a cloud's loops as a dictionary: the output of `graspless loops --json`."""

    def loop_fields(loop: geometry.Loop) -> dict[str, Any]:
        return {
            "length": loop.length,
            "thickness": loop.thickness,
            "width": loop.width,
            "max_edge_length": loop.max_edge_length,
            "openness": loop.openness,
            "jump": loop.jump,
            "gap": loop.gap,
            "seen_through": loop.seen_through,
            "unseen": loop.unseen,
            "reason": loop.reason,
            "birth": loop.birth,
            "death": loop.death if math.isfinite(loop.death) else None,
            "points": loop.points.tolist(),
            "vertices": list(loop.vertices),
        }

    return {
        "status": loops.status.name,
        "reason": loops.reason,
        "max_edge_length": loops.complex.max_edge_length,
        "plateau": {
            "lower": loops.plateau.lower,
            "upper": loops.plateau.upper if math.isfinite(loops.plateau.upper) else None,
            "loops": loops.plateau.loops,
        },
        "found": [loop_fields(loop) for loop in loops.found],
        "uncertain": [loop_fields(loop) for loop in loops.uncertain],
        "meridians": [loop_fields(loop) for loop in loops.meridians],
        "has_rays": loops.has_rays,
        "noise": loops.noise,
        "betti": {
            "max_edge_length": list(loops.betti.max_edge_length),
            "loops": list(loops.betti.loops),
        },
        "warnings": list(loops.warnings),
    }


def as_text(loops: geometry.Loops) -> str:
    """Returns a cloud's loops as a few lines of text, the shortest loop first."""
    found = [f"warning: {warning}" for warning in loops.warnings]
    unclear = [
        f"  uncertain: {loop.length:.3g} m long, as {loop.reason}" for loop in loops.uncertain
    ]
    if not loops.found:
        return "\n".join(
            [f"no reliable hole: {loops.reason}", *unclear, *betti_line(loops), *found]
        )
    longest = f"longest edge of the complex {loops.complex.max_edge_length:.4g} m"
    lines = [f"{count(len(loops.found), 'loops')} found, {longest}"]
    for k, loop in enumerate(loops.found):
        sure = f", persists up to {loop.death:.3g} m" if math.isfinite(loop.death) else ""
        through = f", seen through on {1e4 * loop.seen_through:.3g} cm^2" if loops.has_rays else ""
        lines.append(f"  {k}: {loop.length:.3g} m long, {_thickness(loop)}{sure}{through}")
    lines += unclear
    if loops.meridians:
        run = "runs" if len(loops.meridians) == 1 else "run"
        around = f"{count(len(loops.meridians), 'loops')} that {run}"
        lines.append(f"  left out: {around} around a thick handle instead of along it")
    return "\n".join([*lines, *found])
