# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which loops run around a hole of a mesh, by straight lines that pass it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import geometry, perception

if TYPE_CHECKING:
    from graspless.frames import Matrix

DIRECTIONS = 128
PIXELS = 240  # of an image
FEWEST = 9  # pixels of an opening
ALL = 0.9  # share of an opening's pixels inside a loop that runs around it
DISTANCE = 20.0  # of the cameras, relative to the mesh's radius


class Openings:
    """Places where one sees through a mesh, from all sides.

    A free line that a loop winds around proves that the loop cannot be drawn together on the
    object. Openings that no straight line passes are not known.
    """

    def __init__(self, mesh: geometry.Mesh) -> None:
        body = perception.Body([geometry.PlacedShape(mesh)], np.eye(4))
        points = np.asarray(mesh.vertices)
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        radius = float(np.linalg.norm(points - middle, axis=1).max())
        camera = perception.Camera(PIXELS, PIXELS, 2 * np.arctan(1.05 / DISTANCE))
        self._K = camera.K
        self._views: list[tuple[Any, list[Any]]] = []
        for towards in _directions():
            X_WC = perception.look_at(middle + DISTANCE * radius * towards, middle)
            free = np.asarray(perception.cast_rays([body], X_WC, camera).label) < 0
            if regions := _enclosed(free):
                self._views.append((np.linalg.inv(X_WC), regions))

    def has(self, loop: Matrix) -> bool:
        """Returns true if a loop [n, 3], in the mesh's frame, runs around an opening."""
        from matplotlib.path import Path

        for X_CW, regions in self._views:
            p_C = loop @ X_CW[:3, :3].T + X_CW[:3, 3]
            pixels = p_C[:, :2] / p_C[:, 2:] * np.diag(self._K)[:2] + self._K[:2, 2]
            ring = Path(np.concatenate([pixels, pixels[:1]]))
            if any(ring.contains_points(region).mean() >= ALL for region in regions):
                return True
        return False


def _directions() -> Matrix:
    """Returns directions spread evenly over half a sphere: lines have two ends."""
    i = np.arange(DIRECTIONS)
    z = (i + 0.5) / DIRECTIONS
    angle = np.pi * (1 + 5**0.5) * i
    across = np.sqrt(1 - z * z)
    rows: Matrix = np.column_stack([across * np.cos(angle), across * np.sin(angle), z])
    return rows


def _enclosed(free: Any) -> list[Any]:
    """Returns the pixels [n, 2], as u and v, of each free region away from the border."""
    from scipy import ndimage

    labels, count = ndimage.label(free)
    border = {*labels[0], *labels[-1], *labels[:, 0], *labels[:, -1]}
    regions = []
    for label in set(range(1, count + 1)) - border:
        v, u = np.nonzero(labels == label)
        if len(u) >= FEWEST:
            regions.append(np.column_stack([u, v]).astype(float))
    return regions
