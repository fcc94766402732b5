# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans of the fingertip planner."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import fingertip
from . import Plan as AnyPlan
from . import fingertip_model as model
from .fingertip_core import core_rows, realization_document, segment_document
from .joints import poses, positions

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .. import planning
    from ..frames import Matrix
    from ..tasks import Task

File = model.FingertipPlanFile


@dataclass(frozen=True)
class Segment:
    """A stretch with the fingers where they are, or one regrasp: N rows, n fingers.

    Attributes
    ----------
    name : str
        slide, turn, tumble or regrasp.
    finger : int
        Of a regrasp: who moves, from 0; else -1.
    X_WO : array [K, 4, 4]
        Poses of the lattice, first to last.
    object_poses : array [N, 4, 4]
        X_WO at each row.
    fingers, normals : array [N, n, 3]
        Contact points [m] and normals into the object, in O; NaN while a finger is off it.
    modes : list of list of str
        [N][n] position or force.
    commanded_forces : array [N, n]
        Normal force in force control, else 0 [N].
    nominal_forces : array [N, n, 3]
        On the object, in O [N].
    stability, compliant_stability, nominal_margin : array [N]
        [N].
    """

    name: str
    finger: int
    X_WO: Matrix
    object_poses: Matrix
    fingers: Matrix
    normals: Matrix
    modes: list[list[str]]
    commanded_forces: Matrix
    nominal_forces: Matrix
    stability: Matrix
    compliant_stability: Matrix
    nominal_margin: Matrix

    def __len__(self) -> int:
        return len(self.object_poses)

    @property
    def touches(self) -> NDArray[np.bool_]:
        """[N, n] whether a finger is on the object."""
        return np.asarray(np.isfinite(self.fingers).all(axis=2))


@dataclass(frozen=True)
class JointSegment:
    """A stretch of joint motion.

    Attributes
    ----------
    name : str
        approach, touch, slide, turn, tumble, release, reach or retreat.
    plan_segment : int
        The segment of the plan that it carries out, or -1.
    scrub : float
        How far a fingertip that turns slips on its contact, at worst [m].
    positions : array [N, dof]
        All joints [rad or m].
    object_poses : array [N, 4, 4]
        X_WO at each row.
    """

    name: str
    plan_segment: int
    scrub: float
    positions: Matrix
    object_poses: Matrix

    def __len__(self) -> int:
        return len(self.positions)


@dataclass(frozen=True)
class _Found:
    """What the planner found, and what came of giving it an arm."""

    plan: fingertip.Plan
    realization: fingertip.Realization | None
    statistics: Any
    status: Any
    reason: str


@dataclass(frozen=True)
class _Named:
    name: str


@dataclass(frozen=True)
class _Statistics:
    values: dict[str, Any]

    def as_dict(self) -> dict[str, Any]:
        return self.values


class Plan(AnyPlan):
    """Where the fingers press, or why not."""

    fields: model.FingertipPlanFile

    @property
    def cost(self) -> float | None:
        """By Eqs. (9) and (10) [m]; None unless solved."""
        return self.fields.cost

    @property
    def lower_bound(self) -> float | None:
        """No plan on this lattice is cheaper [m]."""
        return self.fields.lower_bound

    @property
    def regrasps(self) -> int:
        """How often a finger moves to another place."""
        return self.fields.regrasps

    @property
    def warnings(self) -> list[str]:
        """What to be careful of."""
        return self.fields.warnings

    @property
    def limit(self) -> str:
        """Not solved: what blocks."""
        return self.fields.limit

    @property
    def weakest(self) -> tuple[int, int] | None:
        """Segment and row of the least stability."""
        place = self.fields.weakest
        return None if place is None else (place.segment, place.row)

    @cached_property
    def segments(self) -> list[Segment]:
        """Stretches of motion and regrasps, in order."""
        return [_segment(fields) for fields in self.fields.segments]

    @property
    def joint_names(self) -> list[str]:
        """The columns of joint_segments' positions; empty without a robot."""
        return [] if self.fields.realization is None else self.fields.realization.joint_names

    @cached_property
    def joint_segments(self) -> list[JointSegment]:
        """The joint motion of a task with a robot, in order; else empty."""
        found = self.fields.realization
        if found is None:
            return []
        return [
            JointSegment(
                segment.name,
                segment.plan_segment,
                segment.scrub,
                positions(segment.positions, len(found.joint_names)),
                poses(segment.object_poses),
            )
            for segment in found.segments
        ]

    def to_core(self) -> fingertip.Plan:
        """The planner's own type."""
        plan = fingertip.Plan()
        not_realized = self.status == "not_realized"
        plan.status = fingertip.Status.__members__["solved" if not_realized else self.status]
        plan.reason = "" if not_realized else self.reason
        plan.cost = self.cost or 0.0
        plan.lower_bound = math.inf if self.lower_bound is None else self.lower_bound
        plan.regrasps = self.regrasps
        plan.warnings = self.warnings
        plan.weakest_segment, plan.weakest_row = self.weakest or (-1, -1)
        plan.segments = [
            fingertip.Segment(s.name, s.X_WO, core_rows(s), s.finger) for s in self.segments
        ]
        return plan

    def to_core_realization(self) -> fingertip.Realization | None:
        """The joint paths in the planner's own type."""
        fields = self.fields.realization
        if fields is None:
            return None
        found = fingertip.Realization()
        found.found = fields.found
        found.reason = fields.reason
        found.joint_names = fields.joint_names
        found.finger_of_fingertip = fields.finger_of_fingertip
        found.segments = [
            fingertip.JointSegment(s.name, s.positions, s.object_poses, s.plan_segment, s.scrub)
            for s in self.joint_segments
        ]
        return found


