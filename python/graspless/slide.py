# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slide a thin object to the edge of its support and grasp it there (Hang, Morgan, Dollar 2019)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Literal

from ._core import slide as _core
from ._core.slide import (
    FingerModel,
    Hand,
    Object,
    Options,
    Problem,
    Search,
    Segment,
    Statistics,
    Status,
    Support,
    Turning,
    center_of_mass,
    check,
    depth_band,
    turning,
    validate,
)
from ._plan import AnyPlan
from .collision import Obstacle

if TYPE_CHECKING:
    from . import tasks
    from .planning import Budget

    Task = tasks.Task[Problem, Options, "Plan"]


class Plan(AnyPlan, _core.Plan):
    """A slide and a grasp, or why not. False unless solved."""

    kind: ClassVar[Literal["slide"]] = "slide"
    _planner: ClassVar[Any] = _core

    if TYPE_CHECKING:

        @property
        def task(self) -> Task: ...


def plan(problem: Problem, options: Options | None = None, budget: Budget | None = None) -> Plan:
    """Plans approach, press, slide, lift, reach, grasp and close.

    Algorithm 1 of Hang, Morgan and Dollar 2019 (Options.search: paper), or the same with goals
    drawn to fit a start.

    Not finding a plan is a status. Other Python threads run meanwhile; Ctrl-C raises
    KeyboardInterrupt, budget.stop() returns the best so far.

    Parameters
    ----------
    problem : Problem
    options : Options, optional
        Settings of the search.
    budget : planning.Budget, optional
        Time and randomness.

    Raises
    ------
    ValueError
        A bad problem or bad options; names the field, its value and what is allowed.
    """
    return Plan._planned(problem, options, budget)


__all__ = [
    "FingerModel",
    "Hand",
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
    "Turning",
    "center_of_mass",
    "check",
    "depth_band",
    "plan",
    "turning",
    "validate",
]


def __dir__() -> list[str]:
    return __all__
