# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time limit of a task: reading it counts as well as planning it; imports do not."""

from __future__ import annotations

import contextlib
import gc
import math
import signal
import threading
import time
from typing import TYPE_CHECKING, Any

from . import _commands
from ._core import planning
from .errors import OutOfTimeError

if TYPE_CHECKING:
    from collections.abc import Iterator

LONGEST = 1e8  # of a timer [s]

_left: list[BaseException] = []  # exceptions that keep trees alive until the process ends

# For loops in Python that may be long: raises where the time limit was reached.
poll = planning.poll


def _of_timer(seconds: float) -> float:
    return min(LONGEST, max(1e-6, seconds))


class Reading:
    """Clock of a thread that reads a task in order to plan it."""

    def __init__(self, has_alarm: bool, what: str) -> None:
        self.what = what
        self.began = time.monotonic()
        self.seconds: float | None = None  # the limit, once it is known
        self.is_paused = False
        self.has_alarm = has_alarm
        self.is_over = False

    def arm(self) -> None:
        """Starts the timers for the seconds that are left, or stops them."""
        left: float | None = None
        if not self.is_paused and self.seconds is not None and 0 < self.seconds < math.inf:
            left = _of_timer(self.seconds - (time.monotonic() - self.began))
        planning.set_deadline(left)
        if self.has_alarm:
            signal.setitimer(signal.ITIMER_REAL, left or 0.0)

    def end(self, *_: Any) -> None:
        """Answers the alarm."""
        if not self.is_paused:
            self.is_over = True
            raise planning.OutOfTime

    def out_of_time(self) -> OutOfTimeError:
        """Returns the error that reports the time limit."""
        return OutOfTimeError(
            f"budget.seconds: {self.seconds:g} s were over before the {self.what}; should be larger"
        )


class _Current(threading.local):
    reading: Reading | None = None


_current = _Current()


@contextlib.contextmanager
def reading(
    seconds: float | None = None, alarm: bool = False, what: str = "task was read"
) -> Iterator[Reading]:
    """Ends the block with OutOfTimeError when the limit is reached.

    Parameters
    ----------
    seconds : float, optional
        Limit [s]; by default that of the task, see `limit_reading`.
    what : str
        What had not been done at the limit, for the message.
    alarm : bool
        Also interrupt Python code, by SIGALRM. For the command line alone: a library must leave
        signals to its caller.
    """
    is_main = threading.current_thread() is threading.main_thread()
    clock = Reading(alarm and is_main and hasattr(signal, "setitimer"), what)
    before, outer = None, _current.reading
    if clock.has_alarm:
        before = signal.signal(signal.SIGALRM, clock.end)
    _current.reading = clock
    try:
        if seconds is not None:
            limit_reading(seconds)
        yield clock
    except planning.OutOfTime:
        raise clock.out_of_time() from None
    except Exception:
        if clock.is_over:  # a library has turned the alarm into an error of its own
            raise clock.out_of_time() from None
        raise
    finally:
        clock.is_paused = True
        clock.arm()
        if clock.has_alarm:
            signal.signal(signal.SIGALRM, before)
        _current.reading = outer


@contextlib.contextmanager
def within(seconds: float) -> Iterator[None]:
    """Makes `poll` raise planning.OutOfTime in the block when the seconds are over."""
    planning.set_deadline(_of_timer(seconds))
    try:
        yield
    finally:
        planning.set_deadline(None)


def limit_reading(seconds: float) -> None:
    """Sets the limit [s] of the `reading` that runs, if one does and has none yet."""
    clock = _current.reading
    if clock is not None and clock.seconds is None:
        clock.seconds = seconds
        clock.arm()


@contextlib.contextmanager
def uncounted() -> Iterator[None]:
    """Stops the clock of the `reading` that runs: for imports, which must not be interrupted."""
    clock = _current.reading
    if clock is None or clock.is_paused:
        yield
        return
    start = time.monotonic()
    clock.is_paused = True
    clock.arm()
    try:
        yield
    finally:
        clock.began += time.monotonic() - start
        clock.is_paused = False
        clock.arm()


@contextlib.contextmanager
def without_collector() -> Iterator[None]:
    """Stops Python's collector of cycles while a large tree without cycles grows.

    Each of its runs traverses the whole tree, for up to half a second, which no signal ends. If an
    exception (a signal or the time limit) ends a command within the block, the tree is neither
    traversed again nor freed; the process ends instead.
    """
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    except BaseException as error:
        clock = _current.reading
        if _commands.ends_with_command and clock is not None and clock.has_alarm:
            _left.append(error)  # its frames hold the tree
            was_enabled = False
        raise
    finally:
        if was_enabled:
            gc.enable()


def is_over(budget: planning.Budget, began: float) -> bool:
    """True if the budget was stopped, or its seconds have passed since `began`."""
    return budget.is_stopped or time.monotonic() - began >= budget.seconds


def rest(budget: planning.Budget, began: float) -> planning.Budget:
    """Returns the budget with the seconds that are left of it since `began`, by time.monotonic."""
    left = max(1e-9, budget.seconds - (time.monotonic() - began))
    return budget.part(seconds=left, seed=budget.seed)
