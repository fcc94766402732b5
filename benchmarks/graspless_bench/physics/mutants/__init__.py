# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans that are broken on purpose, to see what `check` and `simulate` find."""

from __future__ import annotations

import copy
import importlib
import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    from graspless._plan import Plan

    from ...machine import Row

PLANS = 5  # plans of each kind, unless asked otherwise
SAID = 100  # characters of a fault in a row


@dataclass(frozen=True)
class Mutant:
    """Way to break a plan.

    Attributes
    ----------
    name : str
    breaks : str
        Description of what is broken.
    change : function
        Edits the document of a plan file in place.
    benign : str
        Reason why the motion is still as good as the plan's, if it is. Empty if it should fail.
    """

    name: str
    breaks: str
    change: Callable[[Row], None]
    benign: str = ""

    def of(self, document: Row) -> Row:
        """Returns the broken copy of a plan's document."""
        broken = copy.deepcopy(document)
        self.change(broken)
        return broken


def mutants(kind: str) -> list[Mutant]:
    """Returns the mutants of a kind of plan."""
    found: list[Mutant] = importlib.import_module(f".{kind}", __name__).MUTANTS
    return found


def tried(plan: Plan) -> Row | None:
    """Returns what finds each mutant of a plan; None if the plan itself fails its simulation."""
    document = json.loads(plan.to_json())
    if _simulated(document):
        return None
    return {
        mutant.name: {"check": _checked(broken), "simulate": _simulated(broken)}
        for mutant in mutants(plan.kind)
        for broken in [mutant.of(document)]
    }


def _checked(document: Row) -> str:
    """Returns the first fault, or the reason why the file is refused; empty if there is none."""
    from graspless import _api

    try:
        faults = _api.check(_read(document))
    except ValueError as error:  # a TaskError of the reader, or one of a planner
        return str(error)[:SAID]
    return faults[0][:SAID] if faults else ""


def _simulated(document: Row) -> str:
    """Returns the failures of the nominal trial; empty if it held."""
    from graspless import simulation

    try:
        trial = simulation.simulate(_read(document)).trials[0]
    except Exception as error:  # whatever an engine or the timing say to such a plan
        return f"{type(error).__name__}: {error}"[:SAID]
    return ", ".join(trial.failures)


def _read(document: Row) -> Plan:
    from graspless.plan_files import read_plan

    return read_plan(json.dumps(document), "mutant")


def segments(document: Row, *names: str) -> list[Any]:
    """Returns the segments with these names, in order."""
    return [segment for segment in document["segments"] if segment["name"] in names]


def keep_rows(segment: Row, kept: slice | list[int]) -> None:
    """Keeps rows of everything in a segment that has one entry per row."""
    count = len(segment["object_poses"])
    indices = range(count)[kept] if isinstance(kept, slice) else kept
    for name, value in segment.items():
        if isinstance(value, list) and len(value) == count:
            segment[name] = [value[i] for i in indices]


def bend(joint: int, angle: float, out: list[Row], back: list[Row] | None = None) -> None:
    """Adds to a joint, without a jump: from 0 to `angle` in some segments, and back in others."""
    for segments, ends in ((out, (0.0, angle)), (back or [], (angle, 0.0))):
        rows = [row for segment in segments for row in segment["positions"]]
        for row, more in zip(rows, np.linspace(*ends, len(rows)), strict=True):
            row[joint] += float(more)


def leave_out(*names: str) -> Callable[[Row], None]:
    """Returns a change that removes segments."""

    def change(document: Row) -> None:
        document["segments"] = [s for s in document["segments"] if s["name"] not in names]

    return change


def set_task(*path: str, value: Any) -> Callable[[Row], None]:
    """Returns a change of a field of the task."""

    def change(document: Row) -> None:
        inner = document["task"]
        for name in path[:-1]:
            inner = inner[name]
        inner[path[-1]] = value

    return change


def block(document: Row, place: list[float], side: float) -> None:
    """Adds a cube as an obstacle at a place in the world [m]."""
    document["task"].setdefault("obstacles", []).append(
        {"name": "block", "box": 3 * [side], "pose": {"position": list(place)}}
    )
