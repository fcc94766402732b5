# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several planners one after the other: each stage starts where the one before it ended."""

from __future__ import annotations

import enum
import time
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import numpy as np

from .. import limits
from .._named import Named
from .._plan import AnyPlan
from ..errors import OutOfTimeError, TaskError
from ..kinds import plan_type
from ..plan_files import document_of, plan_of
from ..plan_files.chain import Join, Segment
from ..tasks.chain import ON_SUPPORT, Options, Problem, Stage, start_at
from .state import begins, ends, join

if TYPE_CHECKING:
    from .. import planning, tasks
    from .._plan import Plan as StagePlan
    from ..frames import Matrix
    from ..scene import EdgeCertificate

    Task = tasks.Task[Problem, Options, "Plan"]


class Status(Named):
    """Status of a chain beyond those of its stages."""

    solved = 0
    not_joined = 1
    out_of_time = 2


@dataclass
class Statistics:
    """Counters of the search."""

    seconds: float = 0.0
    planned_stages: int = 0
    attempts: int = 1

    def as_dict(self) -> dict[str, Any]:
        """Returns all fields by name."""
        return dict(vars(self))


class Plan(AnyPlan):
    """Plans one after the other, or which of them is missing and why. False unless solved."""

    kind: ClassVar[Literal["chain"]] = "chain"

    def __init__(self) -> None:
        self.status: enum.Enum = Status.out_of_time
        self.reason = ""
        self.statistics = Statistics()
        self.names: list[str] = []
        self.stages: tuple[StagePlan, ...] = ()
        self.joins: tuple[Join, ...] = ()
        self.contents: tuple[Segment, ...] = ()

    if TYPE_CHECKING:

        @property
        def task(self) -> Task: ...

    def __bool__(self) -> bool:
        return str(self.status) == "solved"

    @property
    def segments(self) -> tuple[Any, ...]:
        """Segments of all stages, in order."""
        return tuple(segment for stage in self.stages for segment in stage.segments)

    @cached_property
    def object_frames(self) -> list[Matrix]:
        """Poses [4, 4] of each stage's object frame in that of the first stage. They differ if a
        slide or a pinch follows fingertips, because these use another frame for the same object.
        """
        found = [np.eye(4)]
        for before, stage in pairwise(self.stages):
            X_OO = np.eye(4)
            if before.kind == "fingertip" and stage.kind in ON_SUPPORT and stage:
                X_OO = np.linalg.inv(ends([before]).X_WO) @ begins(stage)[1]
            found.append(found[-1] @ X_OO)
        return found

    def _fields(self) -> dict[str, Any]:
        return {
            "status": str(self.status),
            "reason": self.reason,
            "stats": self.statistics.as_dict(),
            "names": list(self.names),
            "stages": [document_of(stage) for stage in self.stages],
            "joins": [_plain(join) for join in self.joins],
            "segments": [_plain(segment) for segment in self.contents],
        }

    @classmethod
    def _made(cls, fields: dict[str, Any], task: Any) -> Plan:
        stages: list[Any] = [
            plan_of(document, f"stages[{k}]: task") for k, document in enumerate(fields["stages"])
        ]
        return cls._joined(fields, stages, task)

    @classmethod
    def _joined(cls, fields: dict[str, Any], stages: list[Any], task: Any) -> Plan:
        plan = cls()
        plan.status = _ended(fields["status"], stages)
        plan.reason, plan.names = fields["reason"], list(fields["names"])
        known = vars(plan.statistics)
        stats = {name: n for name, n in fields["stats"].items() if name in known}
        plan.statistics = Statistics(**stats)
        plan.stages = tuple(stages)
        plan.joins = tuple(Join.model_validate(join) for join in fields["joins"])
        plan.contents = tuple(Segment.model_validate(s) for s in fields["segments"])
        plan._task = task
        return plan

    @classmethod
    def _search(cls, task: Any, budget: planning.Budget) -> Plan:
        return cls._of_search(_search(task, budget), task)

    @classmethod
    def _of_search(cls, found: _Found, task: Any) -> Plan:
        stages = found.stages
        fields = {
            "status": found.status,
            "reason": found.reason,
            "stats": found.statistics.as_dict() | {"planned_stages": len(stages)},
            "names": [stage.name for stage in task.problem.stages[: len(stages)]],
            "joins": [join(stages[:k]) for k in range(1, len(stages))],
            "segments": [
                {"name": segment.name, "stage": k, "segment": i}
                for k, stage in enumerate(stages)
                for i, segment in enumerate(stage.segments)
            ],
        }
        return cls._joined(fields, stages, task)

    def _faults(self) -> list[str]:
        """Returns the faults of a solved plan, in its stages and between them."""
        from .check import check_joins

        faults = []
        for k, (name, stage) in enumerate(zip(self.names, self.stages, strict=True)):
            own = stage._faults() if stage else [f"not solved: {stage.reason}"]
            faults += [f"stage {k} '{name}': {fault}" for fault in own]
        return faults + check_joins(self)

    def _certificates(self) -> list[tuple[str, EdgeCertificate]]:
        """Returns the certificates of all stages."""
        return [
            (f"stage {k} '{name}': {words}", found)
            for k, (name, stage) in enumerate(zip(self.names, self.stages, strict=True))
            for words, found in stage._certificates()
        ]


