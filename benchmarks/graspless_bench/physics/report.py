# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Results of plans in the physics engine: at the terminal, as JSON, and as physics.md."""

from __future__ import annotations

import importlib.metadata
from typing import TYPE_CHECKING, Any

from graspless.simulation import simulation_kind

from .. import machine
from ..pages import write_page
from ..tables import aligned, markdown, printed, write_json
from . import locked, tables
from .claims import CLAIMS
from .claims import cases as all_cases

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from ..machine import Row
    from .run import Run

PARTS = tuple(CLAIMS)
_FIELDS = {  # of the template, by the titles of tables
    "requirement": "claims",
    "failure": "failures",
    "measure": "measures",
    "condition": "conditions",
    "new plan": "replans",
    "score": "scores",
    "certificate": "certificates",
    "disturbance": "disturbances",
    "mutant": "mutants",
    "search": "proofs",
    "broke / promised": "promises",
}


def as_result(run: Run, load: Sequence[float]) -> Row:
    """Returns all of a run. `load`: load averages before it."""
    kind: Any = simulation_kind(run.grid.kind)
    measures, failures = kind.MEASURES, kind.FAILURES
    if run.grid.experiment == "closed_loop":
        measures, failures = measures | kind.FOLLOWED_MEASURES, failures | kind.FOLLOWED_FAILURES
    elif run.grid.experiment == "locked":
        measures, failures = locked.MEASURES, locked.FAILURES
    return {
        "bench": "physics",
        "kind": run.grid.kind,
        "part": run.grid.part,
        "seed": run.grid.seed,
        "trials": run.grid.trials,
        "complete": run.is_complete,
        "totals": tables.totals(run.rows),
        "measures": measures,
        "failures": failures,
        "rows": run.rows,
        "complaints": run.complaints,
        "machine": machine.machine(load, 0),
        "versions": machine.versions() | {"mujoco": importlib.metadata.version("mujoco")},
    }


def as_text(result: Row) -> str:
    """Returns the text that the command prints."""
    parts = [
        _counts(result["totals"]),
        *(aligned(title, rows, _short(shown)) for title, (rows, shown) in _tables(result).items()),
        tables.below(result),
    ]
    return printed(result, parts)


def write(result: Row, directory: Path) -> None:
    """Writes physics_PART.json, and physics.md anew from all such files there."""
    write_json(result, directory / f"physics_{result['part']}.json")
    write_page("physics", [f"physics_{part}" for part in PARTS], _fields, directory)


def _tables(result: Row) -> dict[str, tables.Table]:
    asked, experiment = {"requirement": tables.claims(result)}, result["part"].partition("_")[2]
    if experiment == "closed_loop":
        return asked | {"condition": tables.conditions(result), "new plan": tables.replans(result)}
    if experiment == "locked":
        cases = [c for of in (locked.CLOSED, locked.OPENED) for c in all_cases(result["rows"], of)]
        return asked | {"score": locked.scores(cases), "certificate": locked.intervals(cases)}
    if experiment == "disturb":
        return asked | {"disturbance": tables.disturbances(result)}
    if experiment == "mutants":
        return asked | {"mutant": tables.broken(result)}
    if experiment == "prove":
        return asked | {"search": tables.proofs(result)}
    if experiment == "withstands":
        return asked | {"broke / promised": tables.promises(result)}
    return asked | {"failure": tables.failures(result), "measure": tables.measures(result)}


def _short(shown: list[tables.Column]) -> list[tables.Column]:
    return [column for column in shown if column[0] != tables.MEANING]


def _fields(result: Row) -> dict[str, str]:
    """Returns the fields that a section of the template may use: counts and tables."""
    fields = {_FIELDS[title]: markdown(*table, title) for title, table in _tables(result).items()}
    said = {"counts": _counts(result["totals"]), "below": tables.below(result)}
    return dict.fromkeys(_FIELDS.values(), "") | fields | said


def _counts(totals: Row) -> str:
    """Returns the counts in one line."""
    parts = [f"{totals['tasks']} tasks, {totals['planned']} planned"]
    missing = ", ".join(f"{name} {count}" for name, count in totals["not_planned"].items())
    parts += [f"not planned: {missing}"] if missing else []
    parts += [f"{totals['failed_checks']} that fail their check"] if totals["failed_checks"] else []
    parts += [f"{totals['warned']} with a warning"] if totals.get("warned") else []
    parts += [f"{totals['lost']} lost to an error"] if totals["lost"] else []
    if totals["nominal"]:
        parts.append(f"{totals['nominal_held']} of {totals['nominal']} held as planned")
    if totals["varied"]:
        parts.append(f"{totals['varied_held']} of {totals['varied']} varied trials held")
    if totals["disturbed"]:
        parts.append(f"{totals['disturbed']} disturbed")
    if totals.get("broken"):
        parts.append(f"{totals['broken']} mutants")
    if (width := totals.get("tube_width")) is not None:
        wide = f"{width['position']:.2f} (position) and {width['angle']:.2f} (angle) times as wide"
        parts.append(f"tubes are {wide} as 99 % of the varied trials need")
    if totals["median_seconds"] is not None:
        slow = f"at most {totals['max_seconds']:.3g} s"
        what = "a search with its simulations" if totals.get("searched") else "a simulation"
        what = "a plan with its mutants" if totals.get("broken") else what
        parts.append(f"{what} took {totals['median_seconds']:.3g} s (median), {slow}")
    return "; ".join(parts)
