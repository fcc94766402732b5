# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several planners one after the other: each stage starts where the one before it ended."""

from __future__ import annotations

import enum
import time
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import numpy as np

from .._any_plan import AnyPlan
from .._named import Named
from ..errors import TaskError
from ..kinds import missing_motion
from ..plan_files import plan_of
from ..plan_files.chain import Join, Segment
from ..plan_files.text import document_of
from ..tasks.chain import ON_SUPPORT, Options, Problem, Stage
from .check import check_joins
from .search import Found, Statistics, add_stage, search
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
    def joint_names(self) -> tuple[str, ...]:
        """The robot's joints, which all stages share; empty without a robot."""
        return self.stages[0].joint_names if self.stages else ()

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
        return cls._of_search(search(task, budget), task)

    @classmethod
    def _of_search(cls, found: Found, task: Any) -> Plan:
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
        faults = []
        for k, (name, stage) in enumerate(zip(self.names, self.stages, strict=True)):
            own = stage._faults() if stage else [f"not solved: {stage.reason}"]
            faults += [f"stage {k} '{name}': {fault}" for fault in own]
        missing = missing_motion(self)
        if missing:
            return faults or [f"plan: {missing}"]
        asked = self.task.problem.stages
        return faults + check_joins(asked, self.names, self.stages, self.joins, self.contents)

    def _certificates(self) -> list[tuple[str, EdgeCertificate | None]]:
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
    found = Found(stages=list(before.stages))
    found.statistics = Statistics(attempts=before.statistics.attempts)
    add_stage(found, task.problem.stages[-1], task, budget)
    found.statistics.seconds = before.statistics.seconds + time.monotonic() - began
    return Plan._of_search(found, task)


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
