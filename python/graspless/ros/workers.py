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
    """Starts processes from one that has imported all that they need, which takes milliseconds."""

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
        try:
            with self._lock:  # the server of forks answers one request at a time
                process.start()
            theirs.close()
            while not cancel.has_rung:
                if ours not in wait([ours, cancel.fileno()]):
                    break
                received = ours.recv()
                if isinstance(received, jobs.Found):
                    return received
                tell(received)
            return None
        except EOFError:
            process.join(_ENOUGH)
            how = f"exit code {process.exitcode}"
            return jobs.Found("crashed", f"the planner died ({how}); the node goes on")
        finally:
            ours.close()
            process.kill()
            threading.Thread(target=_reap, args=(process,), daemon=True).start()


def _reap(process: Any) -> None:
    """Waits for the end of a process that was killed, which takes a while to free its memory."""
    process.join(_ENOUGH)
    with contextlib.suppress(ValueError):  # it is not gone yet
        process.close()
