# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results on household objects: at the terminal, as JSON, and as household.md."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

import numpy as np

from .. import machine, memory
from ..pages import write_page
from ..statistics import wilson
from ..tables import aligned, markdown, plain, write_json

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from pathlib import Path

    from ..machine import Row
    from ..tables import Column

STRATEGIES = ("pinch", "rim", "slide", "clasp")
WHERE = (
    ("square table", "table", "square"),
    ("round table", "table", "round"),
    ("L-shaped table", "table", "L"),
    ("alone", "neighbours", 0),
    ("one neighbour", "neighbours", 1),
    ("two neighbours", "neighbours", 2),
)


def as_result(
    rows: list[Row], load: Sequence[float], excluded: Mapping[str, Mapping[str, str]]
) -> Row:
    """Returns all of a run, as printed by `--json`.

    `load`: load averages before it. `excluded`: reasons by robot and mesh.
    """
    settings = dict.fromkeys((row["robot"], row["views"]) for row in rows)
    return {
        "bench": "household",
        "rows": rows,
        "settings": [_setting(robot, views, rows, excluded) for robot, views in settings],
        "excluded": {robot: dict(reasons) for robot, reasons in excluded.items()},
        "complaints": [
            f"{row['mesh']}: {row['reason']}" for row in rows if row["stage"] == "wrong"
        ],
        "machine": machine.machine(load, memory.resident_bytes()),
        "versions": machine.versions(),
    }


def _setting(
    robot: str, views: int, rows: list[Row], excluded: Mapping[str, Mapping[str, str]]
) -> Row:
    """Returns the rates of a robot and a number of views."""
    own = [row for row in rows if (row["robot"], row["views"]) == (robot, views)]
    planned = [row for row in own if row["strategy"] is not None]
    groups = [_group("pick", own, own)]
    if reasons := excluded.get(robot):
        kept = [row for row in own if row["mesh"] not in reasons]
        groups.append(_group("pick, without the excluded", kept, kept))
    pinched = [row for row in own if row["strategy"] == "pinch"]
    groups.append(_group("pinch only", pinched, own))
    groups += [
        _group(f"planned: {name}", some, some)
        for name in STRATEGIES
        if (some := [row for row in planned if row["strategy"] == name])
    ]
    for name, column, value in WHERE:
        if some := [row for row in own if row[column] == value]:
            groups.append(_group(name, some, some))
    return {
        "robot": robot,
        "views": views,
        "groups": groups,
        "pick_ms": _quantiles([row["pick_seconds"] for row in planned]),
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


def _quantiles(seconds: list[float]) -> Row:
    if not seconds:
        return {"p50": None, "p90": None}
    p50, p90 = np.quantile(seconds, [0.5, 0.9])
    return {"p50": 1000 * float(p50), "p90": 1000 * float(p90)}


GROUPS: list[Column] = [
    *plain("trials", "planned", "held"),
    ("rate [%]", lambda row: "–" if row["rate"] is None else f"{100 * row['rate']:.0f}"),
    ("Wilson 95 % [%]", lambda row: f"{100 * row['band'][0]:.0f} to {100 * row['band'][1]:.0f}"),
    *(
        (stage.replace("_", " "), lambda row, stage=stage: str(row["stages"].get(stage, 0)))
        for stage in ("turned", "knocked", "not_seen", "refused", "lost", "not_held")
    ),
]


def as_text(result: Row) -> str:
    """Returns the tables for the terminal."""
    parts = [
        f"{_title(setting)}\n{aligned('', setting['groups'], GROUPS)}\n{_times(setting)}"
        for setting in result["settings"]
    ]
    return "\n\n".join([*parts, aligned("object", _objects(result), _each(result))])


def _title(setting: Row) -> str:
    return f"{setting['robot']}, {'one view' if setting['views'] == 1 else 'two views'}"


def _times(setting: Row) -> str:
    ms = setting["pick_ms"]
    if ms["p50"] is None:
        return "No plan was found."
    return (
        f"A pick that found a plan took {ms['p50']:.0f} ms (median) and {ms['p90']:.0f} ms (90 %), "
        "reading of the robot included, the cameras not."
    )


def outcome(row: Row) -> str:
    """Returns what became of a trial: its strategy, if there was a plan, and its stage."""
    stage = str(row["stage"]).replace("_", " ")
    return stage if row["strategy"] is None else f"{row['strategy']}: {stage}"


def _objects(result: Row) -> list[Row]:
    """Returns a row for each mesh, with its trials by setting."""
    found: dict[str, Row] = {}
    for row in result["rows"]:
        own = found.setdefault(row["mesh"], {"name": row["mesh"], "trials": {}})
        own["trials"].setdefault((row["robot"], row["views"]), []).append(outcome(row))
    return sorted(found.values(), key=lambda row: str(row["name"]))


def _each(result: Row) -> list[Column]:
    return [(_title(s), _trials_of(s["robot"], s["views"])) for s in result["settings"]]


def _trials_of(robot: str, views: int) -> Callable[[Row], str]:
    """Returns the text of a cell: the trials of a mesh in one setting."""
    return lambda row: "; ".join(row["trials"].get((robot, views), []))


def _excluded(reasons: Mapping[str, Mapping[str, str]]) -> str:
    if not any(reasons.values()):
        return "Nothing: nobody has sorted out the objects that a hand cannot take."
    return "\n".join(
        f"- {robot}, {name}: {reason}"
        for robot, some in sorted(reasons.items())
        for name, reason in sorted(some.items())
    )


def write(result: Row, directory: Path) -> None:
    """Writes household.json and household.md into a folder."""
    write_json(result, directory / "household.json")
    write_page("household", ["household"], _fields, directory)


def _fields(result: Row) -> dict[str, str]:
    tables = [
        f"### {_title(setting)}\n\n{markdown(setting['groups'], GROUPS, '')}\n\n{_times(setting)}"
        for setting in result["settings"]
    ]
    objects = _objects(result)
    return {
        "trials": str(len(result["rows"])),
        "objects": str(len(objects)),
        "excluded": _excluded(result["excluded"]),
        "groups": "\n\n".join(tables),
        "each": markdown(objects, _each(result), "object"),
    }
