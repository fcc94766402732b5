# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trials of a plan until they are done, too many have failed, or time is over."""

from __future__ import annotations

import contextlib
import time
from concurrent import futures
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import islice, takewhile
from typing import TYPE_CHECKING, Any

from .. import limits
from .._core import planning
from ..errors import TaskError, explain

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from .._plan import Plan
    from ..batches.pools import Processes
    from ..simulation import Variation

    Execute = Callable[[Plan, "Trials", float], None]


class TrialError(Exception):
    """An error of a trial, in one line; also from another process."""


@dataclass
class Trials:
    """Trials of a plan.

    Attributes
    ----------
    variations : sequence of Variation
        One per trial.
    most : int
        Number of failed trials that end the work: a plan with as many is not the best.
    failures : dict
        Names of the failures of each finished trial, by its index.
    ended : str
        Reason why trials are missing, one of `proof.ENDS`; empty if all were done, or enough.
    error : str
        Error of the trial that ended the work.
    """

    variations: Sequence[Variation]
    most: int
    failures: dict[int, list[str]] = field(default_factory=dict)
    ended: str = ""
    error: str = ""

    @property
    def failed(self) -> int:
        """Number of trials that failed."""
        return sum(map(bool, self.failures.values()))

    @property
    def in_order(self) -> list[list[str]]:
        """Failures of the first trials, up to one that was not done."""
        ordered = (self.failures.get(k) for k in range(len(self.variations)))
        return list(takewhile(lambda failed: failed is not None, ordered))  # type: ignore[arg-type]

    def take(self, results: Iterable[tuple[int, list[str]]]) -> None:
        """Takes results until `most` trials have failed. Ctrl-C, a time limit and errors end it."""
        try:
            for k, failed in results:
                self.failures[k] = failed
                if self.failed >= self.most:
                    break
        except planning.OutOfTime:
            self.ended = "out_of_time"
        except KeyboardInterrupt:
            self.ended = "interrupted"
        except TrialError as error:
            self.ended, self.error = "error", str(error)


@contextlib.contextmanager
def executor(jobs: int) -> Iterator[Execute]:
    """Opens a function of a plan, its trials and a deadline, by time.monotonic, that does them.

    Parameters
    ----------
    jobs : int
        Number of worker processes. A single job needs none.

    Raises
    ------
    TaskError
        joblib is missing, or a process died.
    """
    if jobs == 1:
        yield _here
        return
    from ..batches.pools import Processes

    pool, ends = Processes(jobs), {""}
    at_once = True

    def execute(plan: Plan, trials: Trials, deadline: float) -> None:
        _spread(pool, plan, trials, deadline)
        ends.add(trials.ended)

    try:
        yield execute
        at_once = "interrupted" in ends
    finally:
        pool.close(at_once)


def _here(plan: Plan, trials: Trials, deadline: float) -> None:
    trials.take(
        (k, _within(deadline - time.monotonic(), plan, variation))
        for k, variation in enumerate(trials.variations)
    )


def _spread(pool: Processes, plan: Plan, trials: Trials, deadline: float) -> None:
    try:
        trials.take(_results(pool, plan.to_json(), trials.variations, deadline))
    except pool.crashes as error:
        raise TaskError(f"the process of a trial died: {error}") from None


def _results(
    pool: Processes, text: str, variations: Sequence[Variation], deadline: float
) -> Iterator[tuple[int, list[str]]]:
    """Yields trials as they come, one a worker at a time."""
    waiting = enumerate(variations)
    running: dict[futures.Future[list[str] | None], int] = {}
    while True:
        left = deadline - time.monotonic()
        for k, variation in islice(waiting, pool.workers - len(running)):
            running[pool.submit(_work, (time.time() + left, text, variation))] = k
        if not running:
            return
        done, _ = futures.wait(running, min(limits.LONGEST, left), futures.FIRST_COMPLETED)
        if not done:
            raise planning.OutOfTime
        for future in done:
            k, failed = running.pop(future), future.result()
            if failed is None:
                raise planning.OutOfTime
            yield k, failed


def _work(given: tuple[float, str, Variation]) -> list[str] | None:
    """Executes one trial in a worker. None means that time was over."""
    until, text, variation = given  # by the clock that all processes share
    try:
        return _within(until - time.time(), _read(text), variation)
    except planning.OutOfTime:
        return None


def _within(left: float, plan: Any, variation: Variation) -> list[str]:
    """Returns the failures of a trial, which has `left` seconds.

    Raises TrialError for any error of the engine.
    """
    from ..simulation import simulation_kind

    kind = simulation_kind(plan.kind)
    with limits.within(left):
        try:
            return list(kind.run(plan, variation).failures)
        except Exception as error:  # whatever MuJoCo raises: the plan was found in spite of it
            raise TrialError(explain(error)) from error


@lru_cache(maxsize=1)
def _read(text: str) -> Plan:
    from ..plan_files import read_plan

    return read_plan(text, "simulated plan")
