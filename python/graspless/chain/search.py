# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Search for the plans of a chain, one stage after the other."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from .. import limits
from ..errors import OutOfTimeError, TaskError
from ..kinds import plan_type
from ..tasks.chain import Stage, start_at
from .state import ends

if TYPE_CHECKING:
    from .. import planning
    from ..tasks import Task


@dataclass
class Statistics:
    """Counters of the search."""

    seconds: float = 0.0
    planned_stages: int = 0
    attempts: int = 1

    def as_dict(self) -> dict[str, Any]:
        """Returns all fields by name."""
        return dict(vars(self))


@dataclass
class Found:
    """Plans found so far."""

    stages: list[Any] = field(default_factory=list)
    status: str = "solved"
    reason: str = ""
    statistics: Statistics = field(default_factory=Statistics)

    def fail(self, status: str, reason: str) -> bool:
        """Ends the chain; False."""
        self.status, self.reason = status, reason
        return False

    def may_do_better(self) -> bool:
        """True if another start may help: a stage could not continue from those before it."""
        ended = ("solved", "interrupted", "out_of_time", "out_of_memory")
        first_failed = len(self.stages) == 1 and not self.stages[0]
        return self.status not in ended and not first_failed


def search(task: Task, budget: planning.Budget) -> Found:
    """Plans stage after stage, with `budget` instead of the task's. A stage gets the seconds
    that are left, and all iterations. Of n stages, stage k of attempt j, both from 0, has
    the budget's seed + j n + k.
    """
    began = time.monotonic()
    best: Found | None = None
    for attempt in range(task.options.attempts):
        found = _attempt(task, budget, began, attempt)
        is_end = found.status in ("solved", "interrupted")
        if best is None or is_end or len(found.stages) > len(best.stages):
            best = found
        best.statistics.attempts = attempt + 1
        if not found.may_do_better() or time.monotonic() - began >= budget.seconds:
            break
    assert best is not None
    best.statistics.seconds = time.monotonic() - began
    return best


def _attempt(task: Task, budget: planning.Budget, began: float, attempt: int) -> Found:
    """Plans the stages from the first to the last, or to the first that is not found."""
    found = Found()
    stages = task.problem.stages
    for k, stage in enumerate(stages):
        left = budget.seconds - (time.monotonic() - began)
        if left <= 0:
            found.fail("out_of_time", f"{stage.name}: no time was left for it")
            break
        seed = (budget.seed + attempt * len(stages) + k) % 2**64
        if not add_stage(found, stage, task, budget.part(seconds=left, seed=seed)):
            break
    return found


def add_stage(found: Found, stage: Stage, task: Task, budget: planning.Budget) -> bool:
    """Plans a stage from the end of the last one. Returns False if the chain ends with it."""
    began = time.monotonic()
    try:
        with limits.reading(budget.seconds):
            given = _start(found, stage, task)
    except OutOfTimeError:
        return found.fail("out_of_time", f"{stage.name}: no time was left for it")
    except TaskError as error:
        what = f"cannot start where '{task.problem.stages[len(found.stages) - 1].name}' ended"
        return found.fail("not_joined", f"{stage.name}: {what}: {error}")
    # The chain's seconds, not what is left of them: the same plan shall be the same file.
    given = given.with_changes(
        seconds=task.budget.seconds, iterations=budget.iterations, seed=budget.seed
    )
    plan = plan_type(stage.kind)._search(given, limits.rest(budget, began))
    found.stages.append(plan)
    return True if plan else found.fail(str(plan.status), f"{stage.name}: {plan.reason}")


def _start(found: Found, stage: Stage, task: Task) -> Task:
    if not found.stages:
        first: Task = task.problem.first
        return first
    return stage.task(start_at(stage, ends(found.stages)))
