# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of clasps."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..clasp import Status
from . import count, refused, segment_lines, warning_lines
from .loops import betti_line, loop_line

if TYPE_CHECKING:
    from collections.abc import Collection

    from ..clasp import Certificate, Plan


def details(plan: Plan) -> dict[str, Any]:
    """Returns the fields of `--json` that only this kind has."""
    ends = _ends(plan)
    return {
        "loop": plan.loop,
        "loops": len(plan.task.problem.object.loops.found),
        "target": _target(plan),
        "fingers": _fingers(plan),
        "pre_shape": plan.pre_shape or plan.task.problem.hand.open,
        "min_linking": plan.min_linking,
        "virtual_linking": ends,
        "stability": _fields(
            plan.stability, "secure", "escapes", "margin", "withstands", "opens_first", "checks"
        ),
        "pinch": _fields(plan.pinch, "holds", "strength", "press", "load", "gap"),
        "certificate": _fields(
            plan.certificate, "caged", "lower", "upper", "thickness", "gap", "between", "moves"
        ),
        "path_nodes": len(plan.tree.path),
        "warnings": list(plan.warnings),
        "segments": [{"name": s.name, "rows": len(s)} for s in plan.segments],
    }


def lines(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns a line per segment, and the clasp's loop, virtual linking and security."""
    assert plan.stability is not None
    loops = plan.task.problem.object.loops.found
    found = [*warning_lines(plan, told), *segment_lines(plan)]
    found.append(f"clasps {loop_line(loops, plan.loop or 0)}")
    ends = _ends(plan)
    if ends:
        shown = ", ".join(f"{name} {value:.2f}" for name, value in ends.items())
        found.append(f"virtual linking {shown} (at least {plan.min_linking:.2f} needed, 1 is best)")
    stability = plan.stability
    sequences = plan.task.options.stability.sequences
    held = "secure" if stability.secure else "not secure"
    escapes = f"{stability.escapes} of {count(sequences, 'sequences')} of random moves"
    margin = f"margin {stability.margin:.2f} (1: cannot move, 0: escapes)"
    found.append(f"{held}: the loop escapes in {escapes}, {margin}")
    if plan.certificate is not None:
        found.append(_caged(plan.certificate))
    load = plan.task.options.stability
    asked = f"{load.force:g} N and {load.torque:g} Nm"
    if stability.opens_first:
        moment = stability.withstands * load.torque / load.force
        sudden = f"a sudden {stability.withstands:.2g} N with {moment:.2g} Nm in any direction"
        found.append(f"its motors withstand {sudden}; then {stability.opens_first} opens first")
    if plan.pinch is not None:
        friction = f"friction {plan.task.options.friction:g} holds it all the same"
        press = f"fingers that press with {plan.pinch.press:.0f} N"
        found.append(f"pinched: {friction}; {press} resist {plan.pinch.load:.2f} times {asked}")
    return found


def lines_not_found(plan: Plan, told: Collection[str]) -> list[str]:
    """Returns why targets, connections and clasps failed; without a hole, the Betti curve."""
    if plan.status is Status.no_reliable_hole:
        loops = plan.task.problem.object.loops
        return [f"warning: {warning}" for warning in loops.warnings] + betti_line(loops)
    return warning_lines(plan, told) + refused(plan)


def _target(plan: Plan) -> dict[str, list[float]] | None:
    target = plan.target
    if target is None:
        return None
    return {"point": target.point.tolist(), "tangent": target.tangent.tolist()}


def _fields(found: Any, *names: str) -> dict[str, Any] | None:
    return None if found is None else {name: getattr(found, name) for name in names}


def _caged(found: Certificate) -> str:
    """Says *caged* only where that is proven."""
    if not any(found.between):
        return "not proven to be caged: no ring of the hand is linked with the loop"
    first, second = found.between
    core = "a loop with a core of unknown diameter"
    if found.thickness > 0:
        core = f"a loop with a core of {1000 * found.thickness:.1f} mm"
    sides = f"{first} and {second}" if first != second else f"parts of {first}"
    gap = f"the gap of {1000 * found.gap:.1f} mm between {sides}"
    opening = f"opening {1000 * found.lower:.1f} to {1000 * found.upper:.1f} mm"
    if found.caged:
        return f"caged: {core} does not pass {gap} ({opening})"
    return f"not proven to be caged: {core} may pass {gap} ({opening})"


def _ends(plan: Plan) -> dict[str, float]:
    """Returns the virtual linking of each finger in the last row."""
    rows = [segment.virtual_linking for segment in plan.segments if len(segment)]
    if not rows:
        return {}
    ends = np.asarray(rows[-1])[-1]
    return {name: float(value) for name, value in zip(_fingers(plan), ends, strict=True)}


def _fingers(plan: Plan) -> list[str]:
    """Returns the names of the fingers that clasp; files of older versions have none."""
    return list(plan.fingers) or [finger.name for finger in plan.task.problem.hand.fingers]
