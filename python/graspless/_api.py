# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""graspless.plan and graspless.check: any task by the planner of its kind."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, overload

from . import limits
from ._arguments import require_path
from .errors import TaskError
from .kinds import plan_type
from .plan_files import as_plan
from .tasks import Task, is_problem, load_task, task_from_dict

if TYPE_CHECKING:
    from pathlib import Path

    from . import carry, clasp, fingertip, planning, slide
    from ._plan import Plan
    from .tasks import PlanT


@overload
def plan(
    task: Task[Any, Any, PlanT],
    *,
    search: str | None = None,
    seconds: float | None = None,
    iterations: int | None = None,
    seed: int | None = None,
    budget: planning.Budget | None = None,
) -> PlanT: ...
@overload
def plan(
    task: slide.Problem,
    *,
    search: str | None = None,
    seconds: float | None = None,
    iterations: int | None = None,
    seed: int | None = None,
    budget: planning.Budget | None = None,
) -> slide.Plan: ...
@overload
def plan(
    task: fingertip.Problem,
    *,
    search: str | None = None,
    seconds: float | None = None,
    iterations: int | None = None,
    seed: int | None = None,
    budget: planning.Budget | None = None,
) -> fingertip.Plan: ...
@overload
def plan(
    task: clasp.Problem,
    *,
    search: str | None = None,
    seconds: float | None = None,
    iterations: int | None = None,
    seed: int | None = None,
    budget: planning.Budget | None = None,
) -> clasp.Plan: ...
@overload
def plan(
    task: carry.Problem,
    *,
    search: str | None = None,
    seconds: float | None = None,
    iterations: int | None = None,
    seed: int | None = None,
    budget: planning.Budget | None = None,
) -> carry.Plan: ...
@overload
def plan(
    task: str | Path | Mapping[str, Any],
    *,
    search: str | None = None,
    seconds: float | None = None,
    iterations: int | None = None,
    seed: int | None = None,
    budget: planning.Budget | None = None,
) -> Plan: ...
def plan(
    task: Any,
    *,
    search: str | None = None,
    seconds: float | None = None,
    iterations: int | None = None,
    seed: int | None = None,
    budget: planning.Budget | None = None,
) -> Any:
    """Plans a task. Not finding a plan is a status, never an exception.

    Parameters
    ----------
    task : Task, Problem of any planner, dict, str or Path
        A task; a problem made in Python; the fields of a task file; or the name of the file.
    search : str, optional
        Instead of the task's: "paper" or "fast", of a fingertip task also "dijkstra".
    seconds, iterations, seed : optional
        Instead of the task's budget [s].
    budget : planning.Budget, optional
        Instead of all three; another thread may stop() it.

    Returns
    -------
    slide.Plan, fingertip.Plan, clasp.Plan, carry.Plan or chain.Plan
        Plan of the task's kind; false unless solved.

    Raises
    ------
    TaskError
        A ValueError: the task is not valid.
    OutOfTimeError
        A TaskError: the time limit was reached before the task was read.
    """
    with limits.reading(seconds if budget is None else budget.seconds) as clock:
        task = as_task(task)
    if budget is not None:
        if (seconds, iterations, seed) != (None, None, None):
            raise TaskError("budget: seconds, iterations and seed must not be given beside it")
        seconds, iterations, seed = budget.seconds, budget.iterations, budget.seed
        if not math.isfinite(seconds):  # a plan file has no word for it
            raise TaskError(f"budget: seconds is {seconds}; should be finite")
    task = task.with_changes(search=search, seconds=seconds, iterations=iterations, seed=seed)
    return plan_since(task, clock.began, budget)


def plan_since(
    task: Task[Any, Any, Any], began: float, budget: planning.Budget | None = None
) -> Any:
    """Plans a task within the seconds that are left of its budget since `began`."""
    before = time.monotonic()
    kind = plan_type(task.kind)
    began += time.monotonic() - before  # imports do not count
    return kind._search(task, limits.rest(task.budget if budget is None else budget, began))


def as_task(task: Any) -> Task[Any, Any, Any]:
    """Returns a task, or makes it of a problem, of the fields of a task file or of the file."""
    if isinstance(task, Task):
        return task
    if is_problem(task):
        return Task.of(task)
    if isinstance(task, Mapping):
        return task_from_dict(dict(task), "task", resolve=True)
    return load_task(require_path("task", task, "a graspless.Task, a Problem, a dict"))


def check(plan: Plan | str | Path) -> list[str]:
    """Replays a plan against its own task, with none of the search's code.

    Parameters
    ----------
    plan : Plan, str or Path
        A plan, or the path of its file.

    Returns
    -------
    list of str
        Faults by segment and row; empty if the plan holds.
    """
    given: Any = as_plan(plan)
    if not given:
        status = f"the plan's status is {given.status}, not solved"
        return [f"nothing to check: {status}; reason: {given.reason}"]
    faults: list[str] = given._faults()
    return faults
