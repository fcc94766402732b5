# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pools of workers: processes of this machine (joblib's loky), or a Dask cluster."""

from __future__ import annotations

import asyncio
import contextlib
import os
import re
import signal
import threading
import time
from concurrent.futures import Future
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from ..errors import TaskError, missing

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

Given = TypeVar("Given")
Result = TypeVar("Result")
Crashes = tuple[type[BaseException], ...]

ORPHAN_SECONDS = 0.1  # between looks whether the parent of a worker is alive
CONNECT_SECONDS = 10.0  # to a Dask scheduler, and until it has a worker
GONE = "dask: {}; what is done is kept, and the same call goes on"
ADDRESS = r"(\w+://)?(\[[\da-fA-F:.]+\]|[^/\s:\[\]]+):\d+"
ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")


class Pool(Protocol):
    """Workers that may die."""

    capacity: int
    """Number of jobs that keeps all workers busy."""

    workers: int
    """Number of workers."""

    is_elsewhere: bool
    """True if workers may be unable to read local files."""

    crashes: Crashes
    """Exceptions that a future raises after its worker has died."""

    def submit(self, work: Callable[[Given], Result], given: Given) -> Future[Result]:
        """Submits items to a worker; `work` must be importable there."""

    def look(self) -> None:
        """Raises TaskError if no result can arrive any more; called now and then while waiting."""

    def restart(self) -> None:
        """Restarts the workers after a crash, which may have lost all jobs."""

    def close(self, at_once: bool = False) -> None:
        """Ends the workers; with `at_once` whatever they are doing."""


class Processes:
    """Worker processes on this machine, with one thread each; even a single job gets a process."""

    is_elsewhere = False

    def __init__(self, jobs: int) -> None:
        try:
            from joblib.externals.loky import process_executor
        except ImportError as error:
            raise missing(error, "batch") from None
        self.workers = jobs
        self.capacity = 2 * jobs
        self.crashes: Crashes = (process_executor.BrokenProcessPool,)
        self._make: Any = process_executor.ProcessPoolExecutor
        self._start()

    def submit(self, work: Callable[[Given], Result], given: Given) -> Future[Result]:
        with _shielded():  # this may start a worker
            future: Future[Result] = self._executor.submit(work, given)
        return future

    def look(self) -> None:  # what breaks, breaks its futures
        pass

    def restart(self) -> None:
        self.close(at_once=True)
        self._start()

    def _start(self) -> None:
        self._executor = self._make(
            self.workers, env=ONE_THREAD, initializer=_end_without, initargs=(os.getpid(),)
        )

    def close(self, at_once: bool = False) -> None:
        with _without_last_words():
            self._executor.shutdown(wait=True, kill_workers=at_once)


class Cluster:
    """Workers of a Dask scheduler, as many as there are at the start."""

    is_elsewhere = True
    lonely_seconds = 60.0  # without a worker, until it is given up

    def __init__(self, address: str, seconds: float = CONNECT_SECONDS) -> None:
        try:
            import distributed
            from distributed.scheduler import KilledWorker
        except ImportError as error:
            raise missing(error, "cluster") from None
        self.crashes: Crashes = (KilledWorker,)
        if not re.fullmatch(ADDRESS, str(address)):
            raise TaskError(f"dask: {address}: should be an address like tcp://host:8786")
        make: Any = distributed.Client
        others = (ValueError, TypeError, MemoryError)  # of what else answers there
        try:
            self._client = make(address, timeout=seconds, set_as_default=False)
        except (OSError, asyncio.TimeoutError, *others) as error:
            reason = str(error) or type(error).__name__
            raise TaskError(f"dask: {address}: no scheduler there: {reason}") from None
        try:
            self._meet(address, seconds)
        except BaseException:
            self._client.close()
            raise
        self._executor = self._client.get_executor(pure=False)
        self._seen = time.monotonic()  # when there was a worker

    def _meet(self, address: str, seconds: float) -> None:
        try:
            self._client.wait_for_workers(1, timeout=seconds)
        except (TimeoutError, asyncio.TimeoutError):  # two, until Python 3.11
            raise TaskError(f"dask: {address}: no worker within {seconds:g} s") from None
        threads = self._client.nthreads()
        for worker, count in threads.items():
            if count != 1:  # warnings and patience are of the whole process
                raise TaskError(f"dask: {worker}: should have 1 thread (--nthreads 1), has {count}")
        self.workers = len(threads)
        self.capacity = 2 * self.workers
        for worker, found in self._client.run(_version, on_error="return").items():
            if found != (ours := _version()):
                has = f"graspless {found}" if isinstance(found, str) else f"none: {found}"
                raise TaskError(f"dask: {worker}: should have graspless {ours}, has {has}")

    def submit(self, work: Callable[[Given], Result], given: Given) -> Future[Result]:
        future: Future[Result] = self._executor.submit(work, given)
        return future

    def look(self) -> None:
        try:
            threads = self._client.nthreads()
        except (OSError, asyncio.TimeoutError):
            raise TaskError(GONE.format("the scheduler has gone")) from None
        now = time.monotonic()
        if threads:
            self._seen = now
        elif now - self._seen > self.lonely_seconds:
            what = f"no workers for {now - self._seen:.0f} s"
            raise TaskError(GONE.format(what))

    def restart(self) -> None:  # nannies do
        pass

    def close(self, at_once: bool = False) -> None:
        self._executor.shutdown(wait=not at_once)
        self._client.close(timeout=2)


def _end_without(parent: int) -> None:
    """Makes this worker end soon after its parent: a killed one cannot tell it to."""

    def watch() -> None:
        while os.getppid() == parent:
            time.sleep(ORPHAN_SECONDS)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


def _version() -> str:
    from .. import __version__

    return __version__


@contextlib.contextmanager
def opened(jobs: int, dask: str | None) -> Iterator[Pool]:
    """Opens a pool for a block; it ends with the block, at once if that raises."""
    pool: Pool = Processes(jobs) if dask is None else Cluster(dask)
    try:
        yield pool
    except BaseException:
        pool.close(at_once=True)
        raise
    pool.close()


@contextlib.contextmanager
def _without_last_words() -> Iterator[None]:
    """Keeps loky's own thread from dying of a lookup after its pending jobs were dropped."""
    before: Any = threading.excepthook

    def told(thrown: Any) -> None:
        if not (thrown.exc_type is KeyError and "Executor" in getattr(thrown.thread, "name", "")):
            before(thrown)

    threading.excepthook = told
    try:
        yield
    finally:
        threading.excepthook = before


@contextlib.contextmanager
def _shielded() -> Iterator[None]:
    """Makes processes that are started in the block ignore Ctrl-C; this process handles it."""
    before: Any = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
