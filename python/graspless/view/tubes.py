# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tubes and spheres, for lines and points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .bodies import Part

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..frames import Matrix
    from .bodies import Color


def tube(points: ArrayLike, radius: float, color: Color, closed: bool = False) -> Part:
    """Returns a tube along a polyline [N, 3], with open ends."""
    p = np.asarray(points, dtype=float)
    if closed:
        p = np.concatenate([p, p[:1]])
    p = p[np.concatenate([[True], np.linalg.norm(np.diff(p, axis=0), axis=1) > 1e-9])]
    if len(p) < 2:
        return Part(np.empty((0, 3)), np.empty((0, 3), dtype=np.int64), color)
    sides = 10
    angles = 2 * np.pi * np.arange(sides) / sides
    rings = [
        center + radius * (np.outer(np.cos(angles), x) + np.outer(np.sin(angles), y))
        for center, (x, y) in zip(p, _frames(p, closed), strict=True)
    ]
    i, k = np.meshgrid(np.arange(len(p) - 1), np.arange(sides), indexing="ij")
    a, b = i * sides + k, i * sides + (k + 1) % sides
    quads = [np.stack([a, b, b + sides], axis=-1), np.stack([a, b + sides, a + sides], axis=-1)]
    return Part(np.concatenate(rings), np.concatenate(quads).reshape(-1, 3), color)


def ball(center: ArrayLike, radius: float, color: Color) -> Part:
    """Returns a small sphere."""
    import trimesh

    mesh: Any = trimesh.creation.uv_sphere(radius, count=(9, 14))
    return Part(np.asarray(mesh.vertices) + np.asarray(center), np.asarray(mesh.faces), color)


def smooth(points: ArrayLike) -> Matrix:
    """Returns a smoothed closed polyline, for drawing only."""
    p = np.asarray(points, dtype=float)
    for _ in range(2):
        p = 0.25 * np.roll(p, 1, axis=0) + 0.5 * p + 0.25 * np.roll(p, -1, axis=0)
    return p


def _frames(p: Matrix, closed: bool) -> list[tuple[Matrix, Matrix]]:
    """Returns two directions across the line at each corner, with the least twist."""
    steps = np.diff(p, axis=0)
    steps /= np.linalg.norm(steps, axis=1, keepdims=True)
    first = steps[0] + steps[-1] if closed else steps[0]
    last = first if closed else steps[-1]
    along = np.concatenate([first[None], steps[:-1] + steps[1:], last[None]])
    x = np.cross(steps[0], [1.0, 0.0, 0.0] if abs(steps[0][0]) < 0.9 else [0.0, 1.0, 0.0])
    found = []
    for direction in along:
        length = float(np.linalg.norm(direction))
        t = direction / length if length > 1e-6 else steps[0]
        x = x - (x @ t) * t
        x = x / max(float(np.linalg.norm(x)), 1e-9)
        found.append((x, np.cross(t, x)))
    return found
