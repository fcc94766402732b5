# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of the clasp planner's experiments: at the terminal, as JSON, and as clasp.md."""

from __future__ import annotations

import json
import string
from typing import TYPE_CHECKING

from .. import machine
from ..pages import circumstances, template
from ..tables import aligned, write_json
from . import pictures, tables

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from ..machine import Row
    from .run import Run

GRID_NAMES = ("paper", "chair", "tolerance", "small", "grasp_rrt", "loops", "holes")


def as_result(run: Run, load: Sequence[float]) -> Row:
    """Returns all of a run, as printed by `--json`. `load`: load averages before it."""
    return {
        "bench": "clasp",
        "grid": run.grid,
        "complete": run.is_complete,
        "totals": run.totals,
        "rows": run.rows,
        "complaints": run.complaints,
        "machine": machine.machine(load, 0),
        "versions": machine.versions(),
    }


def as_text(result: Row) -> str:
    """Returns the text that the command prints."""
    where = result["machine"]
    rows, shown = tables.of(result)
    lines = [
        "" if result["complete"] else "INTERRUPTED: these are partial results",
        f"grid {result['grid']}",
        aligned("", rows, shown),
        *tables.sums(result),
        f"on {where['cpu']}, load {where['load_before'][0]} before, {where['load_after'][0]} after",
        *(f"DOES NOT HOLD: {text}" for text in result["complaints"]),
    ]
    return "\n".join(line for line in lines if line)


def write(result: Row, directory: Path) -> None:
    """Writes clasp_GRID.json and pictures, and clasp.md anew from all such files there."""
    directory.mkdir(parents=True, exist_ok=True)
    write_json(result, directory / f"clasp_{result['grid']}.json")
    pictures.draw(result, directory)
    results = {
        grid: json.loads(path.read_text(encoding="utf-8"))
        for grid in GRID_NAMES
        if (path := directory / f"clasp_{grid}.json").exists()
    }
    page = template("clasp")
    text = page["head"]
    for grid, found in results.items():
        text += "\n" + string.Template(page[grid]).substitute(tables.fields(found))
    end = string.Template(page["circumstances"]).substitute(circumstances(results.values()))
    (directory / "clasp.md").write_text(text + "\n" + end, encoding="utf-8")
