# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a picture and a replay share: the moments worth drawing, and where to look from."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..bodies import obstacles, robot
from ..raster import Camera
from . import bodies

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...frames import Matrix
    from ..bodies import Body
    from ..film import Film

MOMENTS = {
    "press": "1  press",
    "slide": "2  slide to the edge",
    "reach": "3  come round",
    "close": "4  grasp",
}


def moments(shown: Film) -> list[tuple[int, str]]:
    """Rows to draw the robot at, with what happens there."""
    rows = [
        (int(shown.rows(name)[-1]), caption)
        for name, caption in MOMENTS.items()
        if name in shown.names
    ]
    return rows or [(0, "start")]


def placed(shown: Film, row: int) -> list[tuple[Body, Matrix]]:
    """Every body with its pose in the world at a row."""
    task = shown.plan.task
    found = [
        (bodies.table_body(task), np.asarray(task.problem.support.X_WS)),
        (bodies.object_body(task), shown.object_poses[row]),
        *obstacles(task),
        *zip(robot(task), shown.link_poses[row], strict=True),
        (bodies.trail_body(shown), np.eye(4)),
    ]
    return [(body, X_WB) for body, X_WB in found if body.parts]


def camera(shown: Film, width: int, height: int, rows: Sequence[int] | None = None) -> Camera:
    """From beyond the edge where the object goes, so that the grasp is seen, and beside the robot.

    Parameters
    ----------
    shown : Film
    width, height : int
        Of the picture that all the rows must fit in.
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
    aside *= 1 if outward @ aside >= 0 else -1
    outward /= max(np.linalg.norm(outward), 1e-6)
    # Never from behind the robot: its shoulder would hide everything.
    direction = aside + 0.45 * outward + max(0.35, outward @ ahead) * ahead
    direction /= np.linalg.norm(direction)
    direction[2] = 0.62
    eye = middle + 2.7 * direction
    points = _seen(shown, [row for row, _ in moments(shown)] if rows is None else rows)
    return Camera(eye, middle).fitted(points, width, height)


def _seen(shown: Film, rows: Sequence[int]) -> Matrix:
    """[N, 3] vertices of all bodies at the rows, in the world."""
    links = robot(shown.plan.task)
    thing = bodies.object_body(shown.plan.task)
    moving = [
        (body, X_WB)
        for row in rows
        for body, X_WB in (
            (thing, shown.object_poses[row]),
            *zip(links, shown.link_poses[row], strict=True),
        )
    ]
    return np.concatenate(
        [
            part.vertices @ X_WB[:3, :3].T + X_WB[:3, 3]
            for body, X_WB in placed(shown, rows[0]) + moving
            for part in body.parts
        ]
    )
