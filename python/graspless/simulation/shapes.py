# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes of a task as MuJoCo's geoms."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from .. import frames, geometry

if TYPE_CHECKING:
    from ..frames import Matrix


def add_placed(spec: Any, body: Any, placed: geometry.PlacedShape, **given: Any) -> Any:
    """A geom of a shape in the body's frame; a mesh stands for its convex hull."""
    shape, X_BG = placed.shape, np.array(placed.X_BG)
    pose = {"pos": X_BG[:3, 3], "quat": frames.to_quaternion(X_BG)}
    if isinstance(shape, geometry.Box):
        size = (np.array(shape.size) / 2).tolist()
        return body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=size, **pose, **given)
    if isinstance(shape, geometry.Sphere):
        size = [shape.radius, 0, 0]
        return body.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=size, **pose, **given)
    if isinstance(shape, geometry.Capsule):
        size = [shape.radius, shape.length / 2, 0]
        return body.add_geom(type=mujoco.mjtGeom.mjGEOM_CAPSULE, size=size, **pose, **given)
    points = np.array(shape.vertices) @ X_BG[:3, :3].T + X_BG[:3, 3]
    return add_hull(spec, body, points, given)


def add_hull(spec: Any, body: Any, points: Matrix, given: dict[str, Any]) -> Any:
    """A geom over points [N, 3] in the body's frame: their convex hull."""
    name = f"hull{len(spec.meshes)}"
    spec.add_mesh(name=name, uservert=points.ravel().tolist())
    return body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, **given)
