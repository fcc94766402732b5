# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results on household objects: at the terminal, as JSON, and as household.md."""

from __future__ import annotations

import json
import string
from collections import Counter
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import machine, memory
from ..pages import circumstances, template
from ..statistics import wilson
from ..tables import aligned, markdown

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from ..machine import Row
    from ..tables import Column

STRATEGIES = ("pinch", "rim", "slide", "clasp")


def as_result(rows: list[Row], load: Sequence[float], excluded: Mapping[str, str]) -> Row:
    """Returns all of a run, as printed by `--json`.

    `load`: load averages before it. `excluded`: reasons by the names of meshes.
    """
    planned = [row for row in rows if row["strategy"] is not None]
    groups = [_group("pick", rows, rows)]
    if excluded:
        kept = [row for row in rows if row["mesh"] not in excluded]
        groups.append(_group("pick, without the excluded", kept, kept))
    pinched = [row for row in rows if row["strategy"] == "pinch"]
    groups.append(_group("pinch only", pinched, rows))
    groups += [
        _group(f"planned: {name}", some, some)
        for name in STRATEGIES
        if (some := [row for row in planned if row["strategy"] == name])
    ]
    names = sorted({(row["mesh"], row["robot"]) for row in rows})
    return {
        "bench": "household",
        "rows": rows,
        "groups": groups,
        "excluded": dict(excluded),
        "objects": [_object(name, robot, rows) for name, robot in names],
        "pick_ms": _quantiles([row["pick_seconds"] for row in planned]),
        "complaints": [
            f"{row['mesh']}: {row['reason']}" for row in rows if row["stage"] == "wrong"
        ],
        "machine": machine.machine(load, memory.resident_bytes()),
        "versions": machine.versions(),
    }


def _group(name: str, some: list[Row], out_of: list[Row]) -> Row:
    stages = Counter(row["stage"] for row in some)
    held = stages["held"]
    low, high = wilson(held, len(out_of))
    planned = sum(row["strategy"] is not None for row in some)
    return {
        "name": name,
        "trials": len(out_of),
        "planned": planned,
        "held": held,
        "rate": held / len(out_of) if out_of else None,
        "band": [low, high],
        "stages": dict(stages),
    }


def _object(name: str, robot: str, rows: list[Row]) -> Row:
    some = [row for row in rows if (row["mesh"], row["robot"]) == (name, robot)]
    return {
        "name": name,
        "robot": robot,
        "poses": [f"{row['strategy'] or '–'}: {row['stage']}" for row in some],
        "reasons": [row["reason"] for row in some],
    }


def _quantiles(seconds: list[float]) -> Row:
    if not seconds:
        return {"p50": None, "p90": None}
    p50, p90 = np.quantile(seconds, [0.5, 0.9])
    return {"p50": 1000 * float(p50), "p90": 1000 * float(p90)}


GROUPS: list[Column] = [
    ("trials", lambda row: str(row["trials"])),
    ("planned", lambda row: str(row["planned"])),
    ("held", lambda row: str(row["held"])),
    ("rate [%]", lambda row: "–" if row["rate"] is None else f"{100 * row['rate']:.0f}"),
    ("Wilson 95 % [%]", lambda row: f"{100 * row['band'][0]:.0f} to {100 * row['band'][1]:.0f}"),
    *(
        (stage.replace("_", " "), lambda row, stage=stage: str(row["stages"].get(stage, 0)))
        for stage in ("turned", "not_seen", "refused", "lost", "not_held")
    ),
]
OBJECTS: list[Column] = [
    ("robot", lambda row: row["robot"]),
    ("poses", lambda row: "; ".join(row["poses"])),
]
REASONS: list[Column] = [
    ("reasons", lambda row: "<br>".join(dict.fromkeys(r for r in row["reasons"] if r)) or "–"),
]


def as_text(result: Row) -> str:
    """Returns the tables for the terminal."""
    ms = result["pick_ms"]
    times = "no plan" if ms["p50"] is None else f"p50 {ms['p50']:.0f} ms, p90 {ms['p90']:.0f} ms"
    groups = aligned("", result["groups"], GROUPS)
    return f"{groups}\n\ntime of a pick that found a plan: {times}\n{_each(result)}"


def _each(result: Row) -> str:
    return aligned("object", result["objects"], OBJECTS)


def _excluded(reasons: Mapping[str, str]) -> str:
    if not reasons:
        return "Nothing: nobody has sorted out the objects that the hand cannot take."
    return "\n".join(f"- {name}: {reason}" for name, reason in sorted(reasons.items()))


def write(result: Row, directory: Path) -> None:
    """Writes household.json and household.md into a folder."""
    (directory / "household.json").write_text(json.dumps(result, indent=1) + "\n")
    ms = result["pick_ms"]
    shown = {key: "–" if value is None else f"{value:.0f}" for key, value in ms.items()}
    facts: dict[str, Any] = {
        "trials": len(result["rows"]),
        "objects": len(result["objects"]),
        "p50": shown["p50"],
        "p90": shown["p90"],
        "excluded": _excluded(result["excluded"]),
        "groups": markdown(result["groups"], GROUPS, ""),
        "each": markdown(result["objects"], OBJECTS + REASONS, "object"),
    }
    facts |= {f"run_{name}": text for name, text in circumstances([result]).items()}
    page = string.Template(template("household")["head"]).substitute(facts)
    (directory / "household.md").write_text(page)


__all__ = ["as_result", "as_text", "write"]
