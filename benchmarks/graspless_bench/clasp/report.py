# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of the clasp planner's experiments: at the terminal, as JSON, and as clasp.md."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import machine
from ..pages import write_page
from ..tables import aligned, printed, write_json
from . import GRIDS, pictures, tables

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from ..machine import Row
    from .run import Run


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
    rows, shown = tables.of(result)
    parts = [
        f"grid {result['grid']}",
        aligned("", rows, shown),
        *tables.sums(result),
    ]
    return printed(result, parts)


def write(result: Row, directory: Path) -> None:
    """Writes clasp_GRID.json and pictures, and clasp.md anew from all such files there."""
    write_json(result, directory / f"clasp_{result['grid']}.json")
    pictures.draw(result, directory)
    write_page("clasp", [f"clasp_{grid}" for grid in GRIDS], tables.fields, directory)
