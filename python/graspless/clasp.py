# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clasp planner: put a hand through a hole of an object and close it.

After Stork, Pokorny, Kragic 2013. `plan` is Section IV, `test_stability` Section V-A;
`certificate` proves what random moves cannot.

>>> import numpy as np
>>> from graspless import clasp, geometry, robot
>>> arm = robot.Robot.from_urdf_file(robot.builtin("kr5_sdh"))  # doctest: +SKIP
>>> hand = clasp.hand_from_yaml_file("kr5_sdh.clasp.yaml")  # doctest: +SKIP
>>> cloud = geometry.sample_surface(clasp.sample_object("purse"), 2000)  # doctest: +SKIP
>>> purse = clasp.Object.from_cloud("purse", cloud)  # doctest: +SKIP
>>> problem = clasp.Problem(arm, hand, purse, X_WO, arm.state("home"))  # doctest: +SKIP
>>> plan = clasp.plan(problem)  # doctest: +SKIP
>>> assert plan and not clasp.check(problem, plan)  # doctest: +SKIP
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Literal

import numpy as np

from ._any_plan import AnyPlan, of_found, own_segments
from ._arguments import require_type
from ._core import clasp as _core
from ._core.clasp import (
    Certificate,
    CertificateOptions,
    CurveNode,
    Finger,
    Hand,
    Hang,
    Object,
    Options,
    Pinch,
    Problem,
    Stability,
    StabilityOptions,
    Statistics,
    Status,
    Tree,
    certificate,
    certify,
    check,
    find_hang,
    hand_from_yaml,
    hand_from_yaml_file,
    sample_object,
    sample_object_names,
    test_pinch,
    test_stability,
    validate,
    with_palm_corners,
)
from .collision import Obstacle

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from . import geometry, tasks
    from .frames import Matrix
    from .planning import Budget

    Task = tasks.Task[Problem, Options, "Plan"]

_GRAVITY = 9.81  # [m/s^2]


class Segment(_core.Segment):
    """Part of a motion: reach or close. No joint moves by more than 0.05 rad between two rows.

    Parameters
    ----------
    name : str
        reach or close.
    positions : array [N, dof]
        All joints [rad or m].
    object_poses : array [N, 4, 4]
        X_WO at each row: the object stands still.
    virtual_linking : array [N, curves]
        Absolute virtual linking of every finger curve with the loop that is clasped.
    """

    def __init__(
        self,
        name: str,
        positions: ArrayLike,
        object_poses: ArrayLike,
        virtual_linking: ArrayLike,
    ) -> None:
        super().__init__(name, positions, virtual_linking)
        self.object_poses: Matrix = np.array(object_poses, dtype=float).reshape(-1, 4, 4)
        if len(self) != len(self.object_poses):
            counts = f"{len(self)} positions but {len(self.object_poses)} object_poses"
            raise ValueError(f"segment '{name}' has {counts}")


