# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Search for a plan that holds in the physics engine."""

from __future__ import annotations

import itertools
import time
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from .._arguments import require_integer
from ..kinds import plan_type
from .proof import ENDS, Proof, digest_of
from .trials import Trials, executor

if TYPE_CHECKING:
    from .. import planning
    from .._plan import Plan
    from ..tasks import Task
    from .trials import Execute

SECONDS = 600.0  # limit of searches and trials together, unless one is given [s]
MOST_REPEATED = 10  # seeds in a row without a new plan that end the search
MORE_STABLE = (1.25, 1.1, 1.03)  # stability that the next fingertip plan must have, relative to
# the last; where there is no such plan, the next factor


def prove(
    task: Task[Any, Any, Any],
    varied: int,
    *,
    jobs: int = 1,
    seconds: float | None = None,
    began: float | None = None,
    budget: planning.Budget | None = None,
) -> Plan:
    """Plans a task, simulates the plan, and goes on with other seeds until one holds in all trials.

    Parameters
    ----------
    task : Task
    varied : int
        Number of varied trials; the nominal one comes first.
    jobs : int
        Number of processes that simulate.
    seconds : float, optional
        Limit of everything [s], `SECONDS` by default. A search has at most the task's own limit.
    began : float, optional
        Time from which the limit counts, by time.monotonic; now by default.
    budget : planning.Budget, optional
        Budget that another thread may stop().

    Returns
    -------
    Plan
        The first plan that holds in all trials, otherwise the one that held in the most. Its
        `proof` has the trials, and the error of the engine if one ended them. The first search's
        result, without proof, if that found no plan.

    Raises
    ------
    TaskError
        varied is not in 1 to 10000, jobs is not a whole number of at least 1, plans of this kind
        cannot be simulated, MuJoCo is not installed, or no task file can state the problem.
    """
    before = time.monotonic()
    from .. import simulation

    varied = require_integer("prove", varied, least=1, most=simulation.MOST_TRIALS)
    jobs = require_integer("jobs", jobs, least=1)
    kind = simulation.require_simulated(task)
    task.to_dict()  # raises where there is no such file
    spread = getattr(kind, "SPREAD", None) or simulation.Spread()
    variations = simulation.variations(varied + 1, task.seed, spread)
    imported = time.monotonic() - before  # which does not count
    deadline = (before if began is None else began) + imported + limit_of(seconds)
    with executor(jobs) as execute:
        search = _Search(task, variations, deadline, budget or task.budget, execute)
        search.run()
    found: Plan = search.result({n: width for n, width in asdict(spread).items() if width})
    return found


def limit_of(seconds: float | None) -> float:
    """Returns the limit of searches and trials together [s]."""
    return SECONDS if seconds is None else seconds


class _Search:
    """Plans and their trials."""

    def __init__(
        self,
        task: Task[Any, Any, Any],
        variations: list[Any],
        deadline: float,
        budget: planning.Budget,
        execute: Execute,
    ) -> None:
        self._task, self._variations, self._deadline = task, variations, deadline
        self._budget, self._execute = budget, execute
        self._candidates = _Candidates(task)
        self._best: Any = None  # a plan
        self._trials = Trials(variations, 0)  # of the best plan
        self._seen: set[str] = set()  # digests of the plans that were simulated
        self._ended = self._error = ""

    def run(self) -> None:
        """Searches and simulates until a plan holds, or no more are to come.

        Ctrl-C ends it once there is a plan.
        """
        repeated = 0
        try:
            while not self._ended and repeated < MOST_REPEATED:
                plan = self._next()
                if plan is None:
                    break
                digest = digest_of(plan) if plan else ""
                if self._best is None and not plan:
                    self._best, self._ended = plan, str(plan.status)
                elif not plan or digest in self._seen:
                    repeated += 1
                else:
                    repeated = 0
                    self._seen.add(digest)
                    self._try(plan)
                self._candidates.learn(plan)
        except KeyboardInterrupt:
            if self._best is None:
                raise
            self._ended = self._ended or "interrupted"
        self._ended = self._ended or "no_other_plan"

    def _next(self) -> Any:
        """Searches for the next plan, first as without trials. None means that the search ended."""
        left = self._deadline - time.monotonic()
        if self._best is not None and (left <= 0 or self._budget.is_stopped):
            self._ended = "interrupted" if self._budget.is_stopped else "out_of_time"
            return None
        task = self._candidates.task
        seconds = max(1e-9, min(left, task.budget.seconds))
        search = plan_type(task.kind)._search
        return search(task, self._budget.part(seconds=seconds, seed=task.seed))

    def _try(self, plan: Any) -> None:
        """Simulates a plan, and keeps it if it holds in more trials than the best one."""
        is_first, asked = self._best is None, len(self._variations)
        most = asked + 1 if is_first else self._trials.failed
        trials = Trials(self._variations, most)
        self._execute(plan, trials, self._deadline)
        self._ended, self._error = trials.ended, trials.error
        is_done = len(trials.failures) == asked
        if is_first or (is_done and trials.failed < most):
            self._best, self._trials = plan, trials
        if is_done and not trials.failed:
            self._ended = "proven"

    def result(self, widths: dict[str, float]) -> Any:
        """Returns the best plan with its proof."""
        from .. import __version__, simulation

        plan, failures = self._best, self._trials.in_order
        if plan:
            plan.proof = Proof(
                asked=len(self._variations),
                trials=len(failures),
                held=failures.count([]),
                failures=failures,
                varied=widths,
                trial_seed=self._task.seed,
                plan_seed=plan.seed,
                plans=len(self._seen),
                ended=self._ended,
                engine=simulation.engine(),
                version=__version__,
                digest=digest_of(plan),
                error=self._error,
            )
        return plan


class _Candidates:
    """Tasks of the next plans: with other seeds, and of fingertips with more stability.

    A fingertip search without a robot does not depend on the seed.
    """

    def __init__(self, task: Task[Any, Any, Any]) -> None:
        self._first = self.task = task
        self._seeds = itertools.count(task.seed + 1)
        self._factors = list(MORE_STABLE) if task.kind == "fingertip" else []
        self._least = 0.0  # stability of the last plan [N]

    def learn(self, plan: Any) -> None:
        """Makes the task that follows the one whose plan this is."""
        if self._factors and plan:
            self._least = min(float(min(segment.stability)) for segment in plan.segments)
        elif self._factors:
            self._factors.pop(0)
        task = self._first
        if self._factors:
            needed = max(self._factors[0] * self._least, task.options.min_stability)
            task = task.with_options(min_stability=needed, explain=False)
        self.task = task.with_changes(seed=next(self._seeds) % 2**64)


__all__ = ["ENDS", "MOST_REPEATED", "SECONDS", "Proof", "digest_of", "limit_of", "prove"]
