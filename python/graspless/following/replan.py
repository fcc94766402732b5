# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""New plans for a slide that is under way."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

import numpy as np

from .. import planning, slide

if TYPE_CHECKING:
    from collections.abc import Callable

    from ..frames import Matrix
    from ..slide import Plan
    from .guard import Guard
    from .hand import Hand
    from .settings import Settings


class Replanner:
    """Plans the same task again, with the object where it is.

    Attributes
    ----------
    is_searching : bool
        True if a search has not ended yet.
    seconds : dict of str to list of float
        Processor times of the searches so far, for the rest of a slide ("resume") and for a whole
        plan ("anew") [s].
    """

    def __init__(self, plan: Plan, hand: Hand, guard: Guard, settings: Settings) -> None:
        self._task = plan.task
        self._hand, self._guard, self._settings = hand, guard, settings
        self.seconds: dict[str, list[float]] = {"resume": [], "anew": []}
        self.forget()

    def forget(self) -> None:
        """Ends a search that has not found anything."""
        self._tries, self._spent = 0, 0.0
        self.is_searching = False

    def anew(self, q: Matrix, place: Matrix) -> tuple[Plan | None, str]:
        """Plans from q [dof], at rest and not in contact, with the object at a place [3]."""
        problem, options = self._problem(q, place), self._task.options

        def search(budget: planning.Budget) -> Plan:
            return slide.plan(problem, options, budget)

        return self._searched("anew", search, self._tries, self._settings.plan_seconds)

    def resume(self, plan: Plan, q: Matrix, place: Matrix) -> tuple[Plan | None, str]:
        """Plans the rest of a slide from q [dof], pressed, with the object at a place [3]."""
        X_WO, task = self._hand.pose(place), self._task

        def search(budget: planning.Budget) -> Plan:
            return slide.resume(
                task.problem,
                q,
                X_WO,
                X_WO_goal=plan.X_WO_goal,
                options=task.options,
                budget=budget,
            )

        most = self._settings.resume_seconds
        return self._searched("resume", search, self._tries // 4, most)

    def _searched(
        self, kind: str, search: Callable[[planning.Budget], Plan], doublings: int, most: float
    ) -> tuple[Plan | None, str]:
        """Searches once. Returns the plan, or None and the reason.

        `is_searching` is then True if the time ended without a plan and less than `most` [s] has
        been spent: the next call goes on, with another seed and from the state of then.
        """
        seconds = min(self._settings.search_seconds * 2**doublings, most - self._spent)
        budget = planning.Budget(seconds=seconds, seed=(self._task.seed + self._tries) % 2**64)
        began = time.thread_time()
        plan = search(budget)
        self.seconds[kind].append(time.thread_time() - began)
        self._tries += 1
        self._spent += seconds
        self.is_searching = not plan and plan.statistics.seconds >= seconds and self._spent < most
        if self.is_searching:
            return None, ""
        self.forget()
        return _found(plan)

    def retreat(self, q: Matrix, place: Matrix, lifts: bool) -> slide.Segment:
        """Returns the segment that lifts the hand off the object from q [dof], or stays there.

        It ends before the hand touches anything else.
        """
        path = self._hand.lifted(q, self._settings.lift) if lifts else np.array([q, q])
        path = self._guard.free_part("retreat", path, place)
        poses = np.repeat(self._hand.pose(place)[None], len(path), axis=0)
        return slide.Segment("retreat", path, poses)

    def _problem(self, q: Matrix, place: Matrix) -> slide.Problem:
        problem = self._task.problem
        return slide.Problem(
            problem.robot,
            problem.hand,
            problem.object,
            problem.support,
            self._hand.pose(place),
            q,
            problem.obstacles,
        )


def _found(plan: Plan) -> tuple[Plan | None, str]:
    if plan:
        return plan, str(plan.status)
    return None, f"{plan.status}: {plan.reason}"
