# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times and profiles of the queries: at the terminal, as JSON, and as speed.md."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import machine
from ..pages import write_page
from ..tables import aligned, markdown, milliseconds, percent, printed, write_json

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from ..machine import Row
    from ..tables import Column


PARTS = ("all", "profile")


def as_result(
    part: str, rows: Sequence[Row], is_complete: bool, load: Sequence[float], old: str
) -> Row:
    """Returns all of a run, as printed by `--json`.

    Parameters
    ----------
    part : str
        Of PARTS.
    rows : list of dict
    is_complete : bool
    load : list of float
        Load averages before the run.
    old : str
        The other build as the user named it; empty if there is none.
    """
    complaints = [text for row in rows for text in _complaints(row)] if part == "all" else []
    if rows and all("error" in row.get("old", {}) for row in rows):
        complaints.append(f"the other build answers nothing: {rows[0]['old']['error']}")
    return {
        "bench": part,
        "complete": is_complete,
        "against": old,
        "rows": list(rows),
        "complaints": complaints,
        "machine": machine.machine(load, 0),
        "versions": machine.versions(),
    }


def _complaints(row: Row) -> list[str]:
    new = row["new"]
    if "error" in new:
        return [f"{row['name']}: {new['error']}"]
    old = row.get("old", {})
    if new["good"] < old.get("good", 0):
        return [f"{row['name']}: {new['good']} results, {old['good']} before"]
    return []


def as_text(result: Row) -> str:
    """Returns the text that the command prints."""
    parts = [aligned(title, *table) for title, table in _tables(result).items()]
    return printed(result, parts, _unanswered(result))


def _unanswered(result: Row) -> list[str]:
    return [
        f"the other build cannot answer {row['name']}: {row['old']['error']}"
        for row in result["rows"]
        if "error" in row.get("old", {})
    ]


def write(result: Row, directory: Path) -> None:
    """Writes speed_PART.json, and speed.md anew from all such files there."""
    write_json(result, directory / f"speed_{result['bench']}.json")
    write_page("speed", [f"speed_{part}" for part in PARTS], _fields, directory)


def _fields(result: Row) -> dict[str, str]:
    tables = [markdown(*table, title) for title, table in _tables(result).items()]
    unanswered = [f"- {text}" for text in _unanswered(result)]
    return {"tables": "\n\n".join(tables), "unanswered": "\n".join(unanswered)}


def _tables(result: Row) -> Mapping[str, tuple[list[Row], list[Column]]]:
    """Returns rows and columns of each table by its title."""
    if result["bench"] == "all":
        return {"query": (result["rows"], _columns(result))}
    return {row["name"]: _rooms(row) for row in result["rows"]}


def _rooms(row: Row) -> tuple[list[Row], list[Column]]:
    """A table of one query: a row for every room with a hundredth of the instructions or more."""
    builds: list[str] = [build for build in ("old", "new") if build in row]
    totals = {build: sum(row[build].values()) for build in builds}
    named = {name for build in builds for name in row[build]}
    rooms = sorted(named, key=lambda name: (-row["new"].get(name, 0), name))
    shown = [n for n in rooms if any(100 * row[b].get(n, 0) >= totals[b] for b in builds)]

    def column(build: str) -> Column:
        title = "instructions" if len(builds) == 1 else build
        return title, lambda r: _share(r[build], totals[build])

    rows = [{"name": name, **{b: row[b].get(name, 0) for b in builds}} for name in shown]
    return [*rows, {"name": "all", **totals}], [column(build) for build in builds]


def _share(count: int, total: int) -> str:
    return f"{count / 1e6:.1f} M, {percent(count, total)}"


def _columns(result: Row) -> list[Column]:
    """Returns the columns of the table, with those of the other build if there is one."""
    if not result["against"]:
        return _of("new", "")
    return [
        *_of("old", "old "),
        *_of("new", "new "),
        ("new / old", _ratio),
        ("same", lambda r: f"{r['same']}" if "same" in r else "–"),
    ]


def _of(build: str, title: str) -> list[Column]:
    def cell(name: str, row: Row) -> str:
        value = row[build].get(name)
        return "–" if value is None else milliseconds(1e3 * value)

    def good(row: Row) -> str:
        of = row[build]
        return "–" if "error" in of else f"{of['good']} of {of['problems']}"

    return [
        (f"{title}p50 [ms]", lambda r: cell("p50", r)),
        (f"{title}p99", lambda r: cell("p99", r)),
        (f"{title}good", good),
        (f"{title}MB", lambda r: f"{r[build].get('megabytes', '–')}"),
    ]


def _ratio(row: Row) -> str:
    if "ratio_p50" not in row:
        return "–"
    low, middle, high = (row[f"ratio_p{q}"] for q in (25, 50, 75))
    return f"{middle:.2f} ({low:.2f} to {high:.2f})"
