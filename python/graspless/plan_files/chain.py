# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table of a plan file of kind chain: its stages are whole plan files."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Discriminator, Field, model_validator

from ..tasks.chain.model import ChainTask
from ..tasks.shapes import CountOrZero, Fields, Index
from .carry import CarryPlanFile
from .clasp import ClaspPlanFile
from .fingertip import FingertipPlanFile
from .pinch import PinchPlanFile
from .slide import SlidePlanFile
from .table import Counters, PlanFields, PoseRow, require_unit_quaternions

StagePlan = Annotated[
    SlidePlanFile | PinchPlanFile | FingertipPlanFile | ClaspPlanFile | CarryPlanFile,
    Discriminator("kind"),
]


class Join(Fields):
    """State between two stages."""

    how: Literal["held", "arm", "regrasp"] = Field(
        description="held: the hand holds the object; arm: the arm continues from its last "
        "configuration; regrasp: fingertips without an arm, which all lift and touch anew"
    )
    X_WO: PoseRow = Field(description="pose of the object")
    positions: list[float] | None = Field(
        default=None, description="(dof,) all joints, rad or m; null without an arm"
    )


class Segment(Fields):
    """Place of a segment of the whole chain: its stage, and its index there."""

    name: str
    stage: Index
    segment: Index = Field(description="index of the segment in that stage")


class ChainStatistics(Counters):
    """Counters of the search."""

    seconds: float = 0.0
    planned_stages: CountOrZero = Field(default=0, description="number of stages with a plan")
    attempts: CountOrZero = Field(default=1, description="number of searches from the first stage")


class ChainPlanFile(PlanFields):
    """Plans one after the other, with the whole task."""

    kind: Literal["chain"]
    stats: ChainStatistics
    status: str = Field(
        description="solved; not_joined: a stage cannot start at the end of the one before it; "
        "out_of_time: before a stage was started; or the status of the first stage that is "
        "not solved"
    )
    names: list[str] = Field(description="names of the stages")
    stages: list[StagePlan] = Field(description="complete plans of the stages that were planned")
    joins: list[Join] = Field(description="states between the stages")
    segments: list[Segment] = Field(description="segments of all stages, in order")
    task: ChainTask = Field(
        description="fields of the task file, with the content of all files that it names"
    )

    @model_validator(mode="after")
    def _check(self) -> ChainPlanFile:
        if len(self.names) != len(self.stages):
            raise ValueError(f"{len(self.stages)} stages have {len(self.names)} names")
        if len(self.stages) > len(self.task.stages):
            what = f"{len(self.stages)} stages of a task that has {len(self.task.stages)}"
            raise ValueError(what)
        require_unit_quaternions([join.X_WO for join in self.joins])
        return self


File = ChainPlanFile
