# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs trials one after the other, and checks every plan."""

from __future__ import annotations

import dataclasses
import itertools
import math
import time
from typing import TYPE_CHECKING

from graspless import slide
from graspless._core import slide as core  # the file's numbers are not wanted

from .. import _peers, memory
from ..bar import collected
from . import sscbirrt
from .grid import SSC_PEERS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from graspless.planning import Budget

    from .grid import Trial

BATCH = 20  # queries before their plans are checked: neither disturbs the other's caches much


@dataclasses.dataclass
class Outcome:
    """Outcome of a trial."""

    trial: Trial
    status: str
    seconds: float  # wall clock [s]; inf unless solved
    cpu_seconds: float  # of this process meanwhile [s]; inf unless solved
    peak_bytes: int  # highest resident memory of the process during the query
    faults: list[str] = dataclasses.field(default_factory=list)  # of check()

    @property
    def is_violation(self) -> bool:
        return bool(self.faults)


@dataclasses.dataclass
class Run:
    """All outcomes of a command."""

    outcomes: list[Outcome] = dataclasses.field(default_factory=list)
    baseline_bytes: int = 0  # resident memory before the first query
    is_complete: bool = False


@dataclasses.dataclass
class _Pending:
    outcome: Outcome
    problem: slide.Problem
    plan: core.Plan | None


def run(
    trials: Iterable[Trial],
    seconds: float,
    tell: Callable[[int, str], None] = lambda done, label: None,
) -> Run:
    """Times each trial, in batches, and checks the plans of a batch after it.

    Parameters
    ----------
    trials : iterable of Trial
    seconds : float
        For each [s].
    tell : function
        Called with the number of trials that are done, and the label of the last.

    Returns
    -------
    Run
        Results up to Ctrl-C.
    """
    result = Run()
    result.outcomes, result.is_complete = collected(_outcomes(trials, seconds, tell, result))
    return result


def _outcomes(
    trials: Iterable[Trial], seconds: float, tell: Callable[[int, str], None], result: Run
) -> Iterator[Outcome]:
    numbered = enumerate(trials, 1)
    while batch := list(itertools.islice(numbered, BATCH)):
        pending = []
        for done, trial in batch:
            pending.append(_query(trial, seconds, result))
            tell(done, trial.label)
        for item in pending:
            _check(item)
            yield item.outcome


def _query(trial: Trial, seconds: float, result: Run) -> _Pending:
    problem, options, budget = (
        trial.make_problem(),
        trial.make_options(),
        trial.make_budget(seconds),
    )
    ask = _prepare(trial, problem, options)
    memory.reset_peak()
    if not result.baseline_bytes:
        result.baseline_bytes = memory.resident_bytes()
    cpu, start = time.process_time(), time.perf_counter()
    plan, own_seconds = ask(budget)
    elapsed, cpu = time.perf_counter() - start, time.process_time() - cpu
    if own_seconds is not None:  # a peer: what prepares and completes its path is not its own
        elapsed = own_seconds
    if not plan:
        elapsed = cpu = math.inf
    status = plan.status.name if plan is not None else "no_pair"
    return _Pending(Outcome(trial, status, elapsed, cpu, memory.peak_bytes()), problem, plan)


def _prepare(
    trial: Trial, problem: slide.Problem, options: slide.Options
) -> Callable[[Budget], tuple[core.Plan | None, float | None]]:
    """Returns the function that answers a trial: (plan, its seconds unless those of the call)."""
    if trial.method in ("fast", "paper"):
        return lambda budget: (core.plan(problem, options, budget), None)
    draw = _peers.PairDraw[trial.pairs]
    pair = _peers.PairProblem(problem, options, draw, trial.start.draw_seed())
    if not pair.has_pair:
        return lambda budget: (None, None)
    if trial.method in SSC_PEERS:
        foreign = sscbirrt.Peer(pair, problem, is_native=trial.method == "sscbirrt_native")
        return foreign.run
    peer = _peers.Peer[trial.method]
    return lambda budget: pair.run(peer, budget)


def _check(item: _Pending) -> None:
    if not item.plan:
        return
    outcome = item.outcome
    outcome.faults = slide.check(item.problem, item.plan, outcome.trial.make_options())
    if outcome.faults:  # a plan that does not hold is none
        outcome.seconds = outcome.cpu_seconds = math.inf
