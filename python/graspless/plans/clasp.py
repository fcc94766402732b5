# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans of the clasp planner."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import clasp, frames, geometry
from . import Plan as AnyPlan
from . import clasp_model as model
from . import joints
from .joints import poses, positions, to_rows

if TYPE_CHECKING:
    from .. import planning
    from ..frames import Matrix
    from ..tasks import Task

File = model.ClaspPlanFile


@dataclass(frozen=True)
class Segment(joints.Segment):
    """A stretch of motion: reach or close. The object stands still.

    Attributes
    ----------
    virtual_linking : array [N, curves]
        Of every finger curve with the loop that is clasped: 0 not linked, 1 closed around it.
    """

    virtual_linking: Matrix


class Plan(AnyPlan):
    """A motion that ends in a clasp, or why not."""

    fields: model.ClaspPlanFile

    @property
    def joint_names(self) -> list[str]:
        """The columns of positions."""
        return self.fields.joint_names

    @property
    def loop(self) -> int | None:
        """Which loop is clasped: index of task.problem.object.loops.loops; None unless solved."""
        return self.fields.loop

    @property
    def target(self) -> model.Target | None:
        """Where on the loop, in the object frame; None unless solved."""
        return self.fields.target

    @property
    def min_linking(self) -> float:
        """The threshold of virtual linking that was in force."""
        return self.fields.min_linking

    @property
    def stability(self) -> model.Stability | None:
        """What the stability test says of the last row; None unless solved."""
        return self.fields.stability

    @property
    def warnings(self) -> list[str]:
        """What to be careful of."""
        return self.fields.warnings

    @property
    def tree(self) -> model.Tree:
        """The tree that led to the clasp."""
        return self.fields.tree

    @cached_property
    def segments(self) -> list[Segment]:
        """Stretches of motion, in order."""
        dof = len(self.joint_names)
        return [
            Segment(
                segment.name,
                positions(segment.positions, dof),
                poses(segment.object_poses),
                np.array(segment.virtual_linking, dtype=float).reshape(len(segment.positions), -1),
            )
            for segment in self.fields.segments
        ]

    def to_core(self) -> clasp.Plan:
        """The planner's own type."""
        plan = clasp.Plan()
        plan.status = clasp.Status.__members__[self.status]
        plan.reason = self.reason
        plan.joint_names = self.joint_names
        plan.segments = [
            clasp.Segment(s.name, s.positions, s.virtual_linking) for s in self.segments
        ]
        plan.loop = -1 if self.loop is None else self.loop
        if self.target is not None:
            point, tangent = np.array(self.target.point), np.array(self.target.tangent)
            plan.target = geometry.ClaspTarget(point=point, tangent=tangent)
        plan.min_linking = self.min_linking
        if self.stability is not None:
            plan.stability = clasp.Stability(**self.stability.model_dump())
        tree = self.tree
        points = np.array(tree.points, dtype=float).reshape(-1, 3)
        plan.tree = clasp.Tree(points, tree.parents, tree.path)
        plan.warnings = self.warnings
        return plan


def search(task: Task, budget: planning.Budget) -> clasp.Plan:
    """Plans; `budget` instead of the task's."""
    return clasp.plan(task.problem, task.options, budget)


def check(plan: Plan) -> list[str]:
    """What does not hold of a plan that is solved."""
    task = plan.task
    X_WO = np.asarray(task.problem.X_WO)
    faults = [
        f"{segment.name}: row {row}: object_poses: the object does not stand where the task says"
        for segment in plan.segments
        for row, X in enumerate(segment.object_poses)
        if np.abs(X - X_WO).max() > 1e-9
    ]
    return [*clasp.check(task.problem, plan.to_core(), task.options), *faults]


def document(found: clasp.Plan, task: Task) -> dict[str, Any]:
    """What a plan file holds of this kind alone."""
    solved = bool(found)
    target, stability, tree = found.target, found.stability, found.tree
    X_WO = frames.to_row(task.problem.X_WO)
    return {
        "joint_names": list(found.joint_names),
        "loop": found.loop if solved else None,
        "target": {"point": to_rows(target.point), "tangent": to_rows(target.tangent)}
        if solved
        else None,
        "min_linking": float(found.min_linking),
        "stability": {
            "secure": stability.secure,
            "escapes": stability.escapes,
            "margin": float(stability.margin),
            "checks": stability.checks,
        }
        if solved
        else None,
        "segments": [
            {
                "name": segment.name,
                "positions": to_rows(segment.positions),
                "object_poses": [X_WO] * len(segment),
                "virtual_linking": to_rows(segment.virtual_linking),
            }
            for segment in found.segments
        ],
        "tree": {
            "points": to_rows(tree.p_W),
            "parents": list(tree.parents),
            "path": list(tree.path),
        },
        "warnings": list(found.warnings),
    }
