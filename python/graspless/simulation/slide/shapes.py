# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Polygons and shapes of a task as MuJoCo's geoms."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames
from ..shapes import add_hull

if TYPE_CHECKING:
    from ...frames import Matrix

_SQUARE = 1e-9  # how far a rectangle's corners may be from square [m^2]


def add_prism(
    spec: Any, body: Any, polygon: Any, heights: tuple[float, float], **given: Any
) -> Any:
    """Adds a geom over a convex polygon: a box if that is a rectangle, else a mesh.

    Parameters
    ----------
    spec, body : MjSpec, MjsBody
    polygon : geometry.Polygon
        Convex, in the body's frame.
    heights : (float, float)
        Of underside and top in that frame [m].
    **given
        Other attributes of the geom.
    """
    corners = np.array(polygon.vertices)
    middle = sum(heights) / 2
    a, b = corners[1] - corners[0], corners[-1] - corners[0]
    is_parallelogram = len(corners) == 4 and np.allclose(corners[2], corners[0] + a + b, atol=1e-9)
    if is_parallelogram and abs(a @ b) < _SQUARE:
        yaw = float(np.arctan2(a[1], a[0]))
        size = [np.hypot(*a) / 2, np.hypot(*b) / 2, (heights[1] - heights[0]) / 2]
        pos = [*corners.mean(axis=0), middle]
        quat = frames.to_quaternion(frames.planar(0, 0, yaw))
        return body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=size, pos=pos, quat=quat, **given)
    points = np.concatenate([np.column_stack([corners, np.full(len(corners), z)]) for z in heights])
    return add_hull(spec, body, points, given)


def even_points(polygon: Any, count: int) -> Matrix:
    """[N, 2] about `count` points of equal share of a polygon's area, on a square lattice."""
    spacing = float(np.sqrt(polygon.area / count))
    corners = np.array(polygon.vertices)
    low, high = corners.min(axis=0), corners.max(axis=0)
    cells = np.maximum(np.round((high - low) / spacing).astype(int), 1)
    parts = zip(low, high, cells, strict=True)
    axes = [a + (np.arange(n) + 0.5) * (b - a) / n for a, b, n in parts]
    points = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 2)
    inside = np.array([point for point in points if polygon.contains(point)])
    return inside if len(inside) >= 3 else corners


def points_along(polygon: Any, spacing: float) -> Matrix:
    """[N, 2] the corners of a polygon and points between them, at most `spacing` apart [m]."""
    corners = np.array(polygon.vertices)
    points: list[Matrix] = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        pieces = max(1, int(np.ceil(np.hypot(*(b - a)) / spacing)))
        points.extend(a + (b - a) * i / pieces for i in range(pieces))
    return np.array(points)


def plate_inertia(polygon: Any, thickness: float, mass: float) -> Matrix:
    """[3, 3] of a plate of even density about its own centre of mass [kg m^2]."""
    p = np.array(polygon.vertices)
    q = np.roll(p, -1, axis=0)
    cross = p[:, 0] * q[:, 1] - q[:, 0] * p[:, 1]
    area = cross.sum() / 2
    center = ((p + q) * cross[:, None]).sum(axis=0) / (6 * area)
    # Second moments of the triangles with the origin: integrals of x x^T.
    second = sum(
        c / 24 * (np.outer(a + b, a + b) + np.outer(a, a) + np.outer(b, b))
        for a, b, c in zip(p, q, cross, strict=True)
    ) / area - np.outer(center, center)
    J = np.zeros((3, 3))
    J[:2, :2], J[2, 2] = second, thickness**2 / 12
    inertia: Matrix = mass * (np.trace(J) * np.eye(3) - J)
    return inertia
