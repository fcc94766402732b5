# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Obstacles of a task in MuJoCo."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from .. import geometry
from .shapes import add_placed

if TYPE_CHECKING:
    from ..frames import Matrix

_SKIN = 0.0005  # half thickness of a mesh [m]


def add_obstacle(spec: Any, obstacle: Any, **touch: Any) -> None:
    """Fixes a problem's obstacle to the world; `touch` is how its geoms collide."""
    for i, placed in enumerate(obstacle.shapes):
        X_WG = np.asarray(obstacle.X_WB) @ np.asarray(placed.X_BG)
        if isinstance(placed.shape, geometry.Mesh):
            _add_surface(spec, f"{obstacle.name}_{i}", placed.shape, X_WG, touch)
        else:
            fixed = geometry.PlacedShape(placed.shape, X_WG)
            add_placed(spec, spec.worldbody, fixed, **touch)


def _add_surface(
    spec: Any, name: str, mesh: geometry.Mesh, X_WG: Matrix, touch: dict[str, Any]
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
        **touch,
    )
