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


def add_obstacle(spec: Any, obstacle: Any, skin: float, **touch: Any) -> None:
    """Fixes a problem's obstacle to the world: `skin` is half the thickness of a mesh [m], `touch`
    how its geoms collide.
    """
    for i, placed in enumerate(obstacle.shapes):
        X_WG = np.asarray(obstacle.X_WB) @ np.asarray(placed.X_BG)
        if isinstance(placed.shape, geometry.Mesh):
            _add_surface(spec, f"{obstacle.name}_{i}", placed.shape, X_WG, skin, touch)
        else:
            fixed = geometry.PlacedShape(placed.shape, X_WG)
            add_placed(spec, spec.worldbody, fixed, **touch)


def _add_surface(
    spec: Any, name: str, mesh: geometry.Mesh, X_WG: Matrix, skin: float, touch: dict[str, Any]
) -> None:
    """A mesh as it is: MuJoCo would fill it to its convex hull."""
    vertices = np.asarray(mesh.vertices) @ X_WG[:3, :3].T + X_WG[:3, 3]
    spec.add_flex(
        name=name,
        dim=2,
        radius=skin,
        vertbody=["world"],
        vert=vertices.ravel().tolist(),
        elem=np.asarray(mesh.triangles).ravel().tolist(),
        selfcollide=mujoco.mjtFlexSelf.mjFLEXSELF_NONE,
        **touch,
    )
