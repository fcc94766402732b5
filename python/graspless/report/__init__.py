# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summaries of plans: a few lines of text, or a dictionary."""

from __future__ import annotations

import re
from dataclasses import asdict
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from ..kinds import part
from ..proving import proof as proofs

if TYPE_CHECKING:
    from collections.abc import Collection

    from .._plan import Plan


MOST = 5  # faults printed per segment


class ReportKind(Protocol):
    """Functions that the report module of each kind has."""

    def details(self, plan: Any) -> dict[str, Any]:
        """Returns the fields of `--json` that only this kind has, and `segments`."""

    def lines(self, plan: Any, told: Collection[str]) -> list[str]:
        """Returns the lines of text for a plan that was found, without warnings told before."""

    def lines_not_found(self, plan: Any, told: Collection[str]) -> list[str]:
        """Returns the lines of text that follow the reason if no plan was found, likewise."""


def as_dict(plan: Plan) -> dict[str, Any]:
    """Returns a plan's summary as a dictionary: the output of `graspless plan --json`.

    Parameters
    ----------
    plan : Plan

    Returns
    -------
    dict
        Status, reason, seed, statistics, and a summary of each segment.
    """
    return {
        "status": str(plan.status),
        "reason": plan.reason,
        "seed": plan.seed,
        "stats": plan.statistics.as_dict(),
        **({} if plan.proof is None else {"proof": asdict(plan.proof)}),
        **_kind(plan).details(plan),
    }


def as_text(plan: Plan, told: Collection[str] = ()) -> str:
    """Returns a plan's summary as a few lines of text.

    Parameters
    ----------
    plan : Plan
    told : collection of str
        Warnings that the reader has seen already; they are left out.

    Returns
    -------
    str
        Status, segments, measures of quality, and the counters of the search.
    """
    stats = plan.statistics.as_dict()
    lines = [f"{plan.status} in {duration(stats.get('seconds', 0))}, seed {plan.seed}"]
    if plan:
        lines += [f"  {line}" for line in _kind(plan).lines(plan, told)]
        lines += [f"  {proof}" for proof in [proofs.verdict(plan)] if proof]
    else:
        lines.append(f"  {plan.reason}")
    numbers = {name: value for name, value in stats.items() if not isinstance(value, dict)}
    counters = [_counter(name, value) for name, value in numbers.items() if name != "seconds"]
    lines.append("  search: " + ", ".join(counters))
    if not plan:
        lines += [f"  {line}" for line in _kind(plan).lines_not_found(plan, told)]
    return "\n".join(lines)


def verdict(plan: Plan, faults: list[str], edges: tuple[int, int] | None = None) -> str:
    """Returns the verdict of `graspless check`.

    Parameters
    ----------
    plan : Plan
    faults : list of str
        Result of `graspless.check(plan)`.
    edges : tuple of int, optional
        Number of certified edges, and of all.
    """
    if faults:
        if edges is not None:
            proven = f", {edges[0]} of {edges[1]} edges are certified" if edges[1] else ""
            head = f"the plan is not certified{proven}:"
        else:
            head = "does not hold:" if plan else "not solved:"
        return "\n".join([head, *_shortened(faults)])
    if not plan:
        return "nothing to check: not solved"
    rows = sum(map(len, plan.segments))
    segments = count(len(plan.segments), "segments")
    certified = "" if edges is None else f", and all {edges[1]} edges between rows are certified"
    found = f"an independent replay found no fault{certified}"
    return f"holds: {segments}, {count(rows, 'rows')}; {found}"


def count(number: float, things: str) -> str:
    """Returns a number with its noun in singular or plural: "3 rows", "1 row"."""
    return f"{number} {things.removesuffix('s') if number == 1 else things}"


def duration(seconds: float) -> str:
    """Returns a time [s] as text, in milliseconds below a second."""
    return f"{seconds * 1000:.1f} ms" if seconds < 1 else f"{seconds:.2f} s"


def the(name: str) -> str:
    """Returns the name of an object in a sentence: "the card", "object_0"."""
    is_word = not any(letter.isdigit() or letter == "_" for letter in name)
    return f"the {name}" if is_word else name


def warning_lines(plan: Any, told: Collection[str]) -> list[str]:
    """Returns a line per warning of a plan that was not told before."""
    return [f"warning: {warning}" for warning in plan.warnings if warning not in told]


def segment_details(plan: Plan) -> list[dict[str, Any]]:
    """Returns name, number of rows and least duration of each joint motion."""
    return [
        {"name": s.name, "rows": len(s), "least_seconds": least_seconds(plan, s)}
        for s in plan.segments
    ]


def segment_lines(plan: Plan) -> list[str]:
    """Returns a line per joint motion: its name, number of rows, and least duration."""
    return [_segment_line(plan, segment) for segment in plan.segments]


def _segment_line(plan: Plan, segment: Any) -> str:
    seconds = least_seconds(plan, segment)
    least = "" if seconds is None else f", at least {seconds:.2f} s long"
    return f"{head(segment)}{least}"


def head(segment: Any) -> str:
    """Returns a segment's name and number of rows, in columns."""
    number, _, rows = count(len(segment), "rows").partition(" ")
    return f"{segment.name:10}{number:>5} {rows}"


def least_seconds(plan: Plan, segment: Any) -> float | None:
    """Returns a segment's least duration at the joints' speed limits [s]; None without limits."""
    task: Any = plan.task
    speed = np.asarray((task.arm or task.problem).robot.max_velocity)
    if len(segment) < 2 or not np.isfinite(speed).all() or (speed <= 0).any():
        return None
    return float((np.abs(np.diff(segment.positions, axis=0)) / speed).max(axis=1).sum())


def refused(plan: Plan) -> list[str]:
    """Returns lines that count the reasons of rejected candidates, the most frequent first."""
    refusals = plan.statistics.as_dict().get("refusals", {})
    if not refusals:
        return []
    width = max(map(len, refusals))
    order = sorted(refusals, key=lambda name: -refusals[name])
    return [
        "rejected candidates, by reason:",
        *(f"  {name:{width}}  {refusals[name]}" for name in order),
    ]


def _kind(plan: Plan) -> ReportKind:
    kind: ReportKind = part("report", plan.kind)
    return kind


def _shortened(faults: list[str]) -> list[str]:
    """Returns the first faults of each segment, and their number."""
    segments: dict[str, list[str]] = {}
    for fault in faults:
        named = re.match(r"segment \d+|\w*", fault)
        segments.setdefault(named[0] if named else "", []).append(fault)
    lines = []
    for name, found in segments.items():
        lines += found[:MOST]
        if len(found) > MOST:
            lines.append(f"{name}: {len(found) - MOST} more")
    return [*lines, count(len(faults), "faults")] if len(faults) > 1 else lines


def _counter(name: str, value: float) -> str:
    if name == "memory":
        return f"{value / 1e6:.1f} MB of memory"
    if name.endswith("_seconds"):
        return f"{duration(value)} for {name.removesuffix('_seconds')}"
    return count(value, name.replace("_", " "))
