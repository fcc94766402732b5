# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Work of one worker of the bench: one plan in the physics engine."""

from __future__ import annotations

import hashlib
import json
import math
import time
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless.kinds import part
from graspless.tasks.digest import digest

from . import locked, mutants

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from graspless._plan import Plan
    from graspless.simulation import Trial

    from ..machine import Row

DIGITS = 5  # of a figure in a row
ROWS = 4  # of a plan that are broken at most
WEAK, OTHERS = 7, 3  # directions that are tried of each row: those that withstand least, and others
LOOPS = OPEN, CLOSED = "open", "closed"


@dataclass(frozen=True)
class Query:
    """Task, and the experiment with its plan.

    Attributes
    ----------
    name : str
        Of the task.
    document : dict
        The task, whole.
    trials : int
        Of the simulation: the first is nominal.
    seed : int
        Of the variations.
    experiment : str
        As of a grid.
    """

    name: str
    document: dict[str, Any]
    trials: int
    seed: int
    experiment: str = ""

    @property
    def key(self) -> str:
        """Key that is equal for queries with the same answer."""
        asked = asdict(self) | {"document": digest(self.document)}
        return hashlib.sha256(json.dumps(asked, sort_keys=True).encode()).hexdigest()


def measure(query: Query) -> Row:
    """Plans, checks, and executes a plan that holds. Returns a row of the result."""
    try:
        return _measure(query)
    except Exception as error:  # hours of other rows are worth more than this one
        return unknown(query, "failed", f"{type(error).__name__}: {error}")


def _measure(query: Query) -> Row:
    from graspless import _api
    from graspless.tasks import task_from_dict

    start = time.perf_counter()
    task = task_from_dict(query.document, query.name)
    asked: dict[str, Any] = {"prove": query.trials - 1} if query.experiment == "prove" else {}
    plan: Any = _api.plan(task, **asked)
    seconds = time.perf_counter() - start
    faults = _api.check(plan) if plan else []
    row = {
        **unknown(query, str(plan.status), plan.reason),
        "plan_seconds": _figure(plan.statistics.seconds),
        "faults": faults[:3],
        "warnings": list(plan.warnings),
        "tube": _tube(plan),
    }
    if not plan or faults:
        return row
    if query.experiment == "prove":
        return row | {"proof": asdict(plan.proof), "seconds": [_figure(seconds)]}
    if query.experiment == "mutants":
        found, seconds = mutants.tried(plan), time.perf_counter() - start
        return row | {"mutants": found, "seconds": [_figure(seconds)]}
    return row | _EXECUTED.get(query.experiment, _tried)(plan, query)


def unknown(query: Query, status: str, reason: str) -> Row:
    """Returns the row of a plan without measurements. Lists have one entry per trial."""
    return {
        "name": query.name,
        "key": query.key,
        "status": status,
        "reason": reason,
        "seed": query.seed,
        "plan_seconds": None,
        "faults": [],
        "warnings": [],
        "tube": None,
        "failures": [],
        "measures": {},
        "seconds": [],
        "disturbed": None,
    }


def _tube(plan: Any) -> Row | None:
    """Returns a slide's own bounds on the pose of the object at its end; None for other kinds."""
    tube = getattr(plan, "tube", None)
    if not tube or not tube.position:
        return None
    return {"position": _figure(tube.position[-1]), "angle": _figure(tube.angle[-1])}


def _tried(plan: Plan, query: Query) -> Row:
    from graspless import simulation
    from graspless.plan_files import read_plan

    if query.experiment == "ablation":  # planned without the flexure that executes it
        document = json.loads(plan.to_json())
        document["task"]["hand"]["finger_model"] = "flexure"
        plan = read_plan(json.dumps(document), query.name)
    trials = simulation.simulate(plan, query.trials, query.seed).trials
    return _trials(trials, simulation.simulation_kind(plan.kind).MEASURES)


def _followed(plan: Plan, query: Query) -> Row:
    from graspless import simulation

    kind: Any = simulation.simulation_kind(plan.kind)
    asked = [(condition, loop) for condition in kind.CONDITIONS for loop in LOOPS]
    trials = [
        simulation.simulate(
            plan, 1, query.seed, condition=condition, closed_loop=loop == CLOSED
        ).trials[0]
        for condition, loop in asked
    ]
    of = [f"{condition}, {loop}" for condition, loop in asked]
    return {"of": of, **_trials(trials, kind.MEASURES | kind.FOLLOWED_MEASURES)}


def _trials(trials: Sequence[Trial], names: Iterable[str]) -> Row:
    return {
        "failures": [list(trial.failures) for trial in trials],
        "measures": {name: [_measured(trial, name) for trial in trials] for name in names},
        "seconds": [_figure(trial.seconds) for trial in trials],
    }


def _disturbed(plan: Plan, _: Query) -> Row:
    start = time.perf_counter()
    found = _figures(part("simulation", plan.kind).disturb(plan))
    return {"disturbed": found, "seconds": [_figure(time.perf_counter() - start)]}


def _locked(plan: Any, query: Query) -> Row:
    row = locked.measure(plan, query.seed)
    measures = {name: [_figure(v) for v in values] for name, values in row["measures"].items()}
    return row | {"measures": measures, "seconds": [_figure(s) for s in row["seconds"]]}


def _broken(plan: Any, query: Query) -> Row:
    """Breaks the row that withstands least, and others at random; equal rows once."""
    from dataclasses import replace

    from graspless.simulation.fingertip.breaking import break_test
    from graspless.simulation.settings import Break

    from .weak_directions import weak_directions

    start = time.perf_counter()
    different = {
        (s, float(z)): (s, r)
        for s, segment in enumerate(plan.segments)
        for r, z in enumerate(segment.stability)
    }
    rows = list(different.values())
    least = min(rows, key=lambda at: plan.segments[at[0]].withstands[at[1]])
    rows.remove(least)
    random = np.random.default_rng(query.seed)
    drawn = random.permutation(len(rows))[: ROWS - 1]
    others = random.permutation(len(plan.task.options.disturbance_directions))
    settings = Break()
    settings = replace(settings, lost_distance=settings.distance)
    found = []
    for row in [least, *(rows[i] for i in drawn)]:
        weak = weak_directions(plan, row, WEAK)
        tried = [*weak, *(int(i) for i in others if i not in weak)][: WEAK + OTHERS]
        found.append(_figures(break_test(plan, row, settings, tried).as_dict()))
    return {"disturbed": found, "seconds": [_figure(time.perf_counter() - start)]}


_EXECUTED: dict[str, Callable[[Any, Query], Row]] = {
    "disturb": _disturbed,
    "closed_loop": _followed,
    "locked": _locked,
    "withstands": _broken,
}


def _measured(trial: Trial, name: str) -> float | None:
    return _figure(trial.measures[name]) if name in trial.measures else None


def _figures(row: Row) -> Row:
    return {k: _figure(v) if isinstance(v, float) else v for k, v in row.items()}


def _figure(value: float) -> float | None:
    """Returns a rounded value; None if JSON cannot represent it."""
    return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None
