# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Skin and feet of a point cloud, for the physics engine."""

from __future__ import annotations

from collections import defaultdict
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from ... import geometry

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ...frames import Matrix

_DIRECTIONS = 16  # of the search for feet


def skin(surface: geometry.Complex) -> NDArray[np.int32]:
    """Returns the triangles of K_d that bound it: indices [T, 3] of its points.

    A triangle between two tetrahedra is inside and never touched. What is left is as open as K_d,
    and has no part that a convex hull would close.
    """
    triangles = np.asarray(surface.triangles)
    known = {(int(a), int(b), int(c)) for a, b, c in triangles}
    above = defaultdict(list)  # third corners of an edge's triangles, by their order
    for a, b, c in known:
        above[a, b].append(c)
    tetrahedra = dict.fromkeys(known, 0)
    for a, b in above:
        for c, d in combinations(sorted(above[a, b]), 2):
            faces = ((a, b, c), (a, b, d), (a, c, d), (b, c, d))
            if all(face in known for face in faces):
                for face in faces:
                    tetrahedra[face] += 1
    outer = [tetrahedra[int(a), int(b), int(c)] < 2 for a, b, c in triangles]
    return np.asarray(triangles[outer], dtype=np.int32)


def feet(points: Matrix, depth: float) -> Matrix | None:
    """Returns the feet that an object stands on.

    Parameters
    ----------
    points : array [N, 3]
        Of its surface, in a frame whose z is up [m].
    depth : float
        How far above its lowest point a foot may be [m].

    Returns
    -------
    array [K, 3] or None
        Corners of the least polygon around the points that are low, counter-clockwise; None where
        the points' mean is not above it, so that the object cannot stand.
    """
    low = points[points[:, 2] <= points[:, 2].min() + depth]
    angles = 2 * np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
    farthest = np.argmax(low[:, :2] @ np.array([np.cos(angles), np.sin(angles)]), axis=0)
    corners = low[[i for k, i in enumerate(farthest) if i != farthest[k - 1]]]
    try:
        polygon = geometry.Polygon(corners[:, :2])
    except ValueError:  # fewer than three corners, or all on a line
        return None
    return corners if polygon.depth(points.mean(axis=0)[:2]) > 0 else None


def inertia(points: Matrix) -> Matrix:
    """Returns the inertia [3, 3] of one kilogram spread evenly over points [N, 3] [m^2]."""
    p = points - points.mean(axis=0)
    squares = p.T @ p / len(p)
    spread: Matrix = np.trace(squares) * np.eye(3) - squares
    return spread
