# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Obstacles of a task in MuJoCo."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames, geometry

if TYPE_CHECKING:
    from ...frames import Matrix

_SKIN = 0.0005  # half thickness of a mesh [m]


def add_obstacle(spec: Any, obstacle: Any, **fields: Any) -> None:
    """Fixes a clasp.Obstacle to the world; `fields` are its geoms' own."""
    for i, placed in enumerate(obstacle.shapes):
        X_WG = np.asarray(obstacle.X_WB) @ np.asarray(placed.X_BG)
        name = f"{obstacle.name}_{i}"
        if isinstance(placed.shape, geometry.Mesh):
            _add_surface(spec, name, placed.shape, X_WG, fields)
            continue
        kind = _shape(spec, name, placed.shape)
        pose = {"pos": X_WG[:3, 3], "quat": frames.to_quaternion(X_WG)}
        spec.worldbody.add_geom(name=name, **pose, **kind, **fields)


def _add_surface(
    spec: Any, name: str, mesh: geometry.Mesh, X_WG: Matrix, fields: dict[str, Any]
) -> None:
    """A mesh as it is: MuJoCo would fill it to its convex hull."""
    vertices = np.asarray(mesh.vertices) @ X_WG[:3, :3].T + X_WG[:3, 3]
    spec.add_flex(
        name=name,
        dim=2,
        radius=_SKIN,
        vertbody=["world"],
        vert=vertices.ravel().tolist(),
        elem=np.asarray(mesh.triangles).ravel().tolist(),
        selfcollide=mujoco.mjtFlexSelf.mjFLEXSELF_NONE,
        **fields,
    )


def _shape(spec: Any, name: str, shape: Any) -> dict[str, Any]:
    """Type and size of a convex shape."""
    if isinstance(shape, geometry.Box):
        return {"type": mujoco.mjtGeom.mjGEOM_BOX, "size": shape.size / 2}
    if isinstance(shape, geometry.Sphere):
        return {"type": mujoco.mjtGeom.mjGEOM_SPHERE, "size": [shape.radius, 0, 0]}
    if isinstance(shape, geometry.Capsule):
        size = [shape.radius, shape.length / 2, 0]
        return {"type": mujoco.mjtGeom.mjGEOM_CAPSULE, "size": size}
    spec.add_mesh(name=name, uservert=np.asarray(shape.vertices).ravel().tolist())
    return {"type": mujoco.mjtGeom.mjGEOM_MESH, "meshname": name}
