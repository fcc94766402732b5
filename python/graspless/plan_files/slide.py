# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table of a plan file of kind slide."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar, Literal

from pydantic import Field, model_validator

from .. import slide
from ..tasks.options import described_by
from ..tasks.slide.model import SlideTask
from .table import Counters, MotionRows, PlanFields, PoseRow, Table, require_unit_quaternions

if TYPE_CHECKING:
    Status = str
else:
    Status = Literal[tuple(slide.Status.__members__)]


class Segment(MotionRows):
    """Part of a motion."""

    MAKE: ClassVar = slide.Segment

    name: str = Field(description="approach, press, slide, lift, reach, grasp, close or retreat")


class Interruption(Table):
    """State in which a slide was interrupted, and from which the plan goes on."""

    MAKE: ClassVar = slide.Interruption

    q: list[float] = Field(description="(dof,) commanded joints, rad or m")
    X_WO: PoseRow = Field(description="measured pose of the object")
    X_WO_goal: PoseRow | None = Field(
        default=None, description="pose of the object at the goal of the interrupted plan"
    )


class Tube(Table):
    """Bounds on where the object can be, relative to the plan."""

    MAKE: ClassVar = slide.Tube

    position: list[float] = Field(
        default=[],
        description="(N,) largest distance of the object from its planned position, "
        "at each row of the slide, m",
    )
    angle: list[float] = Field(
        default=[],
        description="(N,) largest angle of the object from its planned orientation, "
        "at each row of the slide, rad",
    )


@described_by(slide.Statistics)
class SlideStatistics(Counters):
    """Counters of the search."""


class SlidePlanFile(PlanFields):
    """A plan with its whole task."""

    kind: Literal["slide"]
    status: Status
    stats: SlideStatistics
    joint_names: list[str]
    overhang: float = Field(
        description="length of the object beyond the edge at the goal [m]; 0 with an end"
    )
    max_mass: float | None = Field(
        default=None,
        description="largest mass that the fingers bear when they lift the object [kg]; null if "
        "the effort limit of a joint that must is unknown, or with an end",
    )
    X_WO_goal: PoseRow = Field(description="pose of the object after the slide")
    X_WH_grasp: PoseRow = Field(
        description="pose of the hand's grasp frame at the grasp; the identity with an end"
    )
    resumed: Interruption | None = Field(
        default=None,
        description="where the plan goes on; without it, it begins at the task's home",
    )
    segments: list[Segment]
    tube: Tube = Field(
        default=Tube(), description="where the object can be during the slide; empty: not stated"
    )
    warnings: list[str] = Field(
        default=[], description="risks that the plan carries, one sentence each"
    )
    task: SlideTask = Field(
        description="fields of the task file, with the content of all files that it names"
    )

    @model_validator(mode="after")
    def _check(self) -> SlidePlanFile:
        dof = len(self.joint_names)
        for segment in self.segments:
            segment.check(dof)
        require_unit_quaternions([self.X_WO_goal, self.X_WH_grasp])
        if self.resumed is not None:
            if len(self.resumed.q) != dof:
                raise ValueError(f"resumed.q has {len(self.resumed.q)} values for {dof} joints")
            poses = [self.resumed.X_WO, self.resumed.X_WO_goal]
            require_unit_quaternions([pose for pose in poses if pose is not None])
        return self


File = SlidePlanFile
