# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Last part of slide.md: parts of a query, and the circumstances of all runs."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

from .. import pages
from ..tables import Column, markdown
from .grid import FOREIGN
from .tables import PARTS

if TYPE_CHECKING:
    from pathlib import Path

    from .tables import Results


def parts(results: Results, directory: Path) -> dict[str, str] | None:
    """Returns medians by Google Benchmark, if tools/results could run it."""
    del results
    path = directory / "parts.json"
    if not path.exists():
        return None
    found = json.loads(path.read_text(encoding="utf-8"))
    rows = [
        {"name": what, "median": _duration(*found[name])}
        for name, what in PARTS.items()
        if name in found
    ]
    return {"table": markdown(rows, [("median", lambda row: row["median"])], "part")}


def _duration(value: float, unit: str) -> str:
    if unit == "ns" and value >= 1000:
        value, unit = value / 1000, "us"
    return f"{value:.3g} {unit}"


def circumstances(results: Results, directory: Path) -> dict[str, str]:
    """Returns machine, versions, a table of commands, and the number of failed checks."""
    del directory
    ordered = [result for _, result in sorted(results.items())]
    memory: list[Column] = [
        ("query [MB]", lambda r: f"{r['peak_mb']:.0f}"),
        ("process [MB]", lambda r: f"{r['process_peak_mb']:.0f}"),
    ]
    faults = [fault["method"] for result in ordered for fault in result["failed_checks"]]
    ours = sum(method not in FOREIGN for method in faults)
    failed = f"{ours} of ours, {len(faults) - ours} of other planners"
    return pages.circumstances(ordered, memory) | {"failed": failed}
