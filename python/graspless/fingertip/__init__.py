# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Push, slide and tumble an object with bare fingertips (Maeda, Arai).

>>> import numpy as np
>>> from graspless import fingertip
>>> block = fingertip.Object.box("block", [0.05, 0.10, 0.05], mass=0.2)
>>> X_WO = np.eye(4)
>>> X_WO[2, 3] = 0.025  # it stands on the floor z = 0
>>> motion = fingertip.slide_path(X_WO, [0.10, 0.0, 0.0], segments=30)
>>> problem = fingertip.Problem(object=block, motion=motion)
>>> plan = fingertip.plan(problem)  # doctest: +SKIP
>>> assert plan and not fingertip.check(problem, plan)  # doctest: +SKIP
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, ClassVar, Literal

from .._any_plan import AnyPlan, of_found, own_segments
from .._arguments import require_integer, require_type
from .._core import fingertip as _core
from .._core.fingertip import (
    Carrier,
    Face,
    Fingers,
    FingerState,
    Goal,
    Lattice,
    Object,
    Options,
    Path,
    Plane,
    Problem,
    Realization,
    RealizeOptions,
    Relaxation,
    Row,
    Search,
    Statistics,
    Status,
    certify_realization,
    check,
    check_realization,
    join,
    plan_carried,
    realize,
    slide_path,
    turn_path,
    validate,
)
from .._core.mechanics import Compliance, FingerMode
from ..collision import Obstacle
from .segments import JointSegment, Segment, Weakest

Motion = Path | Lattice | Goal

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .. import tasks
    from ..planning import Budget
    from ..scene import EdgeCertificate

    Task = tasks.Task[Problem, Options, "Plan"]


class Plan(AnyPlan, _core.Plan):
    """Motion and forces of the fingertips, or the reason of failure. False unless solved."""

    kind: ClassVar[Literal["fingertip"]] = "fingertip"
    _planner: ClassVar[Any] = _core

    if TYPE_CHECKING:

        @property
        def task(self) -> Task: ...

        segments: tuple[Segment, ...]  # type: ignore[override]
        cost: float | None  # type: ignore[assignment]
        lower_bound: float | None  # type: ignore[assignment]
        withstands: float | None  # type: ignore[assignment]
        place_tolerance: float | None  # type: ignore[assignment]
    else:
        segments = own_segments(_core.Plan)
        cost = of_found(_core.Plan, "cost", Status.solved, Status.not_realized)
        withstands = of_found(_core.Plan, "withstands", Status.solved, Status.not_realized)
        place_tolerance = of_found(
            _core.Plan, "place_tolerance", Status.solved, Status.not_realized
        )
        lower_bound = property(
            lambda self: _finite(_core.Plan.lower_bound.fget(self)),
            _core.Plan.lower_bound.fset,
            doc="Bound below which no plan on this lattice can cost [m]; None if unknown.",
        )

    realization: Realization | None = None
    """Joint paths of a task with a robot, or why there are none."""

    @property
    def weakest(self) -> Weakest | None:
        """Segment and row of the least stability; None unless solved."""
        place = Weakest(self.weakest_segment, self.weakest_row)
        return None if min(place) < 0 else place

    @weakest.setter
    def weakest(self, place: Weakest) -> None:
        self.weakest_segment, self.weakest_row = place

    @property
    def joint_names(self) -> tuple[str, ...]:
        """Columns of the positions of joint_segments; empty without a robot."""
        return () if self.realization is None else self.realization.joint_names

    @property
    def joint_segments(self) -> tuple[JointSegment, ...]:
        """Joint motion of a task with a robot, in order; else empty."""
        found = () if self.realization is None else self.realization.segments
        return tuple(
            JointSegment(s.name, s.positions, s.X_WO, s.plan_segment, s.scrub) for s in found
        )

    @classmethod
    def _of(cls, found: Any, task: Any, **changes: Any) -> Plan:
        changes["segments"] = [Segment(s.name, s.X_WO, s.rows, s.finger) for s in found.segments]
        changes["lower_bound"] = _finite(found.lower_bound)
        if found.status not in (Status.solved, Status.not_realized):
            changes["cost"] = changes["withstands"] = changes["place_tolerance"] = None
        if found.weakest_segment >= 0:
            changes["weakest"] = Weakest(found.weakest_segment, found.weakest_row)
        return cls._of_changed(found, task, changes)

    @classmethod
    def _search(cls, task: Any, budget: Budget) -> Plan:
        """Plans, and gives the plan the task's arm."""
        arm = task.arm
        if arm is None:
            return cls._of(_core.plan(task.problem, task.options, budget), task)
        found, paths = plan_carried(
            task.problem, task.options, arm.robot, arm.carrier, arm.q_home, arm.options, budget
        )
        was_tried = found.status in (Status.solved, Status.not_realized)
        return cls._of(found, task, realization=paths if was_tried else None)

    def _faults(self) -> list[str]:
        """Returns the faults of a solved plan and of its joint paths."""
        task, faults = self.task, super()._faults()
        if task.arm is None:
            return faults
        if self.realization is None:
            return [*faults, "realization: missing, and the task has a robot"]
        arm = task.arm
        return faults + check_realization(
            task.problem, self, arm.robot, arm.carrier, self.realization, arm.options
        )

    def _certificates(self) -> list[tuple[str, EdgeCertificate | None]]:
        """Returns the certificate of the joint paths; None without a robot."""
        arm, paths = self.task.arm, self.realization
        if arm is None or paths is None:
            return [("", None)]
        found = certify_realization(
            self.task.problem, self, arm.robot, arm.carrier, paths, arm.options
        )
        return [("", found)]


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def plan(problem: Problem, options: Options | None = None, budget: Budget | None = None) -> Plan:
    """Plans the places, control modes and regrasps of the fingers (Maeda, Arai 2005, Section 4).

    Finding no plan is a status, not an error. Releases the GIL: other Python threads can run.
    Ctrl-C raises KeyboardInterrupt. budget.stop() returns the best plan so far.

    Parameters
    ----------
    problem : Problem
        Object, motion, fingers and planes.
    options : Options, optional
        Settings of the search; by default `Options()`. The plan keeps a copy of them.
    budget : planning.Budget, optional
        Time and randomness; by default 10 s and seed 1.

    Returns
    -------
    Plan
        False unless solved: `status` and `reason` then say why.

    Raises
    ------
    ValueError
        A bad problem or bad options; names the field, its value and what is allowed.
    """
    return Plan._planned(problem, options, budget)


