# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table of a plan file of kind carry."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from .. import carry
from ..tasks.carry.model import CarryTask
from ..tasks.options import described_by
from ..tasks.shapes import IndexOrNone
from .table import Counters, MotionRows, PlanFields

if TYPE_CHECKING:
    Status = str
else:
    Status = Literal[tuple(carry.Status.__members__)]


class Segment(MotionRows):
    """Part of a motion."""

    MAKE: ClassVar = carry.Segment

    name: str = Field(description="carry; with places transfer, lower, open or retreat")


@described_by(carry.Statistics)
class CarryStatistics(Counters):
    """Counters of the search."""


class CarryPlanFile(PlanFields):
    """A plan with its whole task."""

    kind: Literal["carry"]
    status: Status
    stats: CarryStatistics
    joint_names: list[str]
    reached: Annotated[float, Field(ge=0, le=1)] = Field(
        description="fraction of the path that was reached, in [0, 1]"
    )
    place: IndexOrNone = Field(
        default=-1, description="index of the place where the object is put down; -1: none"
    )
    segments: list[Segment]
    task: CarryTask = Field(
        description="fields of the task file, with the content of all files that it names"
    )

    @model_validator(mode="after")
    def _check(self) -> CarryPlanFile:
        for segment in self.segments:
            segment.check(len(self.joint_names))
        return self


File = CarryPlanFile
