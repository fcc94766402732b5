# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Convex parts of the meshes of a robot.

MuJoCo puts its convex hull in the place of a mesh. The hull of a bent or waisted link of an arm
reaches far beyond the link, and touches a table that the planner, which tests the mesh itself,
rightly finds free. The hull of a hooked finger fills the room in which an object is to be held.
Slices of the link have hulls that keep to it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames, geometry
from .shapes import add_hull

if TYPE_CHECKING:
    from collections.abc import Collection

    from ..frames import Matrix
    from ..robot import Robot

REPLACED = 4  # group of geoms that touch nothing, because others are in their place
_THICKNESS = 0.03  # of a slice [m]
_MOST = 16
_FLAT = 1e-5  # [m]


def slice_links(spec: Any, robot: Robot, whole: Collection[str]) -> None:
    """Replaces the meshes of links that are not convex by convex slices, except of `whole`."""
    meshes: dict[int, list[Any]] = {}
    for link, placed in robot.shapes:
        meshes.setdefault(link, []).append(placed)
    for link, shapes in meshes.items():
        name = robot.frame_names[link]
        if name in whole or not all(isinstance(s.shape, geometry.Mesh) for s in shapes):
            continue
        body = spec.body(name)
        for geom in list(body.geoms):
            geom.contype = geom.conaffinity = 0
            geom.group = REPLACED
        for placed in shapes:
            for points in slices(np.array(placed.shape.vertices), placed.shape.triangles):
                add_hull(spec, body, frames.transform(placed.X_BG, points), {})


def slices(vertices: Matrix, triangles: Any) -> list[Matrix]:
    """Cuts a surface across its longest side; returns the corners of each slice.

    Parameters
    ----------
    vertices : (N, 3) ndarray
        Corners of the surface [m].
    triangles : (M, 3) array_like of int
        Indices of vertices.

    Returns
    -------
    list of (K, 3) ndarray
        The convex hulls of these points cover the surface. One that would be flat is widened by
        its neighbours.
    """
    axis = int(np.argmax(np.ptp(vertices, axis=0)))
    low, high = vertices[:, axis].min(), vertices[:, axis].max()
    count = int(np.clip(np.ceil((high - low) / _THICKNESS), 1, _MOST))
    cuts = np.linspace(low, high, count + 1)
    parts: list[Matrix] = []
    first = 0
    for last in range(1, count + 1):
        points = _between(vertices, np.asarray(triangles), axis, cuts[first], cuts[last])
        if not _is_flat(points):
            parts.append(points)
            first = last
    if first < count:  # a flat end
        return [vertices] if not parts else [*parts[:-1], np.vstack([parts[-1], points])]
    return parts


def _between(vertices: Matrix, triangles: Any, axis: int, low: float, high: float) -> Matrix:
    """Returns the corners of the part of a surface between two planes."""
    along = vertices[:, axis]
    points = [vertices[(along >= low) & (along <= high)]]
    ends = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    start, step = along[ends[:, 0]], along[ends[:, 1]] - along[ends[:, 0]]
    for cut in (low, high):
        crossing = (np.minimum(start, start + step) < cut) & (cut < np.maximum(start, start + step))
        t = ((cut - start[crossing]) / step[crossing])[:, None]
        a, b = vertices[ends[crossing, 0]], vertices[ends[crossing, 1]]
        points.append(a + t * (b - a))
    return np.vstack(points)


def _is_flat(points: Matrix) -> bool:
    if len(points) < 4:
        return True
    return bool(np.linalg.svd(points - points.mean(axis=0), compute_uv=False)[2] < _FLAT)
