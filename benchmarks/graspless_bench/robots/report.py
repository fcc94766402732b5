# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of the fleet: at the terminal, as JSON, and as robots.md."""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, version
from typing import TYPE_CHECKING

from .. import machine, memory
from ..pages import write_page
from ..tables import aligned, markdown, milliseconds, or_dash, printed, write_json
from .fleet import PACKAGES

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

    from ..machine import Row
    from ..tables import Column

LONGEST = 240  # of a reason on the page [characters]


def as_result(rows: list[Row], load: Sequence[float]) -> Row:
    """Returns all of a run, as printed by `--json`. `load`: load averages before it."""
    faults = sum(part["faults"] for row in rows for part in _parts(row))
    return {
        "bench": "robots",
        "inspected": sum(row["found"] is not None for row in rows),
        "robots": len(rows),
        "faults": faults,
        "rows": rows,
        "complaints": [
            f"{row['name']}: {part['faults']} plans failed their check"
            for row in rows
            for part in _parts(row)
            if part["faults"]
        ],
        "machine": machine.machine(load, memory.resident_bytes()),
        "versions": machine.versions() | _packages(),
    }


def _parts(row: Row) -> list[Row]:
    return [row[kind] for kind in ("slides", "clasps") if row[kind] is not None]


def _packages() -> dict[str, str]:
    found = {}
    for name in PACKAGES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "not installed"
    return found


def as_text(result: Row) -> str:
    """Returns the text that the command prints."""
    refused = [f"{r['name']}: {r['refused']}" for r in result["rows"] if r["refused"]]
    return printed(result, [aligned("robot", result["rows"], COLUMNS)], refused)


def write(result: Row, directory: Path) -> None:
    """Writes robots.json, and robots.md from it."""
    write_json(result, directory / "robots.json")
    write_page("robots", ["robots"], _fields, directory)


def _fields(result: Row) -> dict[str, str]:
    reasons = [
        {"name": row["name"], "reason": _short(row["refused"])}
        for row in result["rows"]
        if row["refused"]
    ]
    licences = [
        {"name": f"[{name}](https://pypi.org/project/{name}/)", "licence": licence}
        for name, (_, licence) in PACKAGES.items()
    ]
    return {
        "inspected": str(result["inspected"]),
        "robots": str(result["robots"]),
        "found": markdown(result["rows"], FOUND, "robot"),
        "plans": markdown(result["rows"], PLANS, "robot"),
        "reasons": markdown(reasons, [("most frequent reason", lambda r: r["reason"])], "robot"),
        "licences": markdown(licences, [("licence", lambda r: r["licence"])], "package"),
    }


def _short(text: str) -> str:
    """Returns a reason as a cell of a table."""
    text = text.replace("|", "/")
    return text if len(text) <= LONGEST else text[: LONGEST - 3].rsplit(" ", 1)[0] + " ..."


def _of(kind: str, show: Callable[[Row], str]) -> Callable[[Row], str]:
    return lambda row: "–" if row[kind] is None else show(row[kind])


def _rate(part: Row) -> str:
    return f"{part['solved']} / {part['runs']}"


def _gaps(found: Row) -> str:
    largest, smallest = found["opening_mm"]
    return f"{smallest:g} to {largest:g}" if found["fingers"] == 2 else "–"


INSPECTED: list[Column] = [
    ("joints", _of("found", lambda f: f"{f['arm']} + {f['hand']}")),
    ("fingers", _of("found", lambda f: str(f["fingers"]))),
    ("gap [mm]", _of("found", _gaps)),
    ("inspect [s]", lambda row: or_dash(row["inspect_s"], ".2f")),
]
UNSURE: Column = ("unsure", _of("found", lambda f: ", ".join(f["unsure"]) or "nothing"))
BY_HAND: Column = ("set by hand", lambda row: row["by_hand"])
PLANS: list[Column] = [
    ("slides", _of("slides", _rate)),
    ("object [mm]", _of("slides", lambda s: milliseconds(s["thickness_mm"]))),
    ("median [ms]", _of("slides", lambda s: milliseconds(s["p50_ms"]))),
    ("99 % [ms]", _of("slides", lambda s: milliseconds(s["p99_ms"]))),
    ("clasps", _of("clasps", _rate)),
    ("failed checks", lambda row: str(sum(part["faults"] for part in _parts(row)))),
]
FOUND: list[Column] = [
    ("package", lambda row: ", ".join(row["packages"])),
    *INSPECTED,
    UNSURE,
    BY_HAND,
]
COLUMNS: list[Column] = [*INSPECTED, *PLANS, BY_HAND]
