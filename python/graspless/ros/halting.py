# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reasons to end an execution early: a clock that jumps back, joints whose state is lost."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from .messages import RefusedError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix
    from .senses import Joints


class HaltedError(Exception):
    """An execution that has ended early, with a status and a reason of the message Motion."""

    def __init__(self, status: str, reason: str) -> None:
        super().__init__(reason)
        self.status = status


class Clock(Protocol):
    """Time of the node."""

    def now(self) -> float:
        """Returns the time [s]."""

    @property
    def jumps(self) -> int:
        """Number of times that it has jumped back."""


class Timer:
    """The time since an execution was asked for, by a clock that must not jump back."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._jumps = clock.jumps
        self._last = self.start = clock.now()

    def elapsed(self) -> float:
        """Returns the time since the start [s]. Raises HaltedError if it has jumped back."""
        now = self._clock.now()
        if now < self._last or self._clock.jumps != self._jumps:
            raise HaltedError("stopped", "time has jumped back")
        self._last = now
        return now - self.start


def positions(joints: Joints, names: Sequence[str], oldest: float, timer: Timer) -> Matrix:
    """Returns the positions of joints that move [rad or m].

    Raises
    ------
    HaltedError
        Time has jumped back, which is why they are not known.
    RefusedError
        They are not known for another reason.
    """
    try:
        return joints.positions(names, oldest)
    except RefusedError:
        timer.elapsed()
        raise
