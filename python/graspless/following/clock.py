# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time as an application gives it: how far it goes on, and faults of it."""

from __future__ import annotations

import math
import numbers
from typing import Any

import numpy as np

LEAST = 1e-6  # step of the time; smaller ones are gathered, as their velocities would be noise [s]
JUMP = 1.0  # step of the time that is an outlier, unless the next time goes on from there [s]
_LOOP = 0.002  # time between calls before it is known [s]
_SLOWEST = 0.1  # loop [s]
_SHARE = 0.125  # of a step in the mean time between calls


class Clock:
    """Time of a loop, and of calls whose time is a fault.

    A time that does not go on from the last one is a fault. If the next one goes on from it, the
    clock was set: the time goes on, without the jump.

    Parameters
    ----------
    patience : float
        Time without a step after which the clock is lost [s].

    Attributes
    ----------
    now : float
        Time that increases also where the clock was set; -inf before the first call [s].
    period : float
        Mean time between calls [s].
    was_set : bool
        True if the last step went on from a time that was refused: the clock was set, or nobody
        called for a while.
    """

    def __init__(self, patience: float) -> None:
        self._patience = patience
        self.now = -math.inf
        self.period = _LOOP
        self.was_set = False
        self._last = self._refused = math.nan
        self._shift = 0.0  # from a time to `now`
        self._calls = 0  # since the last step

    @property
    def is_lost(self) -> bool:
        """True if there was no step for longer than the patience, by the usual period of calls."""
        return self._calls * self.period > self._patience

    def step(self, given: Any) -> tuple[float, str]:
        """Returns the time since the last step [s], and the fault of a given time or no text.

        The step is 0 in the first call, where it is smaller than LEAST, and where there is a fault.
        """
        self._calls += 1
        t, fault = number(given)
        if fault:
            return 0.0, f"t: {fault}"
        if self.now > -math.inf:
            return self._on(t)
        self._last = self.now = t
        self._calls = 0
        return 0.0, ""

    def _on(self, t: float) -> tuple[float, str]:
        since, self.was_set = t - self._last, False
        if not 0 < since <= JUMP:
            if not LEAST <= t - self._refused <= JUMP:
                self._refused = t
                off = f"{since:.3g} s after the last one: is this the clock of the loop?"
                return 0.0, f"t: {t}: " + (off if since > 0 else f"should be above {self._last}")
            since = t - self._refused
            self._shift = self.now + since - t
            self.was_set = True
        if since >= LEAST:
            self.period += _SHARE * (min(since / self._calls, _SLOWEST) - self.period)
            self._last, self._refused, self._calls = t, math.nan, 0
        elif self.is_lost:
            return 0.0, f"t: {t}: stands still"
        self.now = t + self._shift
        return (since if since >= LEAST else 0.0), ""


def number(given: Any) -> tuple[float, str]:
    """Returns a finite number and an empty text, or NaN and what is wrong with it."""
    value = given[()] if isinstance(given, np.ndarray) and given.ndim == 0 else given
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        kind = f"array {value.shape}" if isinstance(value, np.ndarray) else type(value).__name__
        return math.nan, f"{kind}: should be a number (int, float or one of numpy)"
    try:
        found = float(value)
    except OverflowError:
        return math.nan, f"{type(value).__name__} too large for a float"
    if not math.isfinite(found):
        return math.nan, f"{found}: should be finite"
    return found, ""
