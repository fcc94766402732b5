# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Outer surface of a complex K_d."""

from __future__ import annotations

from collections import defaultdict
from typing import TYPE_CHECKING, Any

import numpy as np

from .bodies import Part

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from ..frames import Matrix
    from .bodies import Color


FLAT = 0.05  # largest spread across a plane over the spread along it
SLIVER = 0.01  # least six-fold volume over the cube of the longest edge


def surface_part(points: ArrayLike, triangles: ArrayLike, color: Color) -> Part:
    """Returns the triangles of K_d that face the outside, counter-clockwise seen from there.

    Parameters
    ----------
    points : array [N, 3]
        [m].
    triangles : array [M, 3]
        Of K_d, interior ones too.
    color : tuple
    """
    p = np.asarray(points, dtype=float)
    faces = np.sort(np.asarray(triangles, dtype=np.int64).reshape(-1, 3), axis=1)
    of, fourth = _opposite_corners(p, faces)
    counts = np.bincount(of, minlength=len(faces))
    # On one tetrahedron only: the outside is the other side.
    outer, fourth = faces[of[counts[of] == 1]], fourth[counts[of] == 1]
    a, b, c = p[outer].swapaxes(0, 1)
    inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), p[fourth] - a) > 0
    outer = np.where(inward[:, None], outer[:, [0, 2, 1]], outer)
    sheets = faces[counts == 0]
    # A sheet has two sides, each with its own corners; otherwise their shades would cancel.
    back = sheets[:, [0, 2, 1]] + len(p)
    vertices = np.concatenate([p, p]) if len(sheets) else p
    shading = _normals(p, faces)
    normals = np.concatenate([shading, shading]) if len(sheets) else shading
    return Part(vertices, np.concatenate([outer, sheets, back]), color, normals)


def _normals(p: Matrix, faces: NDArray[np.int64]) -> Matrix:
    """[N, 3] across the plane nearest to the corners around each point, either way; zero where
    these lie near no plane. The slivers of a Delaunay triangulation would shade a flat side like
    gravel.
    """
    pairs = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [0, 2]]])
    pairs = np.unique(pairs, axis=0)
    a, b = np.concatenate([pairs, pairs[:, ::-1]]).T
    around = np.zeros((len(p), 3, 3))
    step = p[b] - p[a]
    lengths = np.maximum(np.einsum("ij,ij->i", step, step), 1e-18)
    np.add.at(around, a, np.einsum("ni,nj->nij", step, step) / lengths[:, None, None] ** 1.5)
    spread, axes = np.linalg.eigh(around)
    is_flat = spread[:, 0] < FLAT * spread[:, 1]  # no thin handle
    return np.where(is_flat[:, None], axes[:, :, 0], 0.0)


def _opposite_corners(
    p: Matrix, faces: NDArray[np.int64]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Fourth corners of tetrahedra whose four sides are all in K_d, and of which triangle each is.
    Flat tetrahedra, of four points of a flat side, have no inside and are left out.
    """
    rows = [tuple(face) for face in faces.tolist()]
    beside: defaultdict[Any, set[int]] = defaultdict(set)
    for a, b, c in rows:
        beside[a, b].add(c)
        beside[b, c].add(a)
        beside[a, c].add(b)
    found = [
        (i, corner)
        for i, (a, b, c) in enumerate(rows)
        for corner in beside[a, b] & beside[b, c] & beside[a, c]
    ]
    of, fourth = np.array(sorted(found), dtype=np.int64).reshape(-1, 2).T
    a, b, c = p[faces[of]].swapaxes(0, 1)
    six_volumes = np.abs(np.einsum("ij,ij->i", np.cross(b - a, c - a), p[fourth] - a))
    edges = [b - a, c - a, c - b, p[fourth] - a, p[fourth] - b, p[fourth] - c]
    longest = np.max([np.linalg.norm(edge, axis=1) for edge in edges], axis=0)
    thick = six_volumes > SLIVER * longest**3
    return of[thick], fourth[thick]