def resume(
    plan: Plan,
    segment: int,
    X_WO: ArrayLike,
    *,
    options: Options | None = None,
    budget: Budget | None = None,
) -> Plan:
    """Plans the rest of a plan from a measured pose of the object, with the fingers where they are.

    The task of the rest is one of its own: `check`, plan files and `resume` take it as any other.
    It begins at the nearest pose of the segment, moved along the floor and turned about its normal
    as measured, with `fingers.start` as in the segment; in a regrasp, as after it. From there the
    object goes on through the poses of the plan. If a wall keeps the object from where it was
    measured, the rest begins at the pose itself, with a warning.

    A state from which the plan does not go on is a status with a reason, never an exception:

    - off_path: the object is more than 20 mm or 10 degrees from all poses of the segment.
    - at_goal: the object is at the last pose of the plan.
    - those of `plan`, such as unstable: the fingers cannot bring the object back to its path.

    Parameters
    ----------
    plan : Plan
        Solved plan of the fingertips, without a robot.
    segment : int
        Index of the segment that is under way.
    X_WO : (4, 4) array
        Measured pose of the object in the world.
    options : Options, optional
        Settings of the search; by default those of the plan.
    budget : planning.Budget, optional
        Time and randomness; by default those of the plan.

    Returns
    -------
    Plan
        False unless solved.

    Raises
    ------
    ValueError
        The plan is not solved or has joint paths of a robot, there is no such segment, or the pose
        is not rigid.
    """
    from ..tasks import Task

    require_type("plan", plan, Plan)
    segment = require_integer("segment", segment, least=0)
    task = plan.task
    if task.arm is not None:
        raise ValueError("plan: has joint paths of a robot; only plans of fingertips are resumed")
    options, budget = plan._settings(options, budget)
    problem, found = _core.resume(task.problem, plan, segment, X_WO, options, budget)
    return Plan._of(found, Task.of(problem, options, budget))


__all__ = [
    "Carrier",
    "Compliance",
    "Face",
    "FingerMode",
    "FingerState",
    "Fingers",
    "Goal",
    "JointSegment",
    "Lattice",
    "Motion",
    "Object",
    "Obstacle",
    "Options",
    "Path",
    "Plan",
    "Plane",
    "Problem",
    "Realization",
    "RealizeOptions",
    "Relaxation",
    "Row",
    "Search",
    "Segment",
    "Statistics",
    "Status",
    "Weakest",
    "certify_realization",
    "check",
    "check_realization",
    "join",
    "plan",
    "plan_carried",
    "realize",
    "resume",
    "slide_path",
    "turn_path",
    "validate",
]


def __dir__() -> list[str]:
    return __all__