class Plan(AnyPlan, _core.Plan):
    """A motion that ends in a clasp, or why not. False unless solved."""

    kind: ClassVar[Literal["clasp"]] = "clasp"
    _planner: ClassVar[Any] = _core

    if TYPE_CHECKING:

        @property
        def task(self) -> Task: ...

        segments: tuple[Segment, ...]  # type: ignore[override]
        loop: int | None  # type: ignore[assignment]
        target: geometry.ClaspTarget | None  # type: ignore[assignment]
        stability: Stability | None  # type: ignore[assignment]
        pinch: Pinch | None
        certificate: Certificate | None
    else:
        segments = own_segments(_core.Plan)
        loop = of_found(_core.Plan, "loop", Status.solved)
        target = of_found(_core.Plan, "target", Status.solved)
        stability = of_found(_core.Plan, "stability", Status.solved)
        pinch = of_found(_core.Plan, "pinch", Status.solved)
        certificate = of_found(_core.Plan, "certificate", Status.solved)

    @classmethod
    def _of(cls, found: Any, task: Any, **changes: Any) -> Plan:
        if not found:
            changes |= dict.fromkeys(("loop", "target", "stability", "pinch", "certificate"))
        changes["segments"] = [
            Segment(s.name, s.positions, [task.problem.X_WO] * len(s), s.virtual_linking)
            for s in found.segments
        ]
        return cls._of_changed(found, task, changes)

    @classmethod
    def _search(cls, task: Any, budget: Budget) -> Plan:
        plan = super()._search(task, budget)
        plan.warnings = [*plan.warnings, *plan._weighed()]
        return plan

    def _weighed(self) -> list[str]:
        """Returns a warning if the object of the task is heavier than what the hand withstands."""
        mass = getattr(getattr(self.task._fields, "object", None), "mass", None)
        load = self.task.options.stability
        if mass is None or self.stability is None or load.force == 0:
            return []
        borne = self.stability.withstands
        if self.pinch is not None and self.pinch.holds:
            borne = max(borne, self.pinch.load * load.force)
        weight = _GRAVITY * mass
        if weight <= borne:
            return []
        what = f"withstands a sudden {borne:.3g} N at most: it may be forced open"
        return [f"the object weighs {weight:.4g} N, and the hand {what}"]

    def _faults(self) -> list[str]:
        """Returns the faults of a solved plan."""
        X_WO = self.task.problem.X_WO
        what = "object_poses: the object does not stand where the task says"
        return super()._faults() + [
            f"{segment.name}: row {row}: {what}"
            for segment in self.segments
            for row, X in enumerate(segment.object_poses)
            if not np.abs(X - X_WO).max() <= 1e-9
        ]


def plan(problem: Problem, options: Options | None = None, budget: Budget | None = None) -> Plan:
    """Plans a motion of arm and hand that ends in a clasp: reach, then close until contact.

    Algorithms 1 to 4 of Stork, Pokorny and Kragic 2013.

    Not finding a plan is a status. Other Python threads run meanwhile; Ctrl-C raises
    KeyboardInterrupt, budget.stop() returns the best so far.

    Parameters
    ----------
    problem : Problem
        Robot, hand and object.
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
    problem: Problem | Plan,
    q: ArrayLike,
    X_WO: ArrayLike,
    *,
    options: Options | None = None,
    budget: Budget | None = None,
) -> Plan:
    """Plans a clasp anew while the hand is on its way, before it has closed.

    The task of the new plan is that of the old one with another start: the hand at `q`, the object
    at `X_WO`. Any loop and target that the problem allows may be clasped. The hand opens first if
    it can.

    Parameters
    ----------
    problem : Problem or Plan
        The problem; or the plan that was interrupted, whose problem, options and budget are taken.
    q : (dof,) array
        Joints of arm and hand [rad or m].
    X_WO : (4, 4) array
        Measured pose of the object in the world.
    options : Options, optional
        Settings of the search; by default those of the plan, or `Options()`.
    budget : planning.Budget, optional
        Time and randomness; by default that of the plan, or 10 s.

    Returns
    -------
    Plan
        False unless solved. Its status is start_in_collision if the hand touches something.

    Raises
    ------
    ValueError
        A bad problem or options; `q` of the wrong size or outside the joint limits; a pose that is
        not rigid.
    """
    require_type("problem", problem, Problem, Plan)
    if isinstance(problem, Plan):
        options, budget = problem._settings(options, budget)
        problem = problem.task.problem
    now = Problem(
        problem.robot,
        problem.hand,
        problem.object,
        X_WO,
        q,
        problem.obstacles,
        problem.loops,
        problem.marks,
        problem.pull_W,
    )
    return plan(now, options, budget)


__all__ = [
    "Certificate",
    "CertificateOptions",
    "CurveNode",
    "Finger",
    "Hand",
    "Hang",
    "Object",
    "Obstacle",
    "Options",
    "Pinch",
    "Plan",
    "Problem",
    "Segment",
    "Stability",
    "StabilityOptions",
    "Statistics",
    "Status",
    "Tree",
    "certificate",
    "certify",
    "check",
    "find_hang",
    "hand_from_yaml",
    "hand_from_yaml_file",
    "plan",
    "resume",
    "sample_object",
    "sample_object_names",
    "test_pinch",
    "test_stability",
    "validate",
    "with_palm_corners",
]


def __dir__() -> list[str]:
    return __all__
