# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points on the collision shapes of a robot's links."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import collision, frames, geometry

if TYPE_CHECKING:
    from .._core.robot import Robot
    from ..frames import Matrix

CORNER = 0.002  # a corner of a curve may be this far outside the shapes [m]
LARGEST = 5.0  # of a shape of a robot [m]
CORNERS = np.array(list(product((-0.5, 0.5), repeat=3)))


def _sphere(rings: int = 24) -> Matrix:
    """Returns points on the unit sphere: meridians and parallels, so that mirror images match."""
    polar, around = (a.ravel() for a in np.meshgrid(
        np.linspace(0, np.pi, rings + 1), np.arange(2 * rings) * np.pi / rings
    ))  # fmt: skip
    r = np.sin(polar)
    return np.column_stack([r * np.cos(around), r * np.sin(around), np.cos(polar)])


SPHERE = _sphere()


def shape_points(shape: Any) -> Matrix:
    """Returns points of a shape; (N, 3) in its frame [m].

    Their convex hull is that of the shape; of a sphere or capsule it is inscribed.
    """
    if isinstance(shape, geometry.Box):
        return np.asarray(CORNERS * shape.size)
    if isinstance(shape, geometry.Sphere):
        return np.asarray(SPHERE * shape.radius)
    if isinstance(shape, geometry.Capsule):
        ends = np.sign(SPHERE[:, 2:]) * [0, 0, shape.length / 2]
        return np.asarray(SPHERE * shape.radius + ends)
    vertices = np.asarray(shape.vertices)
    return np.unique(np.round(vertices, 6), axis=0)


def link_points(robot: Robot) -> dict[int, Matrix]:
    """Returns the points of each link with collision shapes, in the link's frame [m]."""
    parts: dict[int, list[Matrix]] = {}
    for link, placed in robot.shapes:
        points = frames.transform(np.asarray(placed.X_BG), shape_points(placed.shape))
        parts.setdefault(link, []).append(points)
    return {link: np.vstack(points) for link, points in parts.items()}


def is_inside(robot: Robot, link: str, p_L: Matrix) -> bool:
    """True if a point is in a shape of a link, or the link has shapes that are only surfaces."""
    shapes = [placed for index, placed in robot.shapes if robot.frame_names[index] == link]
    if not shapes or any(isinstance(placed.shape, geometry.Mesh) for placed in shapes):
        return True
    world = collision.World()
    world.add_body("link", shapes)
    point = geometry.PlacedShape(geometry.Sphere(CORNER), frames.translation(p_L))
    world.add_pair("link", world.add_body("corner", [point]))
    return world.collides()


def large_shapes(robot: Robot) -> list[tuple[str, Matrix, bool]]:
    """Returns the shapes longer than LARGEST: their links, sizes [3] and True of meshes."""
    found = []
    for link, placed in robot.shapes:
        size = np.ptp(shape_points(placed.shape), axis=0)
        if size.max() > LARGEST:
            is_mesh = isinstance(placed.shape, (geometry.Convex, geometry.Mesh))
            found.append((robot.frame_names[link], size, is_mesh))
    return found
