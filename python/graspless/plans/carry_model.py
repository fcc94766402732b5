# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a plan file of kind carry holds."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from ..tasks.carry.model import CarryTask
from ..tasks.shapes import Fields
from .joints import require_rows
from .model import PlanFields, PoseRow

Status = Literal["solved", "start_in_collision", "not_found", "interrupted"]


class Segment(Fields):
    """A stretch of motion."""

    name: str = Field(description="carry")
    positions: list[list[float]] = Field(description="[N][dof], rad or m")
    object_poses: list[PoseRow] = Field(description="[N][7], x y z qw qx qy qz in the world")


class CarryPlanFile(PlanFields):
    """A plan with its whole task."""

    kind: Literal["carry"]
    status: Status
    joint_names: list[str]
    reached: Annotated[float, Field(ge=0, le=1)] = Field(
        description="how much of the way was possible"
    )
    segments: list[Segment]
    task: CarryTask = Field(description="the task file, with all that it names")

    @model_validator(mode="after")
    def _check(self) -> CarryPlanFile:
        for segment in self.segments:
            where = f"segment '{segment.name}'"
            require_rows(where, segment.positions, segment.object_poses, len(self.joint_names))
        return self
