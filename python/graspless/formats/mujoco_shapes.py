# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes of a task as geoms with names of their own."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np

from .. import frames, geometry
from ..simulation.shapes import add_placed


def add_shape(spec: Any, body: Any, name: str, placed: Any, **given: Any) -> None:
    """Adds a geom. A mesh is drawn as it is and collides as its convex hull."""
    if not isinstance(placed.shape, geometry.Mesh):
        add_placed(spec, body, placed, name=name, **given)
        return
    mesh = spec.add_mesh(name=name, uservert=np.asarray(placed.shape.vertices).ravel().tolist())
    mesh.userface = np.asarray(placed.shape.triangles).ravel().tolist()
    X_BG = np.asarray(placed.X_BG)
    given |= {"name": name, "pos": X_BG[:3, 3], "quat": frames.to_quaternion(X_BG)}
    body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, **given)
