# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A displacement of the object half way through a slide, as by something that knocks it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ... import frames
from .scene import OBJECT

if TYPE_CHECKING:
    from ...frames import Matrix
    from ..variation import Variation
    from .scene import Scene


class Kick:
    """Displaces the object once, when it has moved half of the way from its start to its goal."""

    def __init__(self, variation: Variation) -> None:
        self._left = bool(variation.kick_x or variation.kick_y or variation.kick_yaw)
        self._variation = variation

    def watch(self, scene: Scene, data: Any, X_WO_goal: Matrix) -> None:
        """Displaces the object if it is half way now; called while it slides."""
        if not self._left:
            return
        joint = data.joint(OBJECT)
        start, goal = scene.X_WO[:3, 3], X_WO_goal[:3, 3]
        if np.linalg.norm(joint.qpos[:3] - start) < np.linalg.norm(goal - start) / 2:
            return
        self._left, kick = False, self._variation
        R_WO = frames.from_quaternion(joint.qpos[3:])
        up = R_WO[:3, 2].copy()
        side = R_WO[:3, 0].copy()
        joint.qpos[:3] += kick.kick_x * side + kick.kick_y * np.cross(up, side)
        joint.qpos[3:] = frames.to_quaternion(R_WO @ frames.planar(0.0, 0.0, kick.kick_yaw))
