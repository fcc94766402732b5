# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slide a thin object to the edge of its support and grasp it there (Hang, Morgan, Dollar 2019)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Literal

from ._any_plan import AnyPlan
from ._arguments import require_type
from ._core import slide as _core
from ._core.slide import (
    FingerModel,
    Hand,
    Interruption,
    Object,
    Options,
    Problem,
    Search,
    Segment,
    Statistics,
    Status,
    Support,
    Surroundings,
    Tube,
    Turning,
    center_of_mass,
    certify,
    check,
    depth_band,
    tube,
    turning,
    validate,
)
from .collision import Obstacle
from .planning import Budget

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from . import tasks
    from .frames import Matrix

    Task = tasks.Task[Problem, Options, "Plan"]


class Plan(AnyPlan, _core.Plan):
    """A slide and a grasp, or why not. False unless solved."""

    kind: ClassVar[Literal["slide"]] = "slide"
    _planner: ClassVar[Any] = _core

    if TYPE_CHECKING:

        @property
        def task(self) -> Task: ...

    @property
    def q_start(self) -> Matrix:
        """(dof,) configuration at which the plan begins, or where it was resumed [rad or m]."""
        at = self.resumed
        q: Matrix = self.task.problem.q_home if at is None else at.q
        return q

    @property
    def X_WO_start(self) -> Matrix:
        """(4, 4) pose of the object where the plan begins; measured, where it was resumed."""
        at = self.resumed
        X_WO: Matrix = self.task.problem.X_WO_start if at is None else at.X_WO
        return X_WO


def plan(problem: Problem, options: Options | None = None, budget: Budget | None = None) -> Plan:
    """Plans approach, press, slide, lift, reach, grasp and close.

    Algorithm 1 of Hang, Morgan and Dollar 2019 (Options.search: paper), or the same with goals
    drawn to fit a start.

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


def resume(
    problem: Problem | Plan,
    q: ArrayLike,
    X_WO: ArrayLike,
    *,
    X_WO_goal: ArrayLike | None = None,
    options: Options | None = None,
    budget: Budget | None = None,
) -> Plan:
    """Plans the rest of an interrupted slide, without lifting the finger off the object.

    The plan has the segments slide, lift, reach, grasp and close. Its `resumed` is the state given
    here, and `check` replays it from there.

    The object is taken to lie flat on the support, with the yaw and the centre of mass of `X_WO`.
    The plan begins at the configuration nearest to `q` that presses: at `q` itself if that is a
    command of a plan, and at most 0.05 rad away from measured joints.

    A state from which no slide can go on is a status with a reason, never an exception:

    - off_support: the object is more than 20 mm or 10 degrees off the plane of the support.
    - contact_lost: the fingertip is above the object, beside it, nearer to its outline than
      options.rim_margin or to the support's edge than options.tip_margin, or where its heights
      are not level; or q is too far from all configurations that press.
    - start_in_collision: something touches that should not.

    Parameters
    ----------
    problem : Problem or Plan
        The problem; or the plan that was interrupted, whose problem, options and budget are taken.
    q : (dof,) array
        Commanded joints [rad or m].
    X_WO : (4, 4) array
        Measured pose of the object in the world.
    X_WO_goal : (4, 4) array, optional
        Pose of the object in the world that is tried first as the goal, before other poses over
        the same edge and those over other edges. By default, the goal of the interrupted plan.
    options : Options, optional
        Settings of the search; by default those of the plan, or `Options()`.
    budget : planning.Budget, optional
        Time and randomness; by default that of the plan, or 10 s. In a loop, a few tens of
        milliseconds.

    Returns
    -------
    Plan
        False unless solved.

    Raises
    ------
    ValueError
        A bad problem or options; `q` of the wrong size or with a value that is not finite; a pose
        that is not rigid.
    """
    task, former = _interrupted(problem, options, budget)
    at = Interruption(q, X_WO, former if X_WO_goal is None else X_WO_goal)
    return Plan._of(_core.resume(task.problem, at, task.options, task.budget), task)


def restart(
    problem: Problem | Plan,
    q: ArrayLike,
    X_WO: ArrayLike,
    *,
    options: Options | None = None,
    budget: Budget | None = None,
) -> Plan:
    """Plans an interrupted slide anew: lifts the finger off, and begins again.

    For a contact that was lost, or from which `resume` finds no way. The plan has the segments
    retreat, approach, press, slide, lift, reach, grasp and close. While the finger retreats, the
    contact does not move; a finger that is beside the object goes straight up.

    A state from which no slide can begin is a status with a reason, never an exception: those of
    `plan`, and

    - off_support: as in `resume`; or the centre of mass is beyond the support's edge, and the
      object would fall without the finger.
    - contact_lost: the hand is not open, or the fingertip is deeper than its band.
    - start_in_collision: the finger cannot be lifted off.

    Parameters
    ----------
    problem : Problem or Plan
        The problem; or the plan that was interrupted, whose problem, options and budget are taken.
    q : (dof,) array
        Commanded joints [rad or m].
    X_WO : (4, 4) array
        Measured pose of the object in the world.
    options : Options, optional
        Settings of the search; by default those of the plan, or `Options()`.
    budget : planning.Budget, optional
        Time and randomness; by default that of the plan, or 10 s.

    Returns
    -------
    Plan
        False unless solved.

    Raises
    ------
    ValueError
        As `resume`.
    """
    task, _ = _interrupted(problem, options, budget)
    at = Interruption(q, X_WO)
    return Plan._of(_core.restart(task.problem, at, task.options, task.budget), task)


def _interrupted(
    problem: Problem | Plan, options: Options | None, budget: Budget | None
) -> tuple[Task, Matrix | None]:
    """Returns the task to go on with, and the goal of a plan for it."""
    from .tasks import Task

    require_type("problem", problem, Problem, Plan)
    if options is not None:
        require_type("options", options, Options)
    if budget is not None:
        require_type("budget", budget, Budget)
    if not isinstance(problem, Plan):
        return Task.of(problem, options, budget), None
    task, goal = problem.task, problem.X_WO_goal if problem else None
    if options is None and budget is None:
        return task, goal
    return Task.of(task.problem, *problem._settings(options, budget)), goal


__all__ = [
    "FingerModel",
    "Hand",
    "Interruption",
    "Object",
    "Obstacle",
    "Options",
    "Plan",
    "Problem",
    "Search",
    "Segment",
    "Statistics",
    "Status",
    "Support",
    "Surroundings",
    "Tube",
    "Turning",
    "center_of_mass",
    "certify",
    "check",
    "depth_band",
    "plan",
    "restart",
    "resume",
    "tube",
    "turning",
    "validate",
]


def __dir__() -> list[str]:
    return __all__
