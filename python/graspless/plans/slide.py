# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans of the sliding planner."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

from .. import frames, slide
from . import Plan as AnyPlan
from .joints import Segment, segment_documents, segments
from .slide_model import SlidePlanFile

if TYPE_CHECKING:
    from .. import planning
    from ..frames import Matrix
    from ..tasks import Task

File = SlidePlanFile


class Plan(AnyPlan):
    """A slide and a grasp, or why not."""

    fields: SlidePlanFile

    @property
    def joint_names(self) -> list[str]:
        """The columns of positions."""
        return self.fields.joint_names

    @property
    def overhang(self) -> float:
        """How far the object sticks out at the goal [m]."""
        return self.fields.overhang

    @cached_property
    def X_WO_goal(self) -> Matrix:  # noqa: N802
        """[4, 4] pose of the object after the slide."""
        return frames.from_row(self.fields.X_WO_goal)

    @cached_property
    def X_WH_grasp(self) -> Matrix:  # noqa: N802
        """[4, 4] pose of the hand's grasp frame at the grasp."""
        return frames.from_row(self.fields.X_WH_grasp)

    @cached_property
    def segments(self) -> list[Segment]:
        """Stretches of motion, in order."""
        return segments(self.fields)

    @property
    def warnings(self) -> list[str]:
        """What to be careful of."""
        return self.fields.warnings

    def to_core(self) -> slide.Plan:
        """The planner's own type."""
        plan = slide.Plan()
        plan.status = slide.Status.__members__[self.status]
        plan.reason = self.reason
        plan.joint_names = self.joint_names
        plan.segments = [
            slide.Segment(segment.name, segment.positions, segment.object_poses)
            for segment in self.segments
        ]
        plan.X_WO_goal = self.X_WO_goal
        plan.X_WH_grasp = self.X_WH_grasp
        plan.overhang = self.overhang
        plan.warnings = self.warnings
        return plan


def search(task: Task, budget: planning.Budget) -> slide.Plan:
    """Plans; `budget` instead of the task's."""
    return slide.plan(task.problem, task.options, budget)


def check(plan: Plan) -> list[str]:
    """What does not hold of a plan that is solved."""
    return list(slide.check(plan.task.problem, plan.to_core(), plan.task.options))


def document(found: slide.Plan, task: Task) -> dict[str, Any]:
    """What a plan file holds of this kind alone."""
    return {
        "joint_names": list(found.joint_names),
        "overhang": float(found.overhang),
        "X_WO_goal": frames.to_row(found.X_WO_goal),
        "X_WH_grasp": frames.to_row(found.X_WH_grasp),
        "segments": segment_documents(found),
        "warnings": list(found.warnings),
    }
