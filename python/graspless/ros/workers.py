# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Processes that plan: one for each job, which ends when the job is done or cancelled."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import threading
from multiprocessing.connection import wait
from typing import TYPE_CHECKING, Any

from . import jobs, work

if TYPE_CHECKING:
    from collections.abc import Callable
    from multiprocessing.connection import Connection

_ENOUGH = 1.0  # for a process that was killed to be gone [s]


class Alarm:
    """An event that a thread can wait for together with a process."""

    def __init__(self) -> None:
        self._read, self._write = os.pipe()
        self._lock = threading.Lock()
        self._event = threading.Event()

    def __del__(self) -> None:
        for end in (self._read, self._write):
            with contextlib.suppress(OSError):
                os.close(end)

    def ring(self) -> None:
        """Rings, from any thread, once and for all."""
        with self._lock:
            if not self._event.is_set():
                self._event.set()
                os.write(self._write, b"!")

    @property
    def has_rung(self) -> bool:
        """True after `ring`."""
        return self._event.is_set()

    def wait(self, seconds: float) -> bool:
        """Waits until it rings; returns False if it did not in time."""
        return self._event.wait(seconds)

    def fileno(self) -> int:
        """File descriptor that is readable after `ring`."""
        return self._read


class Workers:
    """Starts processes from one that has imported all that they need, which takes milliseconds.

    Every start also polls the processes before it, and no process may be polled by two threads: the
    second would read its exit code from a file descriptor that may have been closed and opened
    anew, such as that of an Alarm, and wait there forever. So whatever polls holds the lock.
    """

    def __init__(self) -> None:
        self._context = multiprocessing.get_context("forkserver")
        self._context.set_forkserver_preload(["graspless.ros.preload"])
        self._lock = threading.Lock()

    def warm_up(self) -> None:
        """Lets the first job find everything imported."""
        self.run(jobs.CheckJob(""), Alarm(), lambda _: None)

    def run(self, job: Any, cancel: Alarm, tell: Callable[[str], object]) -> jobs.Found | None:
        """Does a job in a process of its own, which is killed when `cancel` rings.

        Parameters
        ----------
        job : jobs.TaskJob, jobs.PickJob or jobs.CheckJob
        cancel : Alarm
        tell : callable
            Called with the name of each phase.

        Returns
        -------
        jobs.Found or None
            None if it was cancelled. A process that dies is a status, too.
        """
        ours, theirs = self._context.Pipe(duplex=False)
        process = self._context.Process(target=work.main, args=(theirs, job), daemon=True)
        with ours:
            with theirs, self._lock:
                process.start()
            try:
                return _heard(ours, cancel, tell)
            except (EOFError, OSError):  # at the end of a message, in the middle of one
                how = f"exit code {self._exit_code(process)}"
                return jobs.Found("crashed", f"the planner died ({how}); the node goes on")
            finally:
                with self._lock:
                    process.kill()
                threading.Thread(target=self._reap, args=(process,), daemon=True).start()

    def _exit_code(self, process: Any) -> int | None:
        wait([process.sentinel], _ENOUGH)
        with self._lock:
            code: int | None = process.exitcode
            return code

    def _reap(self, process: Any) -> None:
        """Waits for a process that was killed: it takes a while to free its memory."""
        wait([process.sentinel], _ENOUGH)
        with self._lock, contextlib.suppress(ValueError):  # it is not gone yet
            process.close()


def _heard(ours: Connection, cancel: Alarm, tell: Callable[[str], object]) -> jobs.Found | None:
    """Returns what a process has found; None if it was cancelled before."""
    while not cancel.has_rung:
        if ours not in wait([ours, cancel.fileno()]):
            break
        received = ours.recv()
        if isinstance(received, jobs.Found):
            return received
        tell(received)
    return None
