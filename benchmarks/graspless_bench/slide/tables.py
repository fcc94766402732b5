# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Common code of the tables of slide.md: names, columns, and access to rows of a result."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..tables import Column, milliseconds, percent
from .grid import OMPL_PEERS, SSC_PEERS

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..machine import Row

    Claim = tuple[str, str]
    Results = dict[str, Row]  # by the name of the file

SEARCHES = {"fast": "fast", "paper": "Algorithm 1"}
METHODS = {
    "fast": "ours, fast",
    "paper": "ours, Algorithm 1",
    "cbirrt2": "CBiRRT2: one fixed start",
    "cbirrt": "CBiRRT: one fixed pair",
    "forest": "ours, on the pair",
    "tangent_bundle_rrt_connect": "TangentBundle + RRTConnect",
    "projected_biest": "Projected + BiEST",
    "atlas_rrt_connect": "Atlas + RRTConnect",
    "projected_rrt_connect": "Projected + RRTConnect",
    "sscbirrt_native": "sscbirrt, native, no collision tests",
    "sscbirrt": "sscbirrt, Python, our collision tests",
}
BASELINES = ("fast", "paper", "cbirrt2", "cbirrt")
PAIRED = ("forest", *OMPL_PEERS)
OF_UR5E = (*PAIRED, *SSC_PEERS)
PARTS = {  # of benchmarks/
    "solve_free": "closed-form inverse kinematics, up to eight solutions",
    "BM_SlideProjection/range_mm:0": "projection after a step of 0.1 rad, range 0",
    "BM_SlideProjection/range_mm:20": "projection after a step of 0.1 rad, range 2 cm",
    "BM_SlideConstraintRows/jacobian:0": "kinematics and constraint rows of one configuration",
    "BM_SlideConstraintRows/jacobian:1": "the same with their Jacobian",
    "BM_SlideIsValid": "constraint and collision of one configuration",
    "BM_SlideQuery": "scenes of a query",
    "BM_SlidePlan/min_time:1.000": "plan(), mean over 64 poses",
    "BM_SlideCheck": "check() of a plan",
}


def columns(*names: str) -> list[Column]:
    """Returns the columns of a table by name."""
    known: dict[str, Callable[[Row], str]] = {
        "runs": lambda r: str(r["runs"]),
        "median": lambda r: milliseconds(r["p50_ms"]),
        "90 %": lambda r: milliseconds(r["p90_ms"]),
        "99 %": lambda r: milliseconds(r["p99_ms"]),
        "mean": lambda r: milliseconds(r["mean_ms"]),
        "CPU median": lambda r: milliseconds(r["cpu_p50_ms"]),
        "CPU 99 %": lambda r: milliseconds(r["cpu_p99_ms"]),
        "at 10 ms": lambda r: percent(r["solved_10ms"], r["runs"]),
        "at 100 ms": lambda r: percent(r["solved_100ms"], r["runs"]),
        "at 1 s": lambda r: percent(r["solved_1s"], r["runs"]),
        "solved": lambda r: percent(r["solved"], r["runs"]),
        "failed checks": lambda r: str(r["violations"]),
        "peak": lambda r: f"{r['peak_mb']:.0f}",
    }
    return [(name, known[name]) for name in names]


TIMES = columns(
    *("runs", "median", "90 %", "99 %", "at 10 ms", "at 100 ms", "at 1 s"),
    *("solved", "failed checks"),
)


def claims_table(claims: Sequence[Claim], left: str = "the paper") -> str:
    lines = [f"| {left} | measured |", "|---|---|", *(f"| {a} | {b} |" for a, b in claims)]
    return "\n".join(lines)


def rows_of(result: Row, by: str) -> list[Row]:
    return [row for row in result["rows"] if row["by"] == by]


def find(result: Row, by: str, name: str) -> Row:
    return next(row for row in rows_of(result, by) if row["name"] == name)


def named(row: Row, name: str) -> Row:
    return row | {"name": name}


def section_of(label: str) -> str:
    return label.rsplit(", ", 1)[0].replace("frozen", "frozen grid")


def curves_of(result: Row) -> dict[tuple[str, str], Row]:
    return {(curve["section"], curve["method"]): curve for curve in result["curves"]}


def time_to(curve: Row, rate: float, limit: float) -> str:
    """Returns the time at which a rate was reached."""
    needed = -int(-rate * curve["runs"] // 1)
    times = curve["times_ms"]
    return (
        f"at {milliseconds(times[needed - 1])} ms"
        if needed <= len(times)
        else f"not within {limit:g} s"
    )
