# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts that picture and replay share: the bodies, and the camera."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..bodies import obstacles, vertices_of
from ..raster import Camera
from . import bodies

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...frames import Matrix
    from ..bodies import Body
    from ..film import Film


NEAR, SMALL = 0.1, 0.6  # distance and size of things that a picture must contain [m]


class Scene:
    """Bodies of a carry, made once, and their poses at each row."""

    def __init__(self, shown: Film) -> None:
        self.shown = shown
        task = shown.plan.task
        self.object = bodies.object_body(task)
        self.links = shown.robot
        self.still = [*bodies.supports(task), *obstacles(task)]

    def moving(self, row: int) -> list[tuple[Body, Matrix]]:
        """Returns robot and object with their poses in the world."""
        links = zip(self.links, self.shown.link_poses[row], strict=True)
        found = [(self.object, self.shown.object_poses[row]), *links]
        return [(body, X_WB) for body, X_WB in found if body.parts]


def camera(scene: Scene, rows: Sequence[int], shape: tuple[int, int]) -> Camera:
    """Places the camera beside the robot, a little in front of it and above.

    It sees robot and object at all rows, and what is small and near them.

    Parameters
    ----------
    scene : Scene
    rows : sequence of int
        Rows that the picture must contain.
    shape : tuple of int
        Width and height of the picture.
    """
    shown = scene.shown
    points = vertices_of(placed for row in rows for placed in scene.moving(row))
    low, high = points.min(axis=0) - NEAR, points.max(axis=0) + NEAR
    for placed in (placed for placed in scene.still if placed[0].parts):
        beside = vertices_of([placed])
        is_small = np.ptp(beside, axis=0).max() < SMALL
        if is_small and (beside > low).all(axis=1).any() and (beside < high).all(axis=1).any():
            points = np.concatenate([points, beside])
    base, thing = shown.link_poses[0, 0, :3, 3], shown.object_poses[0][:3, 3]
    ahead = thing - base
    ahead[2] = 0
    ahead /= max(float(np.linalg.norm(ahead)), 1e-6)
    toward = np.array([-ahead[1], ahead[0], 0.0]) + 0.6 * ahead + np.array([0, 0, 0.5])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    eye = middle + 3.0 * toward / np.linalg.norm(toward)
    return Camera(eye, middle).fitted(points, *shape)
