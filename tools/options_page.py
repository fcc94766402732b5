# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes docs/reference/options.md from the tables in the C++ headers, by way of the extension."""

from __future__ import annotations

import enum
import math
import pathlib
from typing import Any

from graspless import carry, clasp, fingertip, perception, pinch, planning, slide

PAGE = pathlib.Path(__file__).parents[1] / "docs" / "reference" / "options.md"

HEAD = """# Options, statistics and status

Made by `make stubs` from the tables in the C++ headers: change those, not this page. Task files
name the options under `options`, those of the budget under `budget`, those of joint paths under
`realize`, and those of the hand under `hand`. Defaults are those of C++ and Python; in a task,
[`hand`](../task-files.md#hand) must name `finger_model` with the fields that it needs, and may
have a `pitch`, and `seconds` must be finite. Symbols and equations are those of the planner's paper
([notation](../notation.md)).
"""

SECTIONS = [
    ("Budget", "Time and randomness of every query.", planning, ["Budget"]),
    ("Slide", "Hang, Morgan and Dollar 2019.", slide, ["Hand", "Options", "Statistics"]),
    ("Pinch", "Opposite faces of an outline.", pinch, ["Options", "Statistics"]),
    (
        "Clasp",
        "Stork, Pokorny and Kragic 2013.",
        clasp,
        ["Options", "StabilityOptions", "CertificateOptions", "Statistics"],
    ),
    (
        "Fingertip",
        "Maeda and Arai 2005.",
        fingertip,
        ["Options", "Compliance", "RealizeOptions", "Statistics"],
    ),
    ("Carry", "Straight paths of a held object.", carry, ["Options", "Statistics"]),
    ("Perception", "Supports and objects in depth images.", perception, ["Options"]),
]


def text() -> str:
    """The page, in Markdown."""
    parts = [HEAD]
    for title, source, room, structs in SECTIONS:
        parts.append(f"## {title}\n\n{source}\n")
        parts += [_struct(getattr(room, name)) for name in structs]
        names = ("FingerModel", "Search", "Status", "EdgeLabel")
        enums = [getattr(room, name, None) for name in names]
        parts += [_choices(found) for found in enums if found is not None]
    return "\n".join(parts)


def _struct(struct: Any) -> str:
    default, rows = struct(), struct.fields()
    if struct.__name__ == "Statistics":
        header = ["counter", "unit", "what it counts", "paper"]
        cells = [[f"`{f.name}`", f.unit, f.text, f.source] for f in rows]
    else:
        header = ["option", "unit", "default", "range", "meaning", "paper"]
        cells = [
            [f"`{f.name}`", f.unit, _shown(getattr(default, f.name)), f.range, f.text, f.source]
            for f in rows
        ]
    return _table(f"{_room(struct)}.{struct.__name__}", header, cells)


def _choices(choices: Any) -> str:
    cells = [[f"`{member.name}`", str(member.__doc__)] for member in choices]
    return _table(f"{_room(choices)}.{choices.__name__}", ["value", "meaning"], cells)


def _room(thing: Any) -> str:
    return str(thing.__module__).removeprefix("graspless._core.")


def _table(title: str, header: list[str], cells: list[list[str]]) -> str:
    rows = [header, ["---"] * len(header), *cells]
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    return f"### {title}\n\n" + "\n".join(lines) + "\n"


def _shown(value: Any) -> str:
    """A default as a task file has it."""
    if isinstance(value, enum.Enum):
        return value.name
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return "any" if math.isinf(value) else f"{value:.6g}"
    if hasattr(value, "shape"):
        return " x ".join(str(size) for size in value.shape)
    if isinstance(value, str):
        return value
    if isinstance(value, tuple):
        return f"[{', '.join(value)}]"
    if value is None or isinstance(value, int):
        return "no limit" if value is None else str(value)
    return f"`{type(value).__name__}()`"


if __name__ == "__main__":
    PAGE.write_text(text(), encoding="utf-8")
