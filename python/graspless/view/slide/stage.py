# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts that picture and replay share: the moments to draw, and the camera."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..bodies import obstacles, vertices_of, without_wide
from ..raster import Camera
from . import bodies

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...frames import Matrix
    from ..bodies import Body
    from ..film import Film

MOMENTS = {
    "press": "press",
    "slide": "slide to the edge",
    "reach": "reach for the edge",
    "close": "grasp",
}


def moments(shown: Film) -> list[tuple[int, str]]:
    """Returns rows to draw the robot at, with captions."""
    captions = MOMENTS
    if shown.plan.task.problem.X_WO_end is not None:
        captions = {"press": "press", "slide": "slide to the place", "lift": "lift off"}
    found = [(name, caption) for name, caption in captions.items() if name in shown.names]
    rows = [
        (int(shown.rows(name)[-1]), f"{k}  {caption}")
        for k, (name, caption) in enumerate(found, start=1)
    ]
    return rows or [(0, "start")]


def placed(shown: Film, row: int) -> list[tuple[Body, Matrix]]:
    """Returns every body but the obstacles, with its pose in the world at a row."""
    task = shown.plan.task
    found = [
        (bodies.table_body(task), np.asarray(task.problem.support.X_WS)),
        (bodies.object_body(task), shown.object_poses[row]),
        *zip(shown.robot, shown.link_poses[row], strict=True),
        (bodies.trail_body(shown), np.eye(4)),
    ]
    return [(body, X_WB) for body, X_WB in found if body.parts]


def camera(shown: Film, width: int, height: int, rows: Sequence[int] | None = None) -> Camera:
    """Places the camera beside the robot and beyond the edge, so that the grasp is visible.

    A pinch, which ends at no edge, is seen from the side on which the nearest obstacle is not.

    Parameters
    ----------
    shown : Film
    width, height : int
        Size of the picture, in which all the rows must fit [pixels].
    rows : sequence of int, optional
        Default: those of `moments`.
    """
    support = shown.plan.task.problem.support
    centroid = (np.asarray(support.X_WS) @ [*np.asarray(support.polygon.centroid), 0, 1])[:3]
    base = shown.link_poses[0, 0, :3, 3]
    middle = 0.6 * centroid + 0.4 * np.array([*base[:2], centroid[2]])
    outward = shown.object_poses[-1][:3, 3] - centroid
    ahead = centroid - base
    outward[2] = ahead[2] = 0
    ahead /= max(np.linalg.norm(ahead), 1e-6)
    aside = np.array([-ahead[1], ahead[0], 0.0])
    towards = -_to_obstacle(shown) if shown.plan.kind == "pinch" else outward
    aside *= 1 if towards @ aside >= 0 else -1
    outward /= max(np.linalg.norm(outward), 1e-6)
    # Never from behind the robot, whose shoulder would hide everything.
    direction = aside + 0.45 * outward + max(0.35, outward @ ahead) * ahead
    direction /= np.linalg.norm(direction)
    direction[2] = 0.62
    eye = middle + 2.7 * direction
    seen = [row for row, _ in moments(shown)] if rows is None else rows
    beside = without_wide(obstacles(shown.plan.task))
    points = vertices_of([*beside, *(body for row in seen for body in placed(shown, row))])
    return Camera(eye, middle).fitted(points, width, height)


def _to_obstacle(shown: Film) -> Matrix:
    """Returns the way from the object to the nearest obstacle [3]; 0 if there is none."""
    p_WO = shown.object_poses[0][:3, 3]
    ways = [np.asarray(body.X_WB)[:3, 3] - p_WO for body in shown.plan.task.problem.obstacles]
    return min(ways, key=lambda way: float(np.linalg.norm(way)), default=np.zeros(3))
