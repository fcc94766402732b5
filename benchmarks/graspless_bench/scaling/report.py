# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of the curves: at the terminal, as JSON, as a picture, and as scaling.md."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import machine
from ..pages import write_page
from ..tables import aligned, markdown, milliseconds, printed, write_json
from .curves import CURVES
from .measure import GOOD, exponent

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from ..machine import Row
    from ..tables import Column

OF_NAME = {curve.name: curve for curve in CURVES}


def as_result(rows: Sequence[Row], is_complete: bool, load: Sequence[float]) -> Row:
    """Returns all of a run, as printed by `--json`. `load`: load averages before it."""
    return {
        "bench": "scaling",
        "complete": is_complete,
        "rows": list(rows),
        "curves": _curves(rows),
        "complaints": [
            f"{row['curve']}, {row['size']}: {row['status']}"
            for row in rows
            if row["status"] not in GOOD
        ],
        "machine": machine.machine(load, 0),
        "versions": machine.versions(),
    }


def _curves(rows: Sequence[Row]) -> list[Row]:
    """Returns a row for every curve: its exponent over all sizes, and that of the last step."""
    found = []
    for name in dict.fromkeys(row["curve"] for row in rows):
        of = [row for row in rows if row["curve"] == name]
        sizes, seconds = [row["size"] for row in of], [row["seconds"] for row in of]
        if len(of) < 2:
            continue
        found.append(
            {
                "name": name,
                "grows": OF_NAME[name].grows,
                "from": sizes[0],
                "to": sizes[-1],
                "seconds_from": seconds[0],
                "seconds_to": seconds[-1],
                "exponent": exponent(sizes, seconds),
                "last_exponent": exponent(sizes[-2:], seconds[-2:]),
            }
        )
    return found


def as_text(result: Row) -> str:
    """Returns the text that the command prints."""
    parts = [
        aligned("", _named(result["rows"]), _SIZES),
        aligned("", result["curves"], _CURVES),
    ]
    return printed(result, parts)


def _named(rows: Sequence[Row]) -> list[Row]:
    return [row | {"name": f"{row['curve']}, {row['size']}"} for row in rows]


def write(result: Row, directory: Path) -> None:
    """Writes scaling.json, scaling.png and scaling.md."""
    write_json(result, directory / "scaling.json")
    _draw(result, directory / "scaling.png")
    write_page("scaling", ["scaling"], _fields, directory)


def _fields(result: Row) -> dict[str, str]:
    return {
        "curves": markdown(result["curves"], _CURVES, "curve"),
        "sizes": markdown(_named(result["rows"]), _SIZES, "curve, size"),
    }


def _draw(result: Row, path: Path) -> None:
    import matplotlib as mpl
    from matplotlib.figure import Figure

    from ..style import COLORS, STYLE

    names = [row["name"] for row in result["curves"] if not OF_NAME[row["name"]].is_wall]
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(9, 5), layout="constrained")
        for i, name in enumerate(names):
            axes = figure.add_subplot(2, -(-len(names) // 2), i + 1)
            rows = [row for row in result["rows"] if row["curve"] == name]
            sizes = [row["size"] for row in rows]
            times = [1e3 * row["seconds"] for row in rows]
            axes.loglog(sizes, times, "o-", color=COLORS[i % len(COLORS)], markersize=4)
            axes.set_xticks(sizes, [f"{size:,}" for size in sizes], fontsize=7, rotation=30)
            axes.minorticks_off()
            axes.set_ylim(1, 1e5)
            axes.set_title(name, fontsize=9)
            axes.set_xlabel(OF_NAME[name].grows, fontsize=7)
            axes.set_ylabel("ms", fontsize=7)
        figure.savefig(path, dpi=120)


_SIZES: list[Column] = [
    ("first run [ms]", lambda r: milliseconds(1e3 * r["seconds_of_runs"][0])),
    ("least [ms]", lambda r: milliseconds(1e3 * r["seconds"])),
    ("status", lambda r: str(r["status"])),
    ("load", lambda r: f"{r['load']:g}"),
]
_CURVES: list[Column] = [
    ("what grows", lambda r: str(r["grows"])),
    ("from", lambda r: f"{r['from']:,}"),
    ("to", lambda r: f"{r['to']:,}"),
    (
        "time [ms]",
        lambda r: (
            f"{milliseconds(1e3 * r['seconds_from'])} to {milliseconds(1e3 * r['seconds_to'])}"
        ),
    ),
    ("exponent", lambda r: f"{r['exponent']:.2f}"),
    ("of the last step", lambda r: f"{r['last_exponent']:.2f}"),
]
