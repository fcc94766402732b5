# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of the clasp planner's results."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..tables import markdown, milliseconds, or_dash, plain
from . import holes, small

if TYPE_CHECKING:
    from ..machine import Row
    from ..tables import Column

# What the paper says, Sections V-A and V-B.
PAPER_TOTALS = {
    "tasks": "60",
    "found": "60",
    "within_52_cycles": "60",
    "under_10_cycles": "37",
    "secure": "60",
}
PAPER_CHAIR = {"cycles": 606, "nodes": 248, "path_nodes": 30}


def of(result: Row) -> tuple[list[Row], list[Column]]:
    """Returns the named rows of a result, and the columns to show."""
    if result["grid"] == "loops":
        return [_name(row, "object", "cloud") for row in result["rows"]], LOOPS
    if result["grid"] == "holes":
        return holes.by_object(result["rows"]), HOLES
    if result["grid"] == "small":
        return small.by_object(result["rows"]), SMALL
    if result["grid"] == "grasp_rrt":
        return [_name(row, "planner", "hand", "pose", "seed") for row in result["rows"]], GRASPS
    rows = [_name(row, "hand", "object", "pose", "seed") for row in result["rows"]]
    return rows, TOLERANCE if result["grid"] == "tolerance" else CLASPS


def fields(result: Row) -> dict[str, str]:
    """Returns the fields of the template's section of this grid."""
    totals = result["totals"]
    if result["grid"] in BY_KIND:
        named = [{"name": kind, **row} for kind, row in totals.items()]
        return {"totals": markdown(named, *BY_KIND[result["grid"]]), "table": markdown(*of(result))}
    if result["grid"] == "small":
        said = {key: str(value) for key, value in totals.items()}
        return {**said, "table": markdown(*of(result), "object")}
    if result["grid"] == "tolerance":
        return {"totals": markdown(_by_tolerance(result["rows"]), BY_TOLERANCE, "threshold")}
    named = [{"name": _words(key), "value": value, "key": key} for key, value in totals.items()]
    if result["grid"] == "chair":  # one query in the paper: nothing to sum up
        said = {key: str(value) for key, value in PAPER_CHAIR.items()}
        return {**said, "totals": markdown(named, TOTALS[:1], ""), "table": markdown(*of(result))}
    return {"totals": markdown(named, TOTALS, ""), "table": markdown(*of(result))}


def sums(result: Row) -> list[str]:
    """Returns the totals, one per line."""
    return [f"{_words(key)}: {_said(value)}" for key, value in result["totals"].items()]


def _by_tolerance(rows: list[Row]) -> list[Row]:
    asked: dict[float, list[Row]] = {}
    for row in rows:
        asked.setdefault(row["asked"], []).append(row)
    return [{"name": f"{key:g}", "rows": of_it} for key, of_it in asked.items()]


def _name(row: Row, *keys: str) -> Row:
    return row | {"name": ", ".join(str(row[key]) for key in keys)}


def _words(key: str) -> str:
    return key.replace("_", " ")


def _said(value: object) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{_words(key)} {_said(v)}" for key, v in value.items())
    return f"{value:.3g}" if isinstance(value, float) else "–" if value is None else str(value)


def _two(key: str) -> Column:
    return _words(key), lambda r: or_dash(r.get(key), ".2f")


def _yes(value: bool | None) -> str:
    return "–" if value is None else "yes" if value else "no"


def _share(key: str) -> Column:
    return _words(key), lambda r: f"{sum(bool(row[key]) for row in r['rows'])}/{len(r['rows'])}"


def _mean(key: str) -> Column:
    def show(r: Row) -> str:
        values = [row[key] for row in r["rows"] if row.get(key) is not None]
        return f"{sum(values) / len(values):.2f}" if values else "–"

    return _words(key), show


CLASPS: list[Column] = [
    ("found", lambda r: _yes(r["found"])),
    *plain("cycles", "nodes"),
    ("path nodes", lambda r: str(r.get("path_nodes", "–"))),
    ("ms", lambda r: milliseconds(1000 * r["seconds"])),
    ("of that stability [ms]", lambda r: milliseconds(1000 * r["stability_seconds"])),
    _two("virtual_linking_min"),
    _two("virtual_linking_max"),
    ("secure", lambda r: _yes(r["secure"])),
    _two("margin"),
    ("open hand escapes", lambda r: _yes(r["open_hand_escapes"])),
    ("faults", lambda r: str(len(r["faults"]))),
]
TOLERANCE: list[Column] = [
    ("threshold", lambda r: f"{r['asked']:g}"),
    _two("linking_reached"),
    *CLASPS,
]
BY_TOLERANCE: list[Column] = [
    _share("found"),
    _mean("cycles"),
    _mean("linking_reached"),
    _mean("virtual_linking_min"),
    _mean("margin"),
    _share("secure"),
]
TOTALS: list[Column] = [
    ("ours", lambda r: _said(r["value"])),
    ("the paper", lambda r: PAPER_TOTALS.get(r["key"], "–")),
]
GRASPS: list[Column] = [
    ("found", lambda r: _yes(r["found"])),
    ("on the handle", lambda r: _yes(r["on_handle"])),
    ("envelops", lambda r: _yes(r["envelops"])),
    ("seconds", lambda r: f"{r['seconds']:.3g}"),
]
PLANNERS: list[Column] = [
    *plain("runs"),
    ("found a grasp", lambda r: str(r["found"])),
    ("on the handle", lambda r: str(r["on_handle"])),
    ("envelops the handle", lambda r: str(r["envelops"])),
]
LOOPS: list[Column] = [
    *plain("points", "holes", "loops"),
    ("lengths [m]", lambda r: ", ".join(f"{length:.3f}" for length in r["lengths"])),
    ("ms", lambda r: milliseconds(1000 * r["seconds"])),
    ("load", lambda r: f"{r['load']:g}"),
]
HOLES: list[Column] = [
    *plain("holes", "clouds", "right", "uncertain", "wrong"),
    ("GUDHI right", lambda r: str(r.get("gudhi_right", "–"))),
    ("ms", lambda r: milliseconds(1000 * r["seconds"])),
    ("GUDHI [ms]", lambda r: milliseconds(1000 * s) if (s := r.get("gudhi_seconds")) else "–"),
]
SMALL: list[Column] = [
    *plain("queries", "solved"),
    ("refused with sizes", lambda r: str(r["refused_with_sizes"])),
    ("refused without", lambda r: str(r["refused_without"])),
    ("its hole is", lambda r: r["sizes"] or "–"),
]
KINDS: list[Column] = [
    ("objects right", lambda r: f"{r['right']}/{r['objects']}"),
    ("slowest [ms]", lambda r: milliseconds(1000 * r["max_seconds"])),
]
BY_KIND = {  # columns and title of totals that have several rows
    "loops": (KINDS, "cloud"),
    "holes": (HOLES[1:], ""),
    "grasp_rrt": (PLANNERS, "planner"),
}
