# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Carry a held object along a straight path: lift it, drag it over a surface, or put it down."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Literal

from ._any_plan import AnyPlan
from ._core import carry as _core
from ._core.carry import (
    Options,
    Places,
    Problem,
    Segment,
    Statistics,
    Status,
    certify,
    check,
    validate,
)
from .collision import Obstacle

if TYPE_CHECKING:
    from . import tasks
    from .planning import Budget

    Task = tasks.Task[Problem, Options, "Plan"]


class Plan(AnyPlan, _core.Plan):
    """Motion of a held object, or the reason why there is none. False unless solved."""

    kind: ClassVar[Literal["carry"]] = "carry"
    _planner: ClassVar[Any] = _core

    if TYPE_CHECKING:

        @property
        def task(self) -> Task: ...


def plan(problem: Problem, options: Options | None = None, budget: Budget | None = None) -> Plan:
    """Plans a motion of the arm with the held object.

    The object moves along a straight line to its goal, or is put down at the first of its places
    that works.

    Not finding a plan is a status. Other Python threads run meanwhile; Ctrl-C raises
    KeyboardInterrupt, budget.stop() returns the best so far.

    Parameters
    ----------
    problem : Problem
        Robot, held object, and its goal or places.
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
    "Obstacle",
    "Options",
    "Places",
    "Plan",
    "Problem",
    "Segment",
    "Statistics",
    "Status",
    "certify",
    "check",
    "plan",
    "validate",
]


def __dir__() -> list[str]:
    return __all__
