# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Camera, and the points that it must show."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ... import frames
from ..raster import Camera

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...frames import Matrix
    from ...tasks import Task
    from .moments import Moment

ELEVATION = 0.42  # [rad]
ALONG = 0.45  # cosine of the view's angle to the motion: from the side, slightly from the front


def swept(task: Task, moments: Sequence[Moment]) -> Matrix:
    """Returns corners of object and fingertips at the moments, [N, 3] in the world."""
    hull, radius = task.problem.object.hull, task.problem.fingers.radius
    points = [frames.transform(moment.X_WO, hull) for moment in moments]
    around = radius * np.concatenate([np.eye(3), -np.eye(3)])
    for moment in moments:
        centers = moment.centers_W[np.isfinite(moment.centers_W).all(axis=1)]
        points.append((centers[:, None] + around).reshape(-1, 3))
    return np.concatenate(points)


def camera(task: Task, moments: Sequence[Moment], points: Matrix, shape: tuple[int, int]) -> Camera:
    """Places the camera where it sees the motion and most fingertips, and no wall from behind.

    Parameters
    ----------
    task : Task
    moments : sequence of Moment
        Moments to show.
    points : array [N, 3]
        Points that the picture must contain, in the world [m].
    shape : tuple of int
        Width and height of the picture.
    """
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    size = float(np.ptp(points, axis=0).max())
    best: tuple[float, Matrix] | None = None
    for azimuth in np.radians(np.arange(-180, 180, 10) - 55):
        level = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
        toward = np.cos(ELEVATION) * level + np.sin(ELEVATION) * np.array([0.0, 0.0, 1.0])
        score = _score(task, moments, toward)
        if best is None or score > best[0] + 1e-9:
            best = score, toward
    assert best is not None
    eye = middle + 6.0 * size * best[1]
    return Camera(eye, middle).fitted(points, *shape)


def _score(task: Task, moments: Sequence[Moment], toward: Matrix) -> float:
    """Returns how well a direction shows the plan; higher is better."""
    seen = 0.0
    for moment in moments:
        middle = moment.X_WO[:3, :3] @ np.asarray(task.problem.object.com) + moment.X_WO[:3, 3]
        for center in moment.centers_W:
            if np.isfinite(center).all():
                outward = (center - middle) / max(float(np.linalg.norm(center - middle)), 1e-9)
                seen += float(np.clip(outward @ toward + 0.2, -0.5, 0.5))
    seen /= max(1, sum(len(moment.modes) for moment in moments))
    walls = [np.asarray(plane.n_W) @ toward for plane in task.problem.planes[1:]]
    hidden = sum(1.0 for facing in walls if facing < 0.1)
    motion = moments[-1].X_WO[:3, 3] - moments[0].X_WO[:3, 3]
    length = float(np.linalg.norm(motion[:2]))
    along = abs(float(motion[:2] @ toward[:2])) / length if length > 1e-9 else ALONG
    return 1.6 * seen - 1.5 * hidden - 1.2 * abs(along - ALONG)
