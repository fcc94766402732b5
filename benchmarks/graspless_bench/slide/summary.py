# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of outcomes to the rows, curves and circumstances of a result file."""

from __future__ import annotations

import collections
import math
from importlib.metadata import version
from typing import TYPE_CHECKING

from ..machine import machine, versions
from ..memory import MEGA
from ..statistics import quantile
from . import sscbirrt

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from ..machine import Row
    from .grid import Trial
    from .run import Outcome, Run


def summarize(outcomes: Sequence[Outcome], run: Run, limit: float) -> Row:
    """Returns counts, quantiles [ms] and memory [MB] of outcomes; None for an infinite time.

    In the mean, a run that was not solved counts as the time limit [s].
    """
    wall = [o.seconds for o in outcomes]
    cpu = [o.cpu_seconds for o in outcomes]
    mean = sum(min(t, limit) for t in wall) / len(wall) if wall else math.inf
    peak = max((o.peak_bytes for o in outcomes), default=0)
    return {
        "runs": len(outcomes),
        "solved": sum(map(math.isfinite, wall)),
        "p50_ms": _ms(quantile(wall, 0.5)),
        "p90_ms": _ms(quantile(wall, 0.9)),
        "p99_ms": _ms(quantile(wall, 0.99)),
        "mean_ms": _ms(mean),
        "cpu_p50_ms": _ms(quantile(cpu, 0.5)),
        "cpu_p99_ms": _ms(quantile(cpu, 0.99)),
        "solved_10ms": sum(t <= 0.01 for t in wall),
        "solved_100ms": sum(t <= 0.1 for t in wall),
        "solved_1s": sum(t <= 1 for t in wall),
        "violations": sum(o.is_violation for o in outcomes),
        "peak_mb": round((peak - run.baseline_bytes) / MEGA, 1),
        "process_peak_mb": round(peak / MEGA, 1),
    }


def rows_by(
    by: str, key: Callable[[Trial], str], outcomes: Iterable[Outcome], run: Run, limit: float
) -> list[Row]:
    """Returns a row for each value of `key`, in order of first occurrence."""
    groups: dict[str, list[Outcome]] = collections.defaultdict(list)
    for outcome in outcomes:
        groups[key(outcome.trial)].append(outcome)
    return [{"by": by, "name": n, **summarize(g, run, limit)} for n, g in groups.items()]


def as_result(grid: str, run: Run, seed: int, limit: float, load: Sequence[float]) -> Row:
    """Returns all of a run, as printed by `--json`, and `curves` for the pictures.

    Parameters
    ----------
    load : list of float
        System load averages before the run. The current ones are added.
    """
    main = [o for o in run.outcomes if o.trial.section == "frozen"] or run.outcomes
    return {
        "bench": "slide",
        "grid": grid,
        "seed": seed,
        "time_limit_s": limit,
        "complete": run.is_complete,
        **summarize(main, run, limit),
        "rows": _rows(run, main, limit),
        "unsolved": _unsolved(run.outcomes),
        "failed_checks": _failed_checks(run.outcomes),
        "machine": machine(load, run.baseline_bytes),
        "versions": versions() | _foreign(grid),
        "curves": _curves(run.outcomes),
    }


def _foreign(grid: str) -> dict[str, str]:
    """Versions of the planners from PyPI that take part in a grid."""
    if grid != "ur5e" or not sscbirrt.is_installed():
        return {}
    return {name: version(name) for name in ("sscbirrt", "ssik")}


def _rows(run: Run, main: Sequence[Outcome], limit: float) -> list[Row]:
    def rows(by: str, key: Callable[[Trial], str], outcomes: Iterable[Outcome]) -> list[Row]:
        return rows_by(by, key, outcomes, run, limit)

    result = rows("section", lambda t: t.label, run.outcomes)
    if main is not run.outcomes:
        result += rows("table", lambda t: t.start.table, main)
        result += rows("object", lambda t: t.start.object, main)
        scales = [o for o in run.outcomes if o.trial.section in ("frozen", "half scale")]
        result += rows("scale", lambda t: f"{t.start.scale:g}", scales)
        result += rows("cell", lambda t: t.start.cell, scales)
        defaults = [o for o in run.outcomes if o.trial.section == "defaults"]
        result += rows("table, defaults", lambda t: t.start.table, defaults)
        result += rows("object, defaults", lambda t: t.start.object, defaults)
    return result


def _curves(outcomes: Sequence[Outcome]) -> list[Row]:
    groups: dict[str, list[Outcome]] = collections.defaultdict(list)
    for outcome in outcomes:
        groups[outcome.trial.label].append(outcome)
    return [
        {
            "name": name,
            "section": group[0].trial.section,
            "method": group[0].trial.method,
            "runs": len(group),
            "times_ms": sorted(_ms(o.seconds) for o in group if math.isfinite(o.seconds)),
        }
        for name, group in groups.items()
    ]


def _unsolved(outcomes: Sequence[Outcome]) -> Row:
    return dict(collections.Counter(o.status for o in outcomes if o.status != "solved"))


def _failed_checks(outcomes: Sequence[Outcome]) -> list[Row]:
    return [
        {
            "start": o.trial.start.name,
            "section": o.trial.label,
            "method": o.trial.method,
            "seed": o.trial.start.draw_seed(),
            "faults": len(o.faults),
            "first": o.faults[0],
        }
        for o in outcomes
        if o.faults
    ]


def _ms(seconds: float) -> float | None:
    return round(seconds * 1000, 3) if math.isfinite(seconds) else None