def search(task: Task, budget: planning.Budget) -> _Found:
    """Plans, and gives the plan the task's arm; `budget` instead of the task's."""
    plan = fingertip.plan(task.problem, task.options, budget)
    stats = plan.statistics.as_dict()
    if task.arm is None or not plan:
        return _Found(plan, None, _Statistics(stats), plan.status, plan.reason)
    arm = task.arm
    found = fingertip.realize(
        task.problem, plan, arm.robot, arm.carrier, arm.q_home, arm.options, budget
    )
    if found:
        return _Found(plan, found, _Statistics(stats), plan.status, plan.reason)
    return _Found(plan, found, _Statistics(stats), _Named("not_realized"), found.reason)


def check(plan: Plan) -> list[str]:
    """What does not hold of a plan that is solved, or of its joint paths."""
    task, core = plan.task, plan.to_core()
    faults = list(fingertip.check(task.problem, core, task.options))
    found = plan.to_core_realization()
    if task.arm is not None:
        if found is None:
            return [*faults, "realization: missing, and the task has a robot"]
        arm = task.arm
        faults += fingertip.check_realization(
            task.problem, core, arm.robot, arm.carrier, found, arm.options
        )
    return faults


def document(found: _Found, task: Task) -> dict[str, Any]:
    """What a plan file holds of this kind alone."""
    plan, realization = found.plan, found.realization
    place = (plan.weakest_segment, plan.weakest_row)
    return {
        "cost": _finite(plan.cost) if plan else None,
        "lower_bound": _finite(plan.lower_bound),
        "regrasps": plan.regrasps,
        "weakest": None if min(place) < 0 else {"segment": place[0], "row": place[1]},
        "warnings": list(plan.warnings),
        "limit": plan.limit,
        "relaxations": [{"field": r.field, "value": r.value} for r in plan.relaxations],
        "segments": [segment_document(segment) for segment in plan.segments],
        "realization": None if realization is None else realization_document(realization),
    }


def _segment(fields: model.Segment) -> Segment:
    n = len(fields.fingers[0]) if fields.fingers else 0
    absent = [math.nan] * 3

    def points(rows: list[list[list[float] | None]]) -> Matrix:
        filled = [[absent if p is None else p for p in row] for row in rows]
        return np.array(filled, dtype=float).reshape(-1, n, 3)

    return Segment(
        fields.name,
        fields.finger,
        poses(fields.X_WO),
        poses(fields.object_poses),
        points(fields.fingers),
        points(fields.normals),
        [list(row) for row in fields.modes],
        np.array(fields.commanded_forces, dtype=float).reshape(-1, n),
        np.array(fields.nominal_forces, dtype=float).reshape(-1, n, 3),
        np.array(fields.stability, dtype=float),
        np.array(fields.compliant_stability, dtype=float),
        np.array(fields.nominal_margin, dtype=float),
    )


def _finite(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
