# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans of several stages."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import TaskError
from ..tasks import task_from_dict
from ..tasks.chain import start_at
from . import Plan as AnyPlan
from . import from_core, plan_kind
from .chain_model import ChainPlanFile
from .chain_state import begins, ends, join

if TYPE_CHECKING:
    from .. import planning
    from ..frames import Matrix
    from ..tasks import Task
    from ..tasks.chain import Stage

File = ChainPlanFile


class Plan(AnyPlan):
    """Plans one after the other, or which of them is missing and why."""

    fields: ChainPlanFile

    @property
    def names(self) -> list[str]:
        """Of the stages."""
        return self.fields.names

    @cached_property
    def stages(self) -> list[AnyPlan]:
        """The plan of each stage, as far as was planned: all but the last are solved."""
        found: list[AnyPlan] = []
        for i, fields in enumerate(self.fields.stages):
            task = task_from_dict(
                fields.task.model_dump(mode="json", exclude_none=True), f"stages[{i}]: task"
            )
            found.append(plan_kind(fields.kind).Plan(fields, task))
        return found

    @cached_property
    def object_frames(self) -> list[Matrix]:
        """[4, 4] of each stage: its object's frame in that of the first stage's object. They differ
        where a slide follows fingertips, which have a frame of their own for the same object.
        """
        found = [np.eye(4)]
        for before, stage in pairwise(self.stages):
            both = before.kind == "fingertip" and stage.kind == "slide"
            X_OO = (
                np.linalg.inv(ends(before).X_WO) @ begins(stage)[1] if both and stage else np.eye(4)
            )
            found.append(found[-1] @ X_OO)
        return found

    @cached_property
    def segments(self) -> list[Any]:
        """Stretches of motion of all stages, in order."""
        return [segment for stage in self.stages for segment in stage.segments]


@dataclass(frozen=True)
class _Named:
    name: str


@dataclass
class _Found:
    """What the planners have found, with what every planner's plan has."""

    stages: list[AnyPlan] = field(default_factory=list)
    status: _Named = _Named("solved")
    reason: str = ""
    seconds: float = 0.0
    attempts: int = 1

    @property
    def statistics(self) -> _Found:
        return self

    def as_dict(self) -> dict[str, Any]:
        return {
            "seconds": self.seconds,
            "planned_stages": len(self.stages),
            "attempts": self.attempts,
        }

    def fail(self, status: str, reason: str) -> bool:
        """Ends the chain; False."""
        self.status, self.reason = _Named(status), reason
        return False

    def may_do_better(self) -> bool:
        """Whether another start may help: a stage could not go on from what others found."""
        ended = ("solved", "interrupted", "out_of_time")
        first_failed = len(self.stages) == 1 and not self.stages[0]
        return self.status.name not in ended and not first_failed


def search(task: Task, budget: planning.Budget) -> _Found:
    """Plans stage after stage; `budget` instead of the task's. All have what is left of its
    seconds, and each has all of its iterations. Of n stages, stage k of attempt j, both from 0, has
    the budget's seed + j n + k.
    """
    began = time.monotonic()
    best: _Found | None = None
    for attempt in range(task.options.attempts):
        found = _attempt(task, budget, began, attempt)
        if best is None or found.status.name == "solved" or len(found.stages) > len(best.stages):
            best = found
        best.attempts = attempt + 1
        if not found.may_do_better() or time.monotonic() - began >= budget.seconds:
            break
    assert best is not None
    best.seconds = time.monotonic() - began
    return best


def _attempt(task: Task, budget: planning.Budget, began: float, attempt: int) -> _Found:
    """The stages from the first to the last, or to the first that is not found."""
    found = _Found()
    stages = task.problem.stages
    for k, stage in enumerate(stages):
        left = budget.seconds - (time.monotonic() - began)
        if left <= 0:
            found.fail("out_of_time", f"{stage.name}: no time was left for it")
            break
        seed = (budget.seed + attempt * len(stages) + k) % 2**64
        if not _add(found, stage, task, budget.part(seconds=left, seed=seed)):
            break
    return found


def _add(found: _Found, stage: Stage, task: Task, budget: planning.Budget) -> bool:
    """Plans a stage from where the last one ended; False where the chain ends with it."""
    try:
        given = _start(found, stage, task)
    except TaskError as error:
        what = f"cannot start where '{task.problem.stages[len(found.stages) - 1].name}' ended"
        return found.fail("not_joined", f"{stage.name}: {what}: {error}")
    given = given.with_changes(
        seconds=budget.seconds, iterations=budget.iterations, seed=budget.seed
    )
    plan = from_core(plan_kind(stage.kind).search(given, budget), given)
    found.stages.append(plan)
    return True if plan else found.fail(plan.status, f"{stage.name}: {plan.reason}")


def _start(found: _Found, stage: Stage, task: Task) -> Task:
    if not found.stages:
        first: Task = task.problem.first
        return first
    return stage.task(start_at(stage, ends(found.stages[-1])))


def check(plan: Plan) -> list[str]:
    """What does not hold of a plan that is solved: of a stage, or between two."""
    from .chain_check import check_joins

    faults = []
    for k, (name, stage) in enumerate(zip(plan.names, plan.stages, strict=True)):
        own = plan_kind(stage.kind).check(stage) if stage else [f"not solved: {stage.reason}"]
        faults += [f"stage {k} '{name}': {fault}" for fault in own]
    return faults + check_joins(plan)


def document(found: _Found, task: Task) -> dict[str, Any]:
    """What a plan file holds of this kind alone."""
    stages = found.stages
    segments = [
        {"name": segment.name, "stage": k, "segment": i}
        for k, stage in enumerate(stages)
        for i, segment in enumerate(stage.segments)
    ]
    return {
        "names": [stage.name for stage in task.problem.stages[: len(stages)]],
        "stages": [stage.fields.model_dump(mode="json", exclude_none=True) for stage in stages],
        "joins": [join(before) for before in stages[:-1]],
        "segments": segments,
    }
