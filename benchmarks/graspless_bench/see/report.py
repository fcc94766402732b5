# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of perception: at the terminal, as JSON, and as see.md."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import machine, memory
from ..pages import write_page
from ..tables import aligned, markdown, plain, write_json
from . import holes, plans

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

    from ..machine import Row
    from ..tables import Column

VISIBLE = 3  # times the noise: what is thicker must be found
FILES = ("see", "see_own", "see_holes", "see_plans")  # of results, in the order of the page


def of_holes(rows: list[Row], load: Sequence[float]) -> Row:
    """Returns all of a run of the grid holes. `load`: load averages before it."""
    return {"bench": "see", "file": FILES[2], **holes.tables(rows), **_circumstances(rows, load)}


def of_plans(rows: list[Row], load: Sequence[float]) -> Row:
    """Returns all of a run of the grid plans. `load`: load averages before it."""
    return {"bench": "see", "file": FILES[3], **plans.tables(rows), **_circumstances(rows, load)}


def _circumstances(rows: list[Row], load: Sequence[float]) -> Row:
    return {
        "scenes": len(rows),
        "complaints": [],
        "machine": machine.machine(load, memory.resident_bytes()),
        "versions": machine.versions(),
    }


def of_outlines(rows: list[Row], load: Sequence[float], is_own: bool) -> Row:
    """Returns all of a run of the grid outlines. `load`: load averages before it."""
    noises = sorted({row["noise"] for row in rows})
    groups = [
        _summary([r for r in rows if r["noise"] == noise and r["views"] == views], noise, views)
        for noise in noises
        for views in ("1", "2")
    ]
    names = sorted({row["mesh"] for row in rows})
    ordinary = [row for row in rows if row["noise"] == 1]
    return {
        "bench": "see",
        "file": FILES[int(is_own)],
        "groups": groups,
        "all": _summary(rows, "all", "all"),
        "meshes": [_mesh([row for row in ordinary if row["mesh"] == name], name) for name in names],
        **_circumstances(rows, load),
    }


def _summary(rows: list[Row], noise: Any, views: str) -> Row:
    thick = [row for row in rows if row["thickness"] > VISIBLE * row["sigma"]]
    tables = [row for row in rows if row["table"]]
    found = [row for row in rows if row["found"]]
    off = [abs(row["thickness_off"]) for row in found]
    real, right = (sum(row[key] for row in tables) for key in ("real", "real_right"))
    visible, seen = (sum(row[key] for row in tables) for key in ("visible", "visible_found"))
    return {
        "noise": noise,
        "views": views,
        "scenes": len(rows),
        "tables": _share(len(tables), len(rows)),
        "angle": _median([row["angle"] for row in tables]),
        "height": _median([abs(row["height_error"]) for row in tables]),
        "real_right": _share(right, real),
        "visible_found": _share(seen, visible),
        "thick": len(thick),
        "found": _share(sum(row["found"] for row in thick), len(thick)),
        "extra": float(np.mean([row["objects"] - row["found"] for row in tables] or [0])),
        "thickness": _median(off),
        "within": _share(
            sum(abs(row["thickness_off"]) < 2 * row["thickness_error"] for row in found), len(found)
        ),
        "iou": _median([row["iou"] for row in found]),
        "seconds": _median([row["seconds"] for row in rows]),
    }


def _mesh(rows: list[Row], name: str) -> Row:
    row: Row = {"mesh": name, "thickness": rows[0]["thickness"] if rows else None}
    for views in ("1", "2"):
        some = [r for r in rows if r["views"] == views]
        found = [r for r in some if r["found"]]
        row[f"found_{views}"] = f"{len(found)} of {len(some)}"
        row[f"iou_{views}"] = _median([r["iou"] for r in found])
        row[f"off_{views}"] = _median([r["thickness_off"] for r in found])
    return row


def _share(part: float, whole: float) -> float | None:
    return part / whole if whole else None


def _median(values: list[float]) -> float | None:
    return float(np.median(values)) if values else None


def _number(key: str, unit: float = 1, digits: int = 2) -> Callable[[Row], str]:
    return lambda row: "–" if row[key] is None else f"{unit * row[key]:.{digits}f}"


COLUMNS: list[Column] = [
    *plain("noise", "views", "scenes"),
    ("tables found [%]", _number("tables", 100, 1)),
    ("tilt off [mrad]", _number("angle", 1000)),
    ("height off [mm]", _number("height", 1000)),
    ("real edges right [%]", _number("real_right", 100, 1)),
    ("edges found [%]", _number("visible_found", 100, 1)),
    ("objects found [%]", _number("found", 100, 1)),
    ("others", _number("extra")),
    ("thickness off [mm]", _number("thickness", 1000)),
    ("within 2 errors [%]", _number("within", 100, 0)),
    ("IoU", _number("iou", 1, 3)),
    ("time [ms]", _number("seconds", 1000, 1)),
]
MESHES: list[Column] = [
    ("thickness [mm]", _number("thickness", 1000, 1)),
    ("found", lambda row: str(row["found_1"])),
    ("off [mm]", _number("off_1", 1000)),
    ("IoU", _number("iou_1", 1, 3)),
    ("found, 2 views", lambda row: str(row["found_2"])),
    ("off, 2 views [mm]", _number("off_2", 1000)),
    ("IoU, 2 views", _number("iou_2", 1, 3)),
]


HOLES: list[Column] = [
    *plain("views", "holes", "scenes", "right", "uncertain", "wrong"),
    ("time [ms]", _number("seconds", 1000, 0)),
]
NOISES = [column for column in HOLES if column[0] != "holes"]
PLANS: list[Column] = [
    *plain("views", "trials"),
    ("planned and checked", lambda row: str(row["checked"])),
    ("perceive [ms]", _number("perceive", 1000, 1)),
    ("problem [ms]", _number("problem", 1000, 1)),
    ("plan [ms]", _number("plan", 1000, 1)),
    ("check [ms]", _number("check", 1000, 1)),
    ("all, p50 [ms]", _number("seconds", 1000, 0)),
    ("all, p90 [ms]", _number("p90", 1000, 0)),
]


def _tables(result: Row) -> dict[str, tuple[str, list[Row], list[Column]]]:
    """Returns the tables of a result: title, rows and columns by name."""
    if "plans" in result:
        return {"plans": ("kind", result["plans"], PLANS)}
    if "objects" in result:
        return {
            "objects": ("object", result["objects"], HOLES),
            "noises": ("noise", result["noises"], NOISES),
        }
    groups = [{"name": "", **row} for row in (*result["groups"], result["all"])]
    meshes = [{"name": row["mesh"], **row} for row in result["meshes"]]
    return {"groups": ("", groups, COLUMNS), "each": ("mesh", meshes, MESHES)}


def as_text(result: Row) -> str:
    """Returns the tables for the terminal."""
    return "\n\n".join(aligned(*table) for table in _tables(result).values())


def write(result: Row, directory: Path) -> None:
    """Writes the result as JSON, and see.md from all results there, into a folder."""
    write_json(result, directory / f"{result['file']}.json")
    write_page("see", FILES, _fields, directory)


def _fields(result: Row) -> dict[str, str]:
    facts = {
        key: markdown(rows, columns, title)
        for key, (title, rows, columns) in _tables(result).items()
    }
    return facts | {"scenes": str(result["scenes"]), "meshes": str(len(result.get("meshes", ())))}
