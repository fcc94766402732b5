# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects made of parts, as meshes: where no folder of meshes is given."""

from __future__ import annotations

import numpy as np

from graspless import frames, geometry

from ..clasp import shapes

LARGEST = 0.35  # extent of an object that fits on the table [m]


def by_name() -> dict[str, shapes.Shape]:
    """Returns all objects."""
    return {shape.name: shape for shape in shapes.with_holes() + shapes.without_holes()}


def small() -> dict[str, geometry.Mesh]:
    """Returns the objects that fit on the table."""
    meshes = {name: mesh_of(shape) for name, shape in by_name().items()}
    return {name: mesh for name, mesh in meshes.items() if _extent(mesh) < LARGEST}


def mesh_of(shape: shapes.Shape) -> geometry.Mesh:
    """Returns the parts of an object as one mesh, which intersects itself where they overlap."""
    vertices, triangles, count = [], [], 0
    for part in shape.parts:
        points, corners = _triangles(part.shape)
        vertices.append(frames.transform(np.asarray(part.X_BG), points))
        triangles.append(corners + count)
        count += len(points)
    return geometry.Mesh(np.concatenate(vertices), np.concatenate(triangles).astype(np.int32))


def _triangles(shape: object) -> tuple[frames.Matrix, frames.Matrix]:
    import trimesh

    if isinstance(shape, geometry.Mesh):
        return np.asarray(shape.vertices), np.asarray(shape.triangles)
    if isinstance(shape, geometry.Box):
        solid = trimesh.creation.box(shape.size)
    elif isinstance(shape, geometry.Sphere):
        solid = trimesh.creation.icosphere(3, shape.radius)
    elif isinstance(shape, geometry.Capsule):
        solid = trimesh.creation.capsule(shape.length, shape.radius, count=[12, 16])
        solid.apply_translation([0, 0, -solid.bounds.mean(axis=0)[2]])
    else:
        raise TypeError(f"no triangles of {type(shape).__name__}")
    return np.asarray(solid.vertices), np.asarray(solid.faces)


def _extent(mesh: geometry.Mesh) -> float:
    points = np.asarray(mesh.vertices)
    return float((points.max(axis=0) - points.min(axis=0)).max())
