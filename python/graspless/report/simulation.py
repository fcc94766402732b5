# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of simulations."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING, Any

import numpy as np

from ..simulation import simulation_kind
from ..simulation.settings import Slide
from . import count

if TYPE_CHECKING:
    from ..simulation import Simulation, Trial


def as_text(found: Simulation, disturbed: dict[str, Any] | None = None) -> str:
    """Returns a simulation's result as text.

    Parameters
    ----------
    found : Simulation
    disturbed : dict, optional
        Result of the search for the smallest disturbance that breaks the plan.

    Returns
    -------
    str
        The number of trials that succeeded, the failures, and a table of measures.
    """
    kind = simulation_kind(found.plan.kind)
    meanings = getattr(kind, "failures_of", lambda plan: kind.FAILURES)(found.plan)
    failures = {**meanings, **getattr(kind, "FOLLOWED_FAILURES", {})}
    measures = {**kind.MEASURES, **getattr(kind, "FOLLOWED_MEASURES", {})}
    trials = count(len(found.trials), "trials")
    lines = [f"{found.held} of {trials} succeeded, seed {found.seed}"]
    for name, times in found.failures.items():
        meaning = failures[name] + _bodies(name, found) + _push(name, found)
        meaning += _rise(name, found)
        lines.append(f"  {name} in {count(times, 'trials')}: {meaning}")
    lines += [f"  {line}" for line in _table(found.trials, measures)]
    if disturbed is not None:
        lines.append(f"  {_disturbance(disturbed)}")
        if getattr(found.plan, "joint_segments", None):
            lines.append("  (with bare fingertips instead of the arm)")
    seconds = sum(trial.seconds for trial in found.trials)
    lines.append(f"  computed in {seconds:.1f} s")
    return "\n".join(lines)


def _bodies(failure: str, found: Simulation) -> str:
    """Returns the names of the bodies that touched, in brackets; empty for other failures."""
    pairs = [trial.touched for trial in found.trials if failure in trial.failures and trial.touched]
    if failure != "hit" or not pairs:
        return ""
    (most, _), *others = Counter(pairs).most_common()
    more = f", and {count(len(others), 'other pairs')}" if others else ""
    return f" ({most[0]} and {most[1]}{more})"


def _push(failure: str, found: Simulation) -> str:
    """Returns how far the object moved, in brackets, if that made a clasp fail."""
    failed = [trial for trial in found.trials if failure in trial.failures]
    pushed = [t.measures for t in failed if "moved_before" in t.measures and not t.touched]
    moved = [measures["moved_before"] for measures in pushed]
    if failure != "hit" or not moved:
        return ""
    of = "" if len(moved) == len(failed) else f"in {len(moved)} of them "
    return f" ({of}the object moved by up to {1e3 * max(moved):.0f} mm)"


def _rise(failure: str, found: Simulation) -> str:
    """Returns how far the hand lifted what stayed in it, in brackets; empty for other failures."""
    failed = [trial.measures for trial in found.trials if failure in trial.failures]
    kept = [m for m in failed if "lift_height" in m and m["creep"] <= Slide().kept]
    if failure != "dropped" or not kept:
        return ""
    rises = sorted({round(1e3 * m["lift_height"]) for m in kept})
    rose = " to ".join(str(rise) for rise in sorted({rises[0], rises[-1]}))
    of = "" if len(failed) == 1 else f"in {len(kept)} of them "
    return f" ({of}it kept its place in the hand and rose by {rose} mm)"


def _table(trials: list[Trial], measures: dict[str, str]) -> list[str]:
    """Returns a table of measures: the first trial, and the spread over the others."""
    first = "nominal" if trials[0].variation.is_nominal else "first"
    rows = [("", first, *(("median", "min", "max") if len(trials) > 1 else ()), "")]
    for name, meaning in measures.items():
        varied = [trial.measures[name] for trial in trials[1:] if name in trial.measures]
        if name not in trials[0].measures and not varied:
            continue
        figures = [_figure(trials[0].measures.get(name))]
        if len(trials) > 1:
            spread = (np.median(varied), min(varied), max(varied)) if varied else (None,) * 3
            figures += map(_figure, spread)
        rows.append((name, *figures, meaning))
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    return [
        "  ".join(
            cell.ljust(width) if k in (0, len(row) - 1) else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    ]


def _figure(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"


def _disturbance(found: dict[str, Any]) -> str:
    where = f"at the weakest row (segment {found['segment']}, row {found['row']})"
    z, compliant = f"z = {found['z']:.3g} N", f"compliant index {found['compliant']:.3g} N"
    promised = f"promised {found['withstands']:.3g} N"
    predicted = f"{promised}; predicted {z}, {compliant}"
    if found["smallest"] is None:
        return f"no disturbance up to {found['tried']:.3g} N moves the object {where}; {predicted}"
    if found["smallest"] == 0:
        off = found["undisturbed"]
        far = "" if off is None else f" by {1e3 * off:.2g} mm"
        return f"the object moves{far} without any disturbance {where}; {predicted}"
    moved = f"{found['smallest']:.3g} N moves the object {where}"
    return f"{moved}: {found['ratio']:.2f} of the predicted {z}; {promised}; {compliant}"
