# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Distribution of work to a pool whose workers may die; every item gets a result."""

from __future__ import annotations

import time
from concurrent.futures import ALL_COMPLETED, FIRST_COMPLETED, wait
from functools import partial
from itertools import chain, islice
from typing import TYPE_CHECKING, Generic, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Iterable, Iterator
    from concurrent.futures import Future

    from .pools import Pool

Given = TypeVar("Given")
Result = TypeVar("Result")

CHUNK_SECONDS = 0.1  # of work sent at once: short work is not to wait for its messages
LARGEST_CHUNK = 16
LOOK_SECONDS = 5.0  # between looks whether there are workers at all


def spread(
    work: Callable[[Given], Result],
    items: Iterable[Given],
    pool: Pool,
    lost: Callable[[Given, str, float], Result],
) -> Iterator[Result]:
    """Results as they come.

    A worker that dies takes others' jobs with it. All that it may have held are done again, one
    at a time when nothing else is left: who then dies alone is the culprit.

    Parameters
    ----------
    work : function
        Importable in a worker.
    items : iterable
        What it is given, one after the other.
    pool : Pool
        Where it is done.
    lost : function
        The result of an item whose worker died: given the item, what is known, and after how
        long [s].
    """
    together = _Together(work, pool, iter(items))
    while together.fill():
        yield from together.results()
    for item in together.suspects:
        start = time.monotonic()
        try:
            future = pool.submit(work, item)
            _wait([future], pool, FIRST_COMPLETED)
            result = future.result()
        except pool.crashes as error:
            pool.restart()
            result = lost(item, str(error), time.monotonic() - start)
        yield result


class _Together(Generic[Given, Result]):
    """Jobs in flight: enough to keep all workers busy, short ones in chunks."""

    def __init__(self, work: Callable[[Given], Result], pool: Pool, items: Iterator[Given]) -> None:
        self._work, self._pool, self._items = partial(_each, work), pool, items
        self._running: dict[Future[tuple[list[Result], float]], list[Given]] = {}
        self._chunk = 1
        self._is_broken = False
        self.suspects: list[Given] = []

    def fill(self) -> bool:
        """Submits as many items as there is room for; returns False when all are done."""
        while len(self._running) < self._pool.capacity and not self._is_broken:
            items = list(islice(self._items, self._chunk))
            if not items:
                break
            self._submit(items)
        return bool(self._running) or self._is_broken

    def results(self) -> Iterator[Result]:
        """Waits for some results; after a crash for all, before workers are restarted."""
        when = ALL_COMPLETED if self._is_broken else FIRST_COMPLETED
        for future in _wait(self._running, self._pool, when):
            items = self._running.pop(future)
            try:
                results, seconds = future.result()
            except self._pool.crashes:
                self.suspects += items
                self._is_broken = True
                continue
            fitting = int(CHUNK_SECONDS * len(items) / max(seconds, 1e-6))
            self._chunk = min(max(fitting, 1), LARGEST_CHUNK)
            yield from results
        if self._is_broken and not self._running:
            self._pool.restart()
            self._is_broken = False

    def _submit(self, items: list[Given]) -> None:
        try:
            self._running[self._pool.submit(self._work, items)] = items
        except self._pool.crashes:  # it broke since; nobody has begun these
            self._items = chain(items, self._items)
            self._is_broken = True


def _wait(futures: Collection[Future[Result]], pool: Pool, when: str) -> set[Future[Result]]:
    """Returns the finished futures; raises the error of a pool that cannot continue."""
    while True:
        done, left = wait(futures, LOOK_SECONDS, when)
        if not left or (done and when == FIRST_COMPLETED):
            return done
        pool.look()


def _each(work: Callable[[Given], Result], items: list[Given]) -> tuple[list[Result], float]:
    """Returns results, and the time that they took [s]; runs in the worker."""
    start = time.perf_counter()
    return [work(item) for item in items], time.perf_counter() - start
