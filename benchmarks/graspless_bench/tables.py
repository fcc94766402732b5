# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of results, for pages and for the terminal, and the JSON files behind them."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence
    from pathlib import Path

    from .machine import Row

Column = tuple[str, "Callable[[Row], str]"]


def write_json(result: Row, path: Path) -> None:
    """Writes a result as JSON, with one line for each item of a list and for each other field.

    The folder is created if it is missing.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = []
    for name, value in result.items():
        text = json.dumps(value, ensure_ascii=False)
        if isinstance(value, list) and value:
            items = (json.dumps(item, ensure_ascii=False) for item in value)
            text = "[\n  " + ",\n  ".join(items) + "\n ]"
        lines.append(f" {json.dumps(name)}: {text}")
    path.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


def printed(result: Row, parts: Iterable[str], notes: Iterable[str] = ()) -> str:
    """Returns the text that a command prints: parts, the machine, notes and complaints."""
    where = result["machine"]
    lines = [
        "" if result.get("complete", True) else "INTERRUPTED: these are partial results",
        *parts,
        f"on {where['cpu']}, load {where['load_before'][0]} before, {where['load_after'][0]} after",
        *notes,
        *(f"DOES NOT HOLD: {text}" for text in result.get("complaints", ())),
    ]
    return "\n".join(line for line in lines if line)


def milliseconds(value: float | None) -> str:
    """Returns a time with three digits; an infinite time is a dash."""
    if value is None:
        return "–"
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"


def or_dash(value: float | None, form: str = "") -> str:
    """Returns a formatted value; a dash stands for None."""
    return "–" if value is None else format(value, form)


def plain(*names: str) -> list[Column]:
    """Returns columns of fields that are shown as they are, titled by their names."""

    def column(name: str) -> Column:
        return name, lambda r: str(r[name])

    return [column(name) for name in names]


def percent(count: int, runs: int) -> str:
    if runs == 0:
        return "–"
    return f"{100 * count / runs:.1f} %".replace(".0 %", " %")


def markdown(rows: Sequence[Row], shown: Sequence[Column], title: str = "") -> str:
    """Returns a Markdown table with the names of the rows in front."""
    head = f"| {title} | " + " | ".join(name for name, _ in shown) + " |"
    line = "|---|" + "---:|" * len(shown)
    body = [f"| {r['name']} | " + " | ".join(show(r) for _, show in shown) + " |" for r in rows]
    return "\n".join([head, line, *body])


def aligned(title: str, rows: Sequence[Row], shown: Sequence[Column]) -> str:
    """Returns a table for the terminal with the names of the rows in front."""
    cells: list[list[Any]] = [[title, *(name for name, _ in shown)]]
    cells += [[row["name"], *(show(row) for _, show in shown)] for row in rows]
    widths = [max(len(line[i]) for line in cells) for i in range(len(cells[0]))]
    return "\n" + "\n".join(
        f"{line[0]:{widths[0]}}  "
        + "  ".join(f"{cell:>{width}}" for cell, width in zip(line[1:], widths[1:], strict=True))
        for line in cells
    )
