# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Goals of the actions: accepted, planned, executed, cancelled; each ends with one result."""

from __future__ import annotations

import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Protocol

from rclpy.task import Future

from ..errors import TaskError, explain
from .halting import HaltedError
from .jobs import Found
from .messages import RefusedError
from .workers import Alarm

if TYPE_CHECKING:
    from collections.abc import Callable

    from .workers import Workers

_LOOK = 0.01  # between looks whether a motion has stopped [s]


@dataclass
class Ending:
    """End of a goal.

    Attributes
    ----------
    status, reason : str
        As in the message Motion.
    found : Found
        What was planned, if it came to that.
    seconds : float
        Time since the goal was accepted [s].
    """

    status: str
    reason: str
    found: Found = field(default_factory=Found)
    seconds: float = 0.0

    @property
    def is_success(self) -> bool:
        """True if the goal got what it asked for."""
        return self.status in ("solved", "executed")


class Goal:
    """A goal that was accepted."""

    def __init__(self, handle: Any, began: float, tell: Callable[[Goal, str], None]) -> None:
        self.handle, self.began = handle, began
        self.cancel = Alarm()
        self.wakes: Any = None  # called at the end
        self.future: Any = Future()
        self.withdrawn = "canceled", "the client canceled the goal"
        self._tell = tell
        self._lock = threading.Lock()
        self._started = time.monotonic()
        self._is_over = False
        self.is_waiting = True  # for a planner

    @property
    def request(self) -> Any:
        """The fields of the goal."""
        return self.handle.request

    @property
    def seconds(self) -> float:
        """Time since it was accepted [s]."""
        return time.monotonic() - self._started

    def tell(self, phase: str) -> None:
        """Sends feedback."""
        if not self.cancel.has_rung:
            self._tell(self, phase)

    def end(self, ending: Ending) -> None:
        """Ends the goal; a second end is ignored."""
        with self._lock:
            if self._is_over:
                return
            self._is_over = True
        ending.seconds = self.seconds
        self.future.set_result(ending)
        self.wakes()

    def withdraw(self, status: str, reason: str) -> None:
        """Cancels the goal from any thread; whoever works on it ends it."""
        if not self.cancel.has_rung:
            self.withdrawn = status, reason
            self.cancel.ring()


class Mover(Protocol):
    """A way of executing."""

    def execute(self, found: Found, cancel: Alarm, tell: Callable[[str], object]) -> None:
        """Executes a plan; raises RefusedError or HaltedError."""


class Desk:
    """Plans goals in their order, `jobs` at a time, and executes one at a time.

    Parameters
    ----------
    workers : Workers
    jobs, queue : int
        Numbers of goals that are planned at a time, and that may wait or be planned.
    """

    def __init__(self, workers: Workers, jobs: int, queue: int) -> None:
        self._workers, self._most = workers, queue
        self._planners = ThreadPoolExecutor(jobs, "graspless-plan")
        self._movers = ThreadPoolExecutor(1, "graspless-move")
        self._lock = threading.Lock()
        self._goals: dict[int, Goal] = {}
        self._moving: Goal | None = None
        self._is_closing = False
        self.counts: dict[str, int] = {}

    @property
    def size(self) -> int:
        """Number of goals that are under way."""
        return len(self._goals)

    def take(
        self, goal: Goal, job: Callable[[Goal], Any], mover: Callable[[Goal], Mover | None]
    ) -> None:
        """Takes a goal.

        Parameters
        ----------
        goal : Goal
        job : callable
            Returns the job of a goal; raises RefusedError.
        mover : callable
            Returns what executes the plan of a goal; None: nothing.
        """
        reason = f"{self._most} goals are waiting already (queue)"
        with self._lock:
            if self._is_closing:
                reason = "the node is shutting down"
            elif len(self._goals) < self._most:
                self._goals[id(goal)] = goal
                self._planners.submit(self._plan, goal, job, mover)
                return
        self._count("refused")
        goal.end(Ending("refused", reason))

    def cancel(self, goal: Goal, status: str = "", reason: str = "") -> None:
        """Cancels a goal. One that waits ends at once."""
        goal.withdraw(status or "canceled", reason or "the client canceled the goal")
        with self._lock:
            waits, goal.is_waiting = goal.is_waiting, False
        if waits:
            self._end(goal, Ending(*goal.withdrawn))

    def cancel_all(self, status: str, reason: str, besides: Goal | None = None) -> None:
        """Cancels all goals, with the status and reason that their clients get."""
        with self._lock:
            goals = [goal for goal in self._goals.values() if goal is not besides]
        for goal in goals:
            self.cancel(goal, status, reason)

    def close(self) -> None:
        """Cancels all goals and waits until none is under way; refuses others from now on."""
        with self._lock:
            self._is_closing = True
        self.cancel_all("stopped", "the node is shutting down")
        self._planners.shutdown(wait=True)
        self._movers.shutdown(wait=True)

    def _plan(self, goal: Goal, job: Any, mover: Any) -> None:
        with self._lock:
            waits, goal.is_waiting = goal.is_waiting, False
        if not waits:
            return  # it was cancelled
        try:
            moves = mover(goal)
            if moves is not None:
                self._await_stop(goal)
            found = self._workers.run(job(goal), goal.cancel, goal.tell)
            if found is None:
                raise HaltedError(*goal.withdrawn)
            if moves is None or not found.is_solved:
                self._end(goal, Ending(found.status, found.reason, found))
                return
            self._start(goal, found, moves)
        except Exception as error:
            was_cancelled = goal.cancel.has_rung  # whatever it was doing
            self._end(goal, Ending(*goal.withdrawn) if was_cancelled else _ending(error, goal))

    def _await_stop(self, goal: Goal) -> None:
        """Waits until a motion that was cancelled has stopped: the job measures the robot.

        A mover ends within a limit of its own, and no goal that was cancelled waits.
        """
        while self._is_stopping() and not goal.cancel.has_rung:
            goal.cancel.wait(_LOOK)

    def _is_stopping(self) -> bool:
        with self._lock:
            return self._moving is not None and self._moving.cancel.has_rung

    def _start(self, goal: Goal, found: Found, mover: Mover) -> None:
        with self._lock:
            if self._moving is not None:
                raise RefusedError("the robot is moving for another goal")
            self._moving = goal
        self._movers.submit(self._move, goal, found, mover)

    def _move(self, goal: Goal, found: Found, mover: Mover) -> None:
        try:
            mover.execute(found, goal.cancel, goal.tell)
            ending = Ending("executed", "", found)
        except Exception as error:
            ending = _ending(error, goal, found)
        with self._lock:
            self._moving = None
        self._end(goal, ending)

    def _end(self, goal: Goal, ending: Ending) -> None:
        with self._lock:
            self._goals.pop(id(goal), None)
        self._count(ending.status)
        goal.end(ending)

    def _count(self, status: str) -> None:
        with self._lock:
            self.counts[status] = self.counts.get(status, 0) + 1


def _ending(error: Exception, goal: Goal, found: Found | None = None) -> Ending:
    """Returns the end of a goal that an error stopped."""
    found = found or Found()
    if isinstance(error, HaltedError):
        if error.status == "canceled" and goal.cancel.has_rung:
            status, reason = goal.withdrawn
            remark = str(error).partition("; ")[2]
            return Ending(status, f"{reason}; {remark}" if remark else reason, found)
        return Ending(error.status, str(error), found)
    if isinstance(error, (RefusedError, TaskError)):
        return Ending("refused", str(error), found)
    return Ending("stopped", explain(error), found)
