# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a plan file of kind slide holds."""

from __future__ import annotations

from typing import Literal

from pydantic import Field, model_validator

from ..tasks.shapes import Fields
from ..tasks.slide.model import SlideTask
from .joints import require_rows
from .model import PlanFields, PoseRow, require_unit_quaternions

Status = Literal[
    "solved",
    "start_in_collision",
    "no_start_root",
    "no_goal_root",
    "no_valid_pair",
    "not_connected",
    "interrupted",
]


class Segment(Fields):
    """A stretch of motion."""

    name: str = Field(description="approach, press, slide, lift, reach, grasp or close")
    positions: list[list[float]] = Field(description="[N][dof], rad or m")
    object_poses: list[PoseRow] = Field(description="[N][7], x y z qw qx qy qz in the world")


class SlidePlanFile(PlanFields):
    """A plan with its whole task."""

    kind: Literal["slide"]
    status: Status
    joint_names: list[str]
    overhang: float = Field(description="how far the object sticks out at the goal [m]")
    X_WO_goal: PoseRow = Field(description="pose of the object after the slide")
    X_WH_grasp: PoseRow = Field(description="pose of the hand's grasp frame at the grasp")
    segments: list[Segment]
    warnings: list[str] = Field(default=[], description="what to be careful of")
    task: SlideTask = Field(description="the task file, with all that it names")

    @model_validator(mode="after")
    def _check(self) -> SlidePlanFile:
        dof = len(self.joint_names)
        for segment in self.segments:
            where = f"segment '{segment.name}'"
            require_rows(where, segment.positions, segment.object_poses, dof)
        require_unit_quaternions([self.X_WO_goal, self.X_WH_grasp])
        return self
