# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pinch an object where it stands: two opposite faces of its outline between the fingers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Literal

from . import slide
from ._any_plan import AnyPlan
from ._core import pinch as _core
from ._core.pinch import Options, Segment, Statistics, Status, certify, check, validate
from .collision import Obstacle
from .slide import Hand, Object, Support

if TYPE_CHECKING:
    from . import tasks
    from .frames import Matrix
    from .planning import Budget

    Task = tasks.Task["Problem", Options, "Plan"]


class Problem(slide.Problem):
    """The same task as that of a slide, but the object is grasped where it stands."""


class Plan(AnyPlan, _core.Plan):
    """A pinch, or the reason why there is none. False unless solved."""

    kind: ClassVar[Literal["pinch"]] = "pinch"
    _planner: ClassVar[Any] = _core

    if TYPE_CHECKING:

        @property
        def task(self) -> Task: ...

    @property
    def q_start(self) -> Matrix:
        """(dof,) configuration at which the plan begins [rad or m]."""
        q: Matrix = self.task.problem.q_home
        return q

    @property
    def X_WO_start(self) -> Matrix:
        """(4, 4) pose of the object, which does not move."""
        X_WO: Matrix = self.task.problem.X_WO_start
        return X_WO

    @property
    def X_WO_goal(self) -> Matrix:
        """(4, 4) pose of the object when the hand has closed: that at the start."""
        return self.X_WO_start


def plan(problem: Problem, options: Options | None = None, budget: Budget | None = None) -> Plan:
    """Plans approach, grasp and close.

    The object counts as a prism over its outline, or is as high as its heights. The fingers close
    along the support on two opposite faces, of the outline or of a wall of the heights; the hand
    comes from above or from a side. Among all hand poses, those that need the least friction and
    are nearest to the centre of mass are tried first.

    Not finding a plan is a status. Other Python threads run meanwhile; Ctrl-C raises
    KeyboardInterrupt, budget.stop() returns the best so far.

    Parameters
    ----------
    problem : Problem
        Robot, hand, object and support.
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


__all__ = [
    "Hand",
    "Object",
    "Obstacle",
    "Options",
    "Plan",
    "Problem",
    "Segment",
    "Statistics",
    "Status",
    "Support",
    "certify",
    "check",
    "plan",
    "validate",
]


def __dir__() -> list[str]:
    return __all__
