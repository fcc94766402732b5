# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of the slide planner's experiments: at the terminal, as JSON, and as slide.md."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..statistics import quantile
from ..tables import aligned, printed, write_json
from . import document
from .tables import columns

if TYPE_CHECKING:
    from pathlib import Path

    from ..machine import Row


MANY = 10_000  # runs of which the slowest are named
FRAME = 33.0  # of a camera [ms]


def write(result: Row, directory: Path) -> None:
    """Writes slide_GRID.json and makes slide.md and its pictures anew from all such files there."""
    name = result["grid"]
    if name == "paper":
        name += f"_{result['search']}"
    write_json(result, directory / f"slide_{name}.json")
    document.write(directory)


def as_text(result: Row) -> str:
    """Returns the text that the command prints."""
    shown = columns(
        *("runs", "median", "90 %", "99 %", "at 100 ms", "at 1 s", "solved", "failed checks")
    )
    blocks = []
    for by in dict.fromkeys(row["by"] for row in result["rows"]):
        if by != "cell":
            blocks.append(aligned(by, [r for r in result["rows"] if r["by"] == by], shown))
    query, process = result["peak_mb"], result["process_peak_mb"]
    parts = [
        f"grid {result['grid']}, seed {result['seed']}, at most {result['time_limit_s']:g} s each;"
        " times in ms, a dash is never",
        *blocks,
        *(_slowest(curve) for curve in result["curves"] if curve["runs"] >= MANY),
        f"memory: a query adds {query:.0f} MB at its peak, {process:.0f} MB with all of Python",
    ]
    failed = [
        f"FAILED CHECK: {f['start']} ({f['section']}), seed {f['seed']}: {f['first']}"
        for f in result["failed_checks"]
    ]
    return printed(result, parts, failed)


def _slowest(curve: Row) -> str:
    """Tells how long the slowest of many runs took."""
    times, runs = curve["times_ms"], curve["runs"]
    in_time = sum(time <= FRAME for time in times)
    last = quantile(times + [math.inf] * (runs - len(times)), 0.9999)
    return (
        f"{curve['name']}: {in_time:,} of {runs:,} solved within {FRAME:g} ms; "
        f"99.99 % {last:.3g}, slowest {max(times, default=math.inf):.3g}"
    )
