# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Obstacles of tasks in MuJoCo."""

from __future__ import annotations

from typing import Any

import numpy as np

from .. import geometry
from .shapes import add_placed, add_skin

_PREFIX = "obstacle "  # of geoms and skins, whose names must not be those of others


def plain(name: str) -> str:
    """Returns the name of the obstacle of which a geom or a skin has this name."""
    return name.removeprefix(_PREFIX).rpartition(" ")[0]


def add_obstacle(spec: Any, obstacle: Any, skin: float, **touch: Any) -> None:
    """Adds an obstacle of a problem, fixed to the world.

    `skin` is half the thickness of meshes [m]; `touch` are the contact parameters of its geoms.
    """
    for i, placed in enumerate(obstacle.shapes):
        X_WG = np.asarray(obstacle.X_WB) @ np.asarray(placed.X_BG)
        if isinstance(placed.shape, geometry.Mesh):
            p_W = np.asarray(placed.shape.vertices) @ X_WG[:3, :3].T + X_WG[:3, 3]
            name, triangles = f"{_PREFIX}{obstacle.name} {i}", placed.shape.triangles
            add_skin(spec, name, "world", p_W, triangles, skin, **touch)
        else:
            fixed = geometry.PlacedShape(placed.shape, X_WG)
            add_placed(spec, spec.worldbody, fixed, name=f"{_PREFIX}{obstacle.name} {i}", **touch)
