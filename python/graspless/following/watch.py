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
        self._faulty = 0.0  # time for which the joints have been wrong [s]
        self._has_matched = False

    def joints(self, seconds: float, q: Any, target: Matrix) -> tuple[str, bool]:
        """Returns what is wrong with measured joints [dof], and True if that has lasted too long.

        `seconds` have passed since the last call. The text is empty if nothing is wrong. An arm
        that has never been near its target must not go there: that is too long at once.
        """
        joints, fault = _joints(q, target)
        far = "" if fault else self._far(joints, target)
        if not fault and not far:
            self._faulty, self._has_matched = 0.0, True
            return "", False
        self._faulty += seconds
        at_once = bool(far) and not self._has_matched
        return fault or far, at_once or self._faulty > self._settings.joint_seconds

    def poses(
        self, seconds: float, lost: float, refused: str, is_looking: bool
    ) -> tuple[str, bool]:
        """Returns the same for `seconds` without a usable pose; infinite if none was given.

        `lost` is the part of them since the slide began [s]. `refused` is the verdict on the last
        one, or empty.
        """
        s = self._settings
        least = min(s.blind_seconds, s.look_seconds) if is_looking else s.blind_seconds
        if not least < seconds < np.inf:
            return "", False
        return without_pose(f"for {seconds:.1f} s", refused), lost > s.lost_seconds

    def _far(self, joints: Matrix, target: Matrix) -> str:
        """Returns the joint of the arm that is farthest from its target, if it is too far."""
        tolerance = self._settings.joint_tolerance
        off = (np.abs(joints - target) * self._weights)[self._arm]
        worst = int(np.argmax(off))
        if off[worst] > tolerance:
            return f"q: {self._names[self._arm[worst]]} is {off[worst]:.2g} from its target"
        return ""


def without_pose(since: str, refused: str) -> str:
    """Returns the reason of a motion that lacks poses, with the verdict on the last one."""
    return f"no usable pose {since}" + (f"; the last one was {refused}" if refused else "")


def _joints(q: Any, target: Matrix) -> tuple[Matrix, str]:
    """Returns measured joints [dof] and an empty text, or what is wrong with them."""
    try:
        joints = np.asarray(q, dtype=float)
    except (TypeError, ValueError, OverflowError):
        return target, "q: should be an array of numbers"
    if joints.shape != target.shape:
        return target, f"q: shape {joints.shape}: should be {target.shape}"
    return joints, "" if np.isfinite(joints).all() else "q: should be finite"
