# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of the fingertip planner's experiments: at the terminal, as JSON, and as fingertip.md."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import machine
from ..pages import write_page
from ..tables import aligned, markdown, or_dash, plain, printed, write_json
from .grid import GRIDS, PAPER_MINUTES, REFERENCE_COSTS
from .run import complaints

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from ..machine import Row
    from ..tables import Column
    from .run import Run

PICTURES = ("a", "b", "c", "d", "cork")  # Figures 7 to 11


def as_result(grid: str, run: Run, load: Sequence[float]) -> Row:
    """Returns all of a run, as printed by `--json`. `load`: load averages before it."""
    rows = [found.row for found in run.found]
    return {
        "bench": "fingertip",
        "grid": grid,
        "complete": run.is_complete,
        "rows": rows,
        "complaints": complaints(rows),
        "machine": machine.machine(load, 0),
        "versions": machine.versions(),
    }


def as_text(result: Row) -> str:
    """Returns the text that the command prints."""
    parts = [
        f"grid {result['grid']}; the least time of each trial's runs; peak: what a query adds",
        aligned("", [_named(row) for row in result["rows"]], _columns(result["rows"])),
    ]
    return printed(result, parts)


def write(result: Row, directory: Path) -> None:
    """Writes fingertip_GRID.json, and fingertip.md anew from all such files in the directory."""
    write_json(result, directory / f"fingertip_{result['grid']}.json")
    write_page("fingertip", [f"fingertip_{grid}" for grid in GRIDS], _fields, directory)


def draw(run: Run, directory: Path) -> None:
    """Draws the plans of the paper's cases."""
    from graspless import fingertip, view

    for found in run.found:
        if found.row["case"] in PICTURES and found.row["engine"] == "fast" and found.plan:
            plan = fingertip.Plan._of(found.plan, found.task)
            view.write_png(plan, directory / f"fingertip_{found.row['case']}.png")


def _fields(result: Row) -> dict[str, str]:
    rows = [_named(row) for row in result["rows"]]
    fields = {"table": markdown(rows, _columns(rows)), "grips": _grips(result["rows"])}
    if result["grid"] == "paper":
        fields["costs"] = ", ".join(f"{case} {cost}" for case, cost in REFERENCE_COSTS.items())
    return fields


def _named(row: Row) -> Row:
    return row | {"name": f"{row['case']}, {row['engine']}"}


def _columns(rows: Sequence[Row]) -> list[Column]:
    shown: list[Column] = [
        ("cost", lambda r: _cost(r)),
        ("regrasps", lambda r: or_dash(r["regrasps"])),
        ("least z [N]", lambda r: or_dash(r["weakest"], ".4g")),
        ("z evaluations", lambda r: f"{r['z_evaluations']}"),
        *plain("pivots"),
        ("nodes", lambda r: f"{r['nodes'] + r.get('placements', 0)}"),
        ("seconds", lambda r: f"{r['seconds']:.3g}"),
        ("peak [MB]", lambda r: f"{r['peak_mb']:.0f}"),
        ("check [s]", lambda r: or_dash(r["check_seconds"], ".2g")),
        ("faults", lambda r: f"{len(r['faults'])}"),
        ("load", lambda r: f"{r['load']:g}"),
    ]
    if any("scrub" in row for row in rows):
        shown.insert(3, ("scrub [mm]", lambda r: or_dash(_millimetres(r["scrub"]), ".2f")))
    if any(row["case"] in PAPER_MINUTES for row in rows):
        shown.insert(7, ("paper [min]", lambda r: or_dash(r.get("paper_minutes"))))
    return shown


def _cost(row: Row) -> str:
    if row["cost"] is None:
        return str(row["status"])
    optimal = row["cost"] <= row["lower_bound"] * (1 + 1e-9)
    return f"{row['cost']:.9f}" if optimal else f"{row['cost']:.6f} (>= {row['lower_bound']:.6f})"


def _millimetres(length: float | None) -> float | None:
    return None if length is None else 1000 * length


def _grips(rows: Sequence[Row]) -> str:
    """Returns one line per case with the fingers of the first plan that was found."""
    lines = {}
    for row in rows:
        if row["cost"] is None or row["case"] in lines:
            continue
        steps = [
            f"{name} ({', '.join(grip)})" if name != "regrasp" else "regrasp"
            for name, grip in zip(row["segments"], row["grips"], strict=True)
        ]
        lines[row["case"]] = f"- {row['case']}: {', then '.join(steps)}"
    return "\n".join(lines.values())
