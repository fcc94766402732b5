# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bare fingertips over time: their contact points and their centres."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import frames
from ..kinds import stages_of

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
        for k, i in enumerate(trajectory.segment_index):
            p_O = fingers[i][_row(trajectory, k)]
            points[k] = frames.transform(trajectory.object_poses[k], p_O)
    return points


def centers(trajectory: Trajectory, k: int) -> Matrix:
    """[n, 3] centres of fingertips at sample k [m]: one that is off waits at its next place."""
    X_WO, now = trajectory.object_poses[k], int(trajectory.segment_index[k])
    fingers = stages_of(trajectory.plan)[0].task.problem.fingers
    radius, count = fingers.radius, fingers.count
    found = np.tile([0.0, 0.0, 1.0], (count, 1))
    row = _row(trajectory, k)
    for i in range(count):
        places = [(now, row), *((later, 0) for later in range(now + 1, len(trajectory.segments)))]
        places += [(earlier, -1) for earlier in range(now - 1, -1, -1)]
        for segment, at in places:
            p_O = trajectory.segments[segment].fingers[at, i]
            if np.isfinite(p_O).all():
                center_O = p_O - radius * trajectory.segments[segment].normals[at, i]
                found[i] = X_WO[:3, :3] @ center_O + X_WO[:3, 3]
                break
    return found


def _row(trajectory: Trajectory, k: int) -> int:
    """Returns the row of its segment that is nearest to sample k."""
    last = len(trajectory.segments[trajectory.segment_index[k]].fingers) - 1
    return int(np.clip(np.rint(trajectory.rows[k]), 0, last))
