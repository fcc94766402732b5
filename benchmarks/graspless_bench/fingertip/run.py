# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the fingertip planner's trials, checks every plan, and makes rows of results of them."""

from __future__ import annotations

import dataclasses
import os
import time
from typing import TYPE_CHECKING, Any

from graspless import fingertip
from graspless._core import fingertip as core  # the file's numbers are not wanted

from .. import memory
from ..bar import collected, told
from ..memory import MEGA
from .grid import PAPER_MINUTES, REFERENCE_COSTS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from graspless.tasks import Task

    from ..machine import Row
    from .grid import Trial

# Counters of the search in each row, from Plan.statistics.
COUNTERS = (
    "z_evaluations",
    "bounded_tests",
    "pivots",
    "nodes",
    "placements",
    "supports",
    "candidates",
)


@dataclasses.dataclass
class Found:
    """Row of a result, and its plan."""

    row: Row
    task: Task
    plan: core.Plan


@dataclasses.dataclass
class Run:
    """Results of a command, up to Ctrl-C."""

    found: list[Found] = dataclasses.field(default_factory=list)
    is_complete: bool = False


def run(
    trials: Iterable[Trial],
    runs: int | None,
    seconds: float | None,
    tell: Callable[[int, str], None] = lambda done, case: None,
) -> Run:
    """Plans each trial `runs` times (default: until a second is spent, at most 5 times).

    Parameters
    ----------
    trials : iterable of Trial
    runs : int or None
    seconds : float or None
        Limit of each query [s]; None takes the engine's.
    tell : function
        Called with the number of trials that are done, and the next one.
    """
    asked = told(trials, tell, lambda trial: f"{trial.case}, {trial.engine}")
    return Run(*collected(_measure(trial, runs, seconds) for trial in asked))


def _measure(trial: Trial, runs: int | None, seconds: float | None) -> Found:
    task = trial.make_task(seconds)
    before = memory.resident_bytes()
    memory.reset_peak()
    times: list[float] = []
    load = os.getloadavg()[0]
    while len(times) < (runs or 5):
        start = time.perf_counter()
        plan, status, paths = _plan(task)
        times.append(time.perf_counter() - start)
        if plan.status is fingertip.Status.interrupted:
            raise KeyboardInterrupt
        if runs is None and sum(times) > 1:
            break
    peak = memory.peak_bytes()
    start = time.perf_counter()
    faults = _faults(task, plan, paths) if plan else []
    row = {
        "case": trial.case,
        "engine": trial.engine,
        "status": status,
        **_of_plan(plan),
        **{name: getattr(plan.statistics, name) for name in COUNTERS},
        "seconds": min(times),
        "seconds_of_runs": times,
        "peak_mb": round(max(0, peak - before) / MEGA, 1),
        "process_peak_mb": round(peak / MEGA, 1),
        "check_seconds": time.perf_counter() - start if plan else None,
        "faults": list(faults),
        "load": round(load, 2),
        "fingers": trial.fingers,
        "threads": trial.threads,
        "reason": plan.reason,
    }
    if paths is not None:
        row["scrub"] = max((segment.scrub for segment in paths.segments), default=None)
    if trial.case in PAPER_MINUTES and trial.engine != "fast":
        row["paper_minutes"] = PAPER_MINUTES[trial.case][trial.engine == "dijkstra"]
    return Found(row, task, plan)


def _plan(task: Task) -> tuple[core.Plan, str, core.Realization | None]:
    """Returns the plan, its status (`too_large` if the search would need too much memory), and the
    joint paths of a task with a robot.
    """
    arm, paths = task.arm, None
    try:
        if arm is None:
            plan = core.plan(task.problem, task.options, task.budget)
        else:
            plan, paths = core.plan_carried(
                task.problem, task.options, arm.robot, arm.carrier, arm.q_home, arm.options,
                task.budget,
            )  # fmt: skip
    except ValueError as error:
        if "max_memory" not in str(error):
            raise
        plan = core.Plan()
        plan.reason = str(error)
        return plan, "too_large", None
    return plan, plan.status.name, paths


def _faults(task: Task, plan: core.Plan, paths: core.Realization | None) -> list[str]:
    faults = list(fingertip.check(task.problem, plan, task.options))
    if paths is None:
        return faults
    arm = task.arm
    return faults + core.check_realization(
        task.problem, plan, arm.robot, arm.carrier, paths, arm.options
    )


def _of_plan(plan: core.Plan) -> dict[str, Any]:
    if not plan:
        return {"cost": None, "lower_bound": None, "regrasps": None, "weakest": None}
    weakest = plan.segments[plan.weakest_segment].rows[plan.weakest_row]
    return {
        "cost": plan.cost,
        "lower_bound": plan.lower_bound,
        "regrasps": plan.regrasps,
        "weakest": weakest.stability,
        "segments": [segment.name for segment in plan.segments],
        "grips": [_grip(segment) for segment in plan.segments],
    }


def _grip(segment: core.Segment) -> list[str]:
    """Returns face and control mode of each finger; -z means that it presses down."""
    places = []
    for finger in segment.rows[0].fingers:
        n = [float(x) for x in finger.n_O]
        axis = max(range(3), key=lambda i: abs(n[i]))
        face = ("-" if n[axis] < 0 else "+") + "xyz"[axis]
        places.append(f"{face} {finger.mode.name}" if finger.touches else "moves")
    return places


def complaints(rows: Iterable[Row]) -> list[str]:
    """Returns plans that fail check(), costs other than known, and engines that disagree."""
    said, costs = [], dict[str, float]()
    for row in rows:
        name = f"{row['case']}, {row['engine']}"
        said += [f"{name}: {fault}" for fault in row["faults"][:3]]
        if row["case"] in REFERENCE_COSTS and row["status"] != "out_of_time":
            known = REFERENCE_COSTS[row["case"]]
            if row["cost"] is None or abs(row["cost"] - known) > 1e-6:
                said.append(f"{name}: cost {row['cost']}, known {known}")
        if row["cost"] is None or row["cost"] > row["lower_bound"] * (1 + 1e-9):
            continue
        other = costs.setdefault(row["case"], row["cost"])
        if abs(row["cost"] - other) > 1e-9 * other:
            said.append(f"{name}: cost {row['cost']!r}, another engine's {other!r}")
    return said
