# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Poses as an application gives them: which can be used, and as what measurement."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .clock import number
from .estimate import MEMORY

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..slide import Problem
    from .estimate import Estimate
    from .hand import Hand

TILT = 0.35  # of an object beyond which it does not lie on its support [rad], unless it is narrow
HEIGHT = 0.02  # above or below its support, the same; and of what a roll of it lifts [m]
OUTSIDE = 0.02  # of its centre of mass beyond the support's edge, the same [m]
VAGUE = 0.05  # standard deviation of a position along the support that says nothing [m]
_ORTHOGONAL = 1e-3  # tolerance of a rotation
_SYMMETRIC = 1e-3  # tolerance of a covariance, as of a correlation
_SAME = 1e-6  # between times of one exposure whose age was rounded [s]
_AHEAD = 0.005  # of the loop's clock that the camera's may be: an age below 0 counts as 0 then [s]


class Camera:
    """Checks poses and hands them to the filter."""

    def __init__(self, problem: Problem, hand: Hand) -> None:
        self._hand = hand
        self._polygon = problem.support.polygon
        self._com = np.append(problem.object.com, 1.0)
        self._outline = np.array(problem.object.outline.vertices)
        self._newest = -np.inf
        self.forget()

    def forget(self) -> None:
        """Counts poses anew."""
        self.used = 0
        self.since = -np.inf  # time at which a pose was used last, or refused first if none was
        self.refused = ""  # verdict on the last pose, if it was not used
        self.off = 0  # successive poses of an object that is off its support

    @property
    def is_failing(self) -> bool:
        """True if poses were given, but none could be used."""
        return bool(self.refused) and not self.used

    def see(
        self, t: float, pose: Any, covariance: Any, age: Any, lag: float, estimate: Estimate
    ) -> str:
        """Takes a pose X_WO that is `age` [s] old at time t; returns what became of it.

        The object comes `lag` [s] after the motions that the estimate was told.
        """
        verdict = self._verdict(t, pose, covariance, age, lag, estimate)
        is_used = verdict in ("used", "moved")
        if is_used or self.since == -np.inf:
            self.since = t
        self.used += is_used
        self.refused = "" if is_used else verdict
        return verdict

    def _verdict(
        self, t: float, pose: Any, covariance: Any, age: Any, lag: float, estimate: Estimate
    ) -> str:
        X_WO, R = _pose(pose), _covariance(covariance)
        if X_WO is None:
            return "not_a_pose"
        if R is None:
            return "not_a_covariance"
        seconds, fault = number(age)
        if fault or seconds < -_AHEAD:
            return "bad_age"
        if seconds > MEMORY:
            return "late"
        taken = t - max(seconds, 0.0)
        if taken <= self._newest + _SAME:
            return "out_of_order"
        self._newest = taken
        flat = self._flat(R)
        if flat is not None and max(flat[0, 0], flat[1, 1]) > VAGUE**2:
            return "vague"
        X_SO, seen = self._hand.X_SW @ X_WO, self._hand.seen(X_WO)
        fault = self._off(X_SO, seen[3])
        if fault:
            self.off += 1
            return fault
        if flat is not None:
            flat = _moved(flat, X_SO[:2, :2] @ self._com[:2])
        verdict = estimate.measure(taken - lag, seen, flat)
        if verdict in ("used", "moved"):
            self.off = 0
        return verdict

    def _off(self, X_SO: Matrix, height: float) -> str:
        if self._is_tipped(X_SO):
            return "tilted"
        outside = -float(self._polygon.depth((X_SO @ self._com)[:2]))
        far = abs(height) > HEIGHT or outside > OUTSIDE
        return "off_support" if far else ""

    def _is_tipped(self, X_SO: Matrix) -> bool:
        """Returns True if the object is tilted so far that it is about to fall, or has fallen.

        A handle may roll on the spot under the finger, and lies flat again when that leaves it.
        """
        lifted = float(np.ptp(self._outline @ X_SO[2, :2]))
        return bool(X_SO[2, 2] < np.cos(TILT) and not (X_SO[2, 2] > 0 and lifted <= HEIGHT))

    def _flat(self, R: Matrix) -> Matrix | None:
        """Returns the covariance of x, y, yaw and height in S of one in the world."""
        if not R.size:
            return None
        turn = np.kron(np.eye(2), self._hand.X_SW[:3, :3])
        keep = [0, 1, 5, 2]
        flat: Matrix = (turn @ R @ turn.T)[np.ix_(keep, keep)]
        return flat


def _moved(flat: Matrix, lever: Matrix) -> Matrix:
    """Returns a covariance of x, y, yaw and height, at a point that is `lever` [2] farther."""
    moves = np.eye(4)
    moves[:2, 2] = -lever[1], lever[0]
    return np.asarray(moves @ flat @ moves.T)


def _pose(given: Any) -> Matrix | None:
    try:
        X = np.asarray(given, dtype=float)
    except (TypeError, ValueError, OverflowError):
        return None
    if X.shape != (4, 4) or not np.isfinite(X).all():
        return None
    R = X[:3, :3]
    rigid = np.abs(R @ R.T - np.eye(3)).max() < _ORTHOGONAL and np.linalg.det(R) > 0
    return X if rigid and np.allclose(X[3], [0, 0, 0, 1], atol=_ORTHOGONAL) else None


def _covariance(given: Any) -> Matrix | None:
    """Returns a covariance [6, 6]; an empty array if there is none, None if it is not one."""
    if given is None:
        return np.zeros((0, 0))
    try:
        R = np.asarray(given, dtype=float)
    except (TypeError, ValueError, OverflowError):
        return None
    if R.shape != (6, 6) or not np.isfinite(R).all():
        return None
    spread = np.sqrt(np.abs(np.diag(R)))
    if (np.abs(R / 2 - R.T / 2) > _SYMMETRIC / 2 * np.outer(spread, spread)).any():
        return None
    R = R / 2 + R.T / 2
    return R if np.linalg.eigvalsh(R).min() > 0 else None
