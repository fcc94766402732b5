# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table of a plan file of kind pinch."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from .. import pinch
from ..tasks.options import described_by
from ..tasks.pinch.model import PinchTask
from ..tasks.shapes import Point3
from .table import Counters, MotionRows, PlanFields, PoseRow, require_unit_quaternions

if TYPE_CHECKING:
    Status = str
else:
    Status = Literal[tuple(pinch.Status.__members__)]


class Segment(MotionRows):
    """Part of a motion."""

    MAKE: ClassVar = pinch.Segment

    name: str = Field(description="approach, grasp or close")


@described_by(pinch.Statistics)
class PinchStatistics(Counters):
    """Counters of the search."""


class PinchPlanFile(PlanFields):
    """A plan with its whole task."""

    kind: Literal["pinch"]
    status: Status
    stats: PinchStatistics
    joint_names: list[str]
    opening: float = Field(description="distance between the fingers of the open hand [m]")
    friction: float = Field(description="coefficient of friction that the pinch needs")
    max_mass: float | None = Field(
        default=None,
        description="largest mass that the pads hold [kg]; null if the hand's force is unknown",
    )
    X_WH_grasp: PoseRow = Field(description="pose of the hand's grasp frame at the pinch")
    contacts_O: Annotated[list[Point3], Field(max_length=2)] = Field(
        description="(2, 3) contacts of the fingers in O [m]; none unless solved"
    )
    segments: list[Segment]
    task: PinchTask = Field(
        description="fields of the task file, with the content of all files that it names"
    )

    @model_validator(mode="after")
    def _check(self) -> PinchPlanFile:
        for segment in self.segments:
            segment.check(len(self.joint_names))
        require_unit_quaternions([self.X_WH_grasp])
        return self


File = PinchPlanFile
