# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a plan file holds, format 1; `plan.schema.json` is made from it."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from .tasks.model import SlideTask
from .tasks.shapes import Fields

Row = Annotated[list[float], Field(min_length=7, max_length=7)]
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
    object_poses: list[Row] = Field(description="[N][7], x y z qw qx qy qz in the world")


class PlanFile(Fields):
    """A plan with its whole task."""

    format: Literal[1]
    kind: Literal["slide"]
    version: str = Field(description="of graspless, that wrote it")
    status: Status
    reason: str = Field(description="one sentence, for people")
    seed: int
    joint_names: list[str]
    overhang: float = Field(description="how far the object sticks out at the goal [m]")
    X_WO_goal: Row = Field(description="pose of the object after the slide")
    X_WH_grasp: Row = Field(description="pose of the hand's grasp frame at the grasp")
    stats: dict[str, float | int | dict[str, int]] = Field(description="what the search did")
    segments: list[Segment]
    task: SlideTask = Field(description="the task file, with all that it names")

    @model_validator(mode="after")
    def _check(self) -> PlanFile:
        dof = len(self.joint_names)
        for segment in self.segments:
            if len(segment.positions) != len(segment.object_poses):
                counts = f"{len(segment.positions)} positions and {len(segment.object_poses)} poses"
                raise ValueError(f"segment '{segment.name}' has {counts}: one a row are needed")
            for i, row in enumerate(segment.positions):
                if len(row) != dof:
                    where = f"row {i} of segment '{segment.name}'"
                    raise ValueError(f"{where} has {len(row)} values for {dof} joint_names")
        poses = [row for segment in self.segments for row in segment.object_poses]
        for row in [self.X_WO_goal, self.X_WH_grasp, *poses]:
            if abs(sum(value * value for value in row[3:]) - 1) > 1e-6:
                raise ValueError(f"quaternion {row[3:]} is not of unit length")
        return self
