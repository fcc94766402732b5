# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans of several stages."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

from ..errors import TaskError
from ..tasks import task_from_dict
from ..tasks.chain import start_at
from . import Plan as AnyPlan
from . import from_core, plan_kind
from .chain_model import ChainPlanFile
from .chain_state import ends, join

if TYPE_CHECKING:
    from .. import planning
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

    @property
    def statistics(self) -> _Found:
        return self

    def as_dict(self) -> dict[str, Any]:
        return {"seconds": self.seconds, "stages_planned": len(self.stages)}


def search(task: Task, budget: planning.Budget) -> _Found:
    """Plans stage after stage; `budget` instead of the task's. Stage k, from 0, has the budget's
    seed + k, what is left of its seconds, and all of its iterations.
    """
    began = time.monotonic()
    found = _Found()
    for k, stage in enumerate(task.problem.stages):
        left = budget.seconds - (time.monotonic() - began)
        if not _add(found, stage, task, budget, left, k):
            break
    found.seconds = time.monotonic() - began
    return found


def _add(
    found: _Found, stage: Stage, task: Task, budget: planning.Budget, left: float, k: int
) -> bool:
    """Plans a stage from where the last one ended; False where the chain ends with it."""

    def fail(status: str, reason: str) -> bool:
        found.status, found.reason = _Named(status), f"{stage.name}: {reason}"
        return False

    if left <= 0:
        return fail("out_of_time", "no time was left for it")
    try:
        given = _start(found, stage, task)
    except TaskError as error:
        before = task.problem.stages[k - 1].name
        return fail("not_joined", f"cannot start where '{before}' ended: {error}")
    seed = (budget.seed + k) % 2**64
    given = given.with_changes(seconds=left, iterations=budget.iterations, seed=seed)
    plan = from_core(
        plan_kind(stage.kind).search(given, budget.part(seconds=left, seed=seed)), given
    )
    found.stages.append(plan)
    return True if plan else fail(plan.status, plan.reason)


def _start(found: _Found, stage: Stage, task: Task) -> Task:
    if not found.stages:
        first: Task = task.problem.first
        return first
    return stage.task(start_at(stage.fields, ends(found.stages[-1])))


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
