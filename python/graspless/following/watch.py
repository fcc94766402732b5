# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reasons for which a motion has to wait, or to end: joints that do not match, and no poses."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix
    from ..robot import Robot
    from .settings import Settings


class Watch:
    """Compares measured joints with their targets, and counts the time without poses."""

    def __init__(self, robot: Robot, arm: Sequence[int], settings: Settings) -> None:
        self._names, self._arm = list(robot.joint_names), np.array(arm)
        self._weights = np.asarray(robot.step_weights)
        self._settings = settings
        self._faulty = np.inf  # time for which the joints have been wrong; at first at once

    def joints(self, seconds: float, q: Any, target: Matrix) -> tuple[str, bool]:
        """Returns what is wrong with measured joints [dof], and True if that has lasted too long.

        `seconds` have passed since the last call. The text is empty if nothing is wrong.
        """
        fault = self._fault(q, target, self._settings.joint_tolerance)
        self._faulty = self._faulty + seconds if fault else 0.0
        return fault, self._faulty > self._settings.joint_seconds

    def poses(self, seconds: float) -> tuple[str, bool]:
        """Returns the same for `seconds` without a pose; infinite if there never was one."""
        s = self._settings
        if not s.blind_seconds < seconds < np.inf:
            return "", False
        return f"no usable pose for {seconds:.1f} s", seconds > s.lost_seconds

    def _fault(self, q: Any, target: Matrix, tolerance: float) -> str:
        """Returns what is wrong with measured joints [dof], or an empty text.

        The joints of the arm may be off their targets by `tolerance` [rad; m/10].
        """
        try:
            joints = np.asarray(q, dtype=float)
        except (TypeError, ValueError):
            return "q: should be an array of numbers"
        if joints.shape != target.shape:
            return f"q: shape {joints.shape}: should be {target.shape}"
        if not np.isfinite(joints).all():
            return "q: should be finite"
        off = (np.abs(joints - target) * self._weights)[self._arm]
        worst = int(np.argmax(off))
        if off[worst] > tolerance:
            return f"q: {self._names[self._arm[worst]]} is {off[worst]:.2g} from its target"
        return ""


def is_time(given: Any) -> bool:
    """Returns True for a finite number."""
    is_number = isinstance(given, (int, float, np.number)) and not isinstance(given, bool)
    return is_number and bool(np.isfinite(given))
