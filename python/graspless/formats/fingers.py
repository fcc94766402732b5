# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contact points of bare fingertips over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..timing import Trajectory


def contacts(trajectory: Trajectory) -> Matrix:
    """[N, n, 3] contact points in the world [m]; NaN while a finger is off the object.

    n is 0 where an arm carries the fingertips.
    """
    count = 0
    if not trajectory.joint_names:
        count = max((s.fingers.shape[1] for s in trajectory.segments if len(s)), default=0)
    points = np.full((len(trajectory), count, 3), np.nan)
    if count:
        fingers = [segment.fingers for segment in trajectory.segments]
        for k, (i, row) in enumerate(zip(trajectory.segment_index, trajectory.rows, strict=True)):
            p_O = fingers[i][int(np.clip(np.rint(row), 0, len(fingers[i]) - 1))]
            X_WO = trajectory.object_poses[k]
            points[k] = p_O @ X_WO[:3, :3].T + X_WO[:3, 3]
    return points
