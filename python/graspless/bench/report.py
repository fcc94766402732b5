# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results at the terminal, and as files: JSON, pictures, and the document that holds them all."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any

from ..errors import TaskError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

    from .summary import Row

Column = tuple[str, "Callable[[Row], str]"]


def check_writable(directory: Path) -> None:
    """Raises before hours of work, not after."""
    parent = next(p for p in (directory, *directory.absolute().parents) if p.exists())
    if not parent.is_dir() or not os.access(parent, os.W_OK):
        raise TaskError(f"--out: {directory}: cannot be written")


def write(result: Row, directory: Path) -> None:
    """Writes slide_GRID.json and makes slide.md and its pictures anew from all such files there."""
    from . import document

    directory.mkdir(parents=True, exist_ok=True)
    name = result["grid"]
    if name == "paper":
        name += f"_{result['search']}"
    text = json.dumps(result, indent=1)
    (directory / f"slide_{name}.json").write_text(compact(text) + "\n")
    document.write(directory)


def compact(text: str) -> str:
    """Lists of numbers on one line."""
    lines: list[str] = []
    for line in text.splitlines():
        is_number = line.strip().rstrip(",").replace(".", "", 1).replace("e-", "").isdigit()
        if lines and (is_number or (line.strip() in ("]", "],") and lines[-1][-1].isdigit())):
            lines[-1] += line.strip()
        else:
            lines.append(line)
    return "\n".join(lines)


def milliseconds(value: float | None) -> str:
    """Three figures; an infinite time is a dash."""
    if value is None:
        return "–"
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"


def percent(count: int, runs: int) -> str:
    if runs == 0:
        return "–"
    return f"{100 * count / runs:.1f} %".replace(".0 %", " %")


def columns(*names: str) -> list[Column]:
    """Columns of a table by name."""
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


def markdown(rows: Sequence[Row], shown: Sequence[Column], title: str = "") -> str:
    """A table with the rows' names in front."""
    head = f"| {title} | " + " | ".join(name for name, _ in shown) + " |"
    line = "|---|" + "---:|" * len(shown)
    body = [f"| {r['name']} | " + " | ".join(show(r) for _, show in shown) + " |" for r in rows]
    return "\n".join([head, line, *body])


def as_text(result: Row) -> str:
    """What the command prints."""
    shown = columns(
        *("runs", "median", "90 %", "99 %", "at 100 ms", "at 1 s", "solved", "failed checks")
    )
    blocks = []
    for by in dict.fromkeys(row["by"] for row in result["rows"]):
        if by != "cell":
            blocks.append(aligned(by, [r for r in result["rows"] if r["by"] == by], shown))
    machine = result["machine"]
    query, process = result["peak_mb"], result["process_peak_mb"]
    lines = [
        "" if result["complete"] else "INTERRUPTED: these are partial results",
        f"grid {result['grid']}, seed {result['seed']}, at most {result['time_limit_s']:g} s each;"
        " times in ms, a dash is never",
        *blocks,
        f"memory: a query adds {query:.0f} MB at its peak, {process:.0f} MB with all of Python",
        f"on {machine['cpu']}, load {machine['load_before'][0]} before, "
        f"{machine['load_after'][0]} after",
    ]
    lines += [
        f"FAILED CHECK: {f['start']} ({f['section']}), seed {f['seed']}: {f['first']}"
        for f in result["failed_checks"]
    ]
    return "\n".join(line for line in lines if line)


def aligned(title: str, rows: Sequence[Row], shown: Sequence[Column]) -> str:
    """A table for the terminal, with the rows' names in front."""
    cells: list[list[Any]] = [[title, *(name for name, _ in shown)]]
    cells += [[row["name"], *(show(row) for _, show in shown)] for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(cells[0]))]
    return "\n" + "\n".join(
        f"{line[0]:{widths[0]}}  "
        + "  ".join(f"{cell:>{width}}" for cell, width in zip(line[1:], widths[1:], strict=True))
        for line in cells
    )
