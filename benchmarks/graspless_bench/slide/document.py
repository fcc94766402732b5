# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""slide.md: our results beside the paper's, made from the result files in a directory.

The text is in page.md.template. This module makes the tables and pictures.
"""

from __future__ import annotations

import json
import string
from typing import TYPE_CHECKING

from ..pages import template
from ..tables import markdown, milliseconds, percent
from . import appendix, pictures
from .grid import OMPL_PEERS, PAIRS, RANGES, ROOT_SCALES
from .pictures import Panel
from .tables import (
    BASELINES,
    METHODS,
    OF_UR5E,
    PAIRED,
    SEARCHES,
    TIMES,
    claims_table,
    columns,
    curves_of,
    find,
    named,
    rows_of,
    section_of,
    time_to,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

    from ..machine import Row
    from .tables import Results


def write(directory: Path) -> None:
    """Writes slide.md and the pictures of the existing results."""
    results = {
        path.stem: json.loads(path.read_text(encoding="utf-8"))
        for path in directory.glob("slide_*.json")
    }
    makers = {
        "paper": _paper,
        "reconfiguration": _reconfiguration,
        "baselines": _baselines,
        "ur5e": _ur5e,
        "roots": _roots,
        "parts": appendix.parts,
        "circumstances": appendix.circumstances,
    }
    text = [template("slide")["head"]]
    for name, make in makers.items():
        fields = make(results, directory)
        if fields is not None:
            text.append(string.Template(template("slide")[name]).substitute(fields))
    (directory / "slide.md").write_text("\n".join(text), encoding="utf-8")


def _paper(results: Results, directory: Path) -> dict[str, str] | None:
    given = {s: results[f"slide_paper_{s}"] for s in SEARCHES if f"slide_paper_{s}" in results}
    if not given:
        return None
    panels = [
        Panel(
            SEARCHES[s],
            result["time_limit_s"],
            [(section_of(c["name"]), c) for c in result["curves"]],
        )
        for s, result in given.items()
    ]
    pictures.write_success(panels, directory / "slide_paper.png")
    groups = [
        (title, [(SEARCHES[s], rows_of(result, by)) for s, result in given.items()])
        for title, by in (("object", "object"), ("support surface", "table"))
    ]
    pictures.write_medians(groups, directory / "slide_paper_cells.png")
    tables = [
        markdown(
            [named(r, section_of(r["name"])) for r in rows_of(result, "section")],
            TIMES,
            SEARCHES[s],
        )
        for s, result in given.items()
    ]
    return {
        "tables": "\n\n".join(tables),
        "cells": _cells(given),
        "claims": claims_table(
            [
                ("the average planning time is similar for all objects", _medians(given, "object")),
                ("and for objects of half the size", _medians(given, "scale")),
                ("it performs equally well on the four supports", _medians(given, "table")),
            ]
        ),
    }


def _cells(given: Results) -> str:
    """Returns rows by table, object and scale, with both searches."""

    def of(search: str, show: Callable[[Row], str]) -> Callable[[Row], str]:
        return lambda row: show(row[search])

    shown = [
        (f"{SEARCHES[search]}: {name}", of(search, show))
        for search in given
        for name, show in columns("runs", "median", "99 %", "at 1 s")
    ]
    rows = []
    for by in ("table", "object", "scale"):
        for name in dict.fromkeys(
            r["name"] for result in given.values() for r in rows_of(result, by)
        ):
            found = {search: find(result, by, name) for search, result in given.items()}
            rows.append({"name": f"{by}: {name}", **found})
    return markdown(rows, shown)


def _medians(given: Results, by: str) -> str:
    texts = []
    for search, result in given.items():
        medians = [row["p50_ms"] for row in rows_of(result, by)]
        least = min((m for m in medians if m is not None), default=None)
        most = None if None in medians else max(medians)
        spread = f"{milliseconds(least)} to {milliseconds(most)} ms"
        texts.append(f"{spread} ({SEARCHES[search]})")
    return "medians " + ", ".join(texts)


def _reconfiguration(results: Results, directory: Path) -> dict[str, str] | None:
    result = results.get("slide_reconfiguration")
    if result is None:
        return None
    curves, limit = curves_of(result), result["time_limit_s"]
    searches = [s for s in SEARCHES if ("range 0 cm", s) in curves]
    said = [(20.0, 90.0, 2), (60.0, 99.0, 2), (53.0, 90.0, 1), (60.0, 2.0, 0)]
    panels = [
        Panel(
            SEARCHES[search],
            limit,
            [(f"range {name}", curves[f"range {name}", search]) for name in RANGES],
            said if search == "paper" else (),
        )
        for search in searches
    ]
    pictures.write_success(panels, directory / "slide_reconfiguration.png")

    def reached(name: str, rate: float) -> str:
        times = {s: time_to(curves[f"range {name}", s], rate, limit) for s in searches}
        return ", ".join(f"{text} ({SEARCHES[s]})" for s, text in times.items())

    within = f"within {limit:g} s"
    at_zero = []
    for search in searches:
        curve = curves["range 0 cm", search]
        solved = percent(len(curve["times_ms"]), curve["runs"])
        at_zero.append(f"{solved} {within} ({SEARCHES[search]})")
    rows = []
    for row in rows_of(result, "section"):
        method = row["name"].rsplit(", ", 1)[1]
        rows.append(named(row, f"{section_of(row['name'])}, {SEARCHES[method]}"))
    return {
        "table": markdown(rows, TIMES),
        "claims": claims_table(
            [
                ("2 cm: more than 90 % within 20 s", f"90 % {reached('2 cm', 0.9)}"),
                ("2 cm: 99 % at 60 s", f"99 % {reached('2 cm', 0.99)}"),
                ("0.5 cm: 90 % after 53 s", f"90 % {reached('0.5 cm', 0.9)}"),
                ("0 cm: 2 % within 60 s", ", ".join(at_zero)),
            ]
        ),
    }


def _baselines(results: Results, directory: Path) -> dict[str, str] | None:
    result = results.get("slide_baselines")
    if result is None:
        return None
    curves, limit = curves_of(result), result["time_limit_s"]
    panels = [
        Panel(
            "baselines, range 2 cm",
            limit,
            [(METHODS[m], curves["range 2 cm", m]) for m in BASELINES],
        )
    ]
    for pairs in PAIRS:
        shown = [("ours, whole problem", curves["range 0 cm", "fast"])]
        shown += [(METHODS[m], curves[f"{pairs} pairs", m]) for m in PAIRED]
        panels.append(Panel(f"{pairs} pairs, range 0", limit, shown))
    pictures.write_success(panels, directory / "slide_baselines.png")

    def row(section: str, method: str) -> Row:
        return find(result, "section", f"{section}, {method}")

    def table(section: str, methods: Sequence[str], title: str) -> str:
        return markdown([named(row(section, m), METHODS[m]) for m in methods], TIMES, title)

    def rates(at: str) -> str:
        short = {METHODS[m].split(":")[0]: row("range 2 cm", m) for m in BASELINES}
        return ", ".join(f"{name} {percent(r[at], r['runs'])}" for name, r in short.items())

    return {
        "limit": f"{limit:g}",
        "table": table("range 2 cm", BASELINES, ""),
        "whole": table("range 0 cm", ("fast", "paper"), "whole problem"),
        "independent": table("independent pairs", PAIRED, "independent pairs"),
        "fitting": table("fitting pairs", PAIRED, "fitting pairs"),
        "claims": claims_table(
            [
                ("both baselines perform worse", f"at 1 s: {rates('solved_1s')}"),
                (
                    "CBiRRT2 is better than CBiRRT only when the time budget is long enough",
                    f"at 10 ms: {rates('solved_10ms')}",
                ),
            ]
        ),
        "compared": _compared(row),
    }


def _ur5e(results: Results, directory: Path) -> dict[str, str] | None:
    del directory
    result = results.get("slide_ur5e")
    if result is None:
        return None
    known = {row["name"]: row for row in rows_of(result, "section")}

    def table(section: str, methods: Sequence[str], title: str) -> str:
        names = {m: f"{section}, {m}" for m in methods if f"{section}, {m}" in known}
        return markdown([named(known[n], METHODS[m]) for m, n in names.items()], TIMES, title)

    return {
        "limit": f"{result['time_limit_s']:g}",
        "whole": table("UR5e", ("fast",), "whole problem"),
        **{pairs: table(f"UR5e, {pairs}", OF_UR5E, f"{pairs} pairs") for pairs in PAIRS},
        "sscbirrt": result["versions"].get("sscbirrt", "not installed"),
    }


def _compared(row: Callable[[str, str], Row]) -> str:
    """Compares our planner with the peer of the best median, for each kind of pairs."""
    claims = []
    for pairs in PAIRS:
        medians = {m: row(f"{pairs} pairs", m)["p50_ms"] for m in OMPL_PEERS}
        best = min(OMPL_PEERS, key=lambda m: float("inf") if medians[m] is None else medians[m])
        theirs = row(f"{pairs} pairs", best)
        for name, mine in (
            ("ours, on the pair", row(f"{pairs} pairs", "forest")),
            ("ours, whole problem", row("range 0 cm", "fast")),
        ):
            both = (mine, theirs)
            medians_ms = " against ".join(milliseconds(r["p50_ms"]) for r in both)
            rates = " against ".join(percent(r["solved_100ms"], r["runs"]) for r in both)
            text = f"median {medians_ms} ms; at 100 ms {rates}"
            claims.append((f"{pairs} pairs: {name}, against {METHODS[best]}", text))
    return claims_table(claims, "")


def _roots(results: Results, directory: Path) -> dict[str, str] | None:
    result = results.get("slide_roots")
    if result is None:
        return None
    sections = {row["name"]: row for row in rows_of(result, "section")}
    series = []
    for search, name in SEARCHES.items():
        names = {scale: f"N* {scale}, {search}" for scale in ROOT_SCALES}
        rows = [named(sections[n], str(scale)) for scale, n in names.items() if n in sections]
        if rows:
            series.append((name, rows))
    pictures.write_roots(series, directory / "slide_roots.png")
    shown = columns(
        *("runs", "mean", "median", "90 %", "at 100 ms", "at 1 s", "solved", "failed checks")
    )
    best = [(name, min(rows, key=lambda r: r["mean_ms"])["name"]) for name, rows in series]
    measured = ", ".join(f"N* = {scale} ({name})" for name, scale in best)
    return {
        "limit": f"{result['time_limit_s']:g}",
        "table": "\n\n".join(markdown(rows, shown, f"{name}, N*") for name, rows in series),
        "claims": claims_table(
            [
                (
                    "a small N* is too conservative, a large one distracts; N* = 100 is best",
                    f"least mean time: {measured}",
                )
            ]
        ),
    }