def _plain(fields: Any) -> dict[str, Any]:
    document: dict[str, Any] = fields.model_dump(mode="json", exclude_none=True)
    return document


def _ended(name: str, stages: list[Any]) -> enum.Enum:
    """Returns the status of the first stage that is not solved, or the chain's own."""
    if name in Status.__members__:
        return Status[name]
    failed = next((stage.status for stage in stages if stage.status == name), None)
    if failed is None:
        raise TaskError(f"status: {name}: no stage of the chain has it")
    status: enum.Enum = failed
    return status


def continued(before: Plan, task: Any, budget: planning.Budget) -> Plan:
    """Returns a solved plan with one more stage, the last one of `task`.

    Parameters
    ----------
    before : Plan
    task : Task
        The task of `before`, with one more stage.
    budget : planning.Budget
        Budget of that stage.
    """
    began = time.monotonic()
    found = _Found(stages=list(before.stages))
    found.statistics = Statistics(attempts=before.statistics.attempts)
    _add(found, task.problem.stages[-1], task, budget)
    found.statistics.seconds = before.statistics.seconds + time.monotonic() - began
    return Plan._of_search(found, task)


@dataclass
class _Found:
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


def _search(task: Task, budget: planning.Budget) -> _Found:
    """Plans stage after stage, with `budget` instead of the task's. A stage gets the seconds
    that are left, and all iterations. Of n stages, stage k of attempt j, both from 0, has
    the budget's seed + j n + k.
    """
    began = time.monotonic()
    best: _Found | None = None
    for attempt in range(task.options.attempts):
        found = _attempt(task, budget, began, attempt)
        if best is None or found.status == "solved" or len(found.stages) > len(best.stages):
            best = found
        best.statistics.attempts = attempt + 1
        if not found.may_do_better() or time.monotonic() - began >= budget.seconds:
            break
    assert best is not None
    best.statistics.seconds = time.monotonic() - began
    return best


def _attempt(task: Task, budget: planning.Budget, began: float, attempt: int) -> _Found:
    """Plans the stages from the first to the last, or to the first that is not found."""
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


def _start(found: _Found, stage: Stage, task: Task) -> Task:
    if not found.stages:
        first: Task = task.problem.first
        return first
    return stage.task(start_at(stage, ends(found.stages)))


__all__ = [
    "Join",
    "Options",
    "Plan",
    "Problem",
    "Segment",
    "Stage",
    "Statistics",
    "Status",
    "continued",
]


def __dir__() -> list[str]:
    return __all__
