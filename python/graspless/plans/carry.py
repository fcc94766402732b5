# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans of carrying what the hand holds."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

from .. import carry
from . import Plan as AnyPlan
from .carry_model import CarryPlanFile
from .joints import Segment, segment_documents, segments

if TYPE_CHECKING:
    from .. import planning
    from ..tasks import Task

File = CarryPlanFile


class Plan(AnyPlan):
    """A straight way of what the hand holds, or why not."""

    fields: CarryPlanFile

    @property
    def joint_names(self) -> list[str]:
        """The columns of positions."""
        return self.fields.joint_names

    @property
    def reached(self) -> float:
        """How much of the way was possible, 0 to 1."""
        return self.fields.reached

    @cached_property
    def segments(self) -> list[Segment]:
        """Stretches of motion, in order."""
        return segments(self.fields)

    def to_core(self) -> carry.Plan:
        """The planner's own type."""
        plan = carry.Plan()
        plan.status = carry.Status.__members__[self.status]
        plan.reason = self.reason
        plan.joint_names = self.joint_names
        plan.reached = self.reached
        plan.segments = [carry.Segment(s.name, s.positions, s.object_poses) for s in self.segments]
        return plan


def search(task: Task, budget: planning.Budget) -> carry.Plan:
    """Plans; `budget` instead of the task's."""
    return carry.plan(task.problem, task.options, budget)


def check(plan: Plan) -> list[str]:
    """What does not hold of a plan that is solved."""
    return list(carry.check(plan.task.problem, plan.to_core(), plan.task.options))


def document(found: carry.Plan, task: Task) -> dict[str, Any]:
    """What a plan file holds of this kind alone."""
    return {
        "joint_names": list(found.joint_names),
        "reached": float(found.reached),
        "segments": segment_documents(found),
    }
