# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Obstacles of tasks in MuJoCo."""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from .. import frames, geometry
from .shapes import add_placed, add_skin

OBSTACLE = "obstacle"


def numbered(obstacle: Any, number: int, what: str = OBSTACLE) -> str:
    """Returns a name for a body, a geom or a skin of an obstacle, which no other has."""
    return f"{what} {number} {obstacle.name}"


def plain(name: str) -> str:
    """Returns the name of the obstacle that is in a `numbered` name; other names as they are."""
    found = re.fullmatch(r"\w+ \d+ (.*)", name)
    return found[1] if found else name


def add_obstacle(spec: Any, obstacle: Any, skin: float, **touch: Any) -> None:
    """Adds an obstacle of a problem, fixed to the world.

    `skin` is half the thickness of meshes [m]; `touch` are the contact parameters of its geoms.
    """
    for i, placed in enumerate(obstacle.shapes):
        name = numbered(obstacle, i)
        X_WG = np.asarray(obstacle.X_WB) @ np.asarray(placed.X_BG)
        if isinstance(placed.shape, geometry.Mesh):
            p_W = frames.transform(X_WG, placed.shape.vertices)
            add_skin(
                spec, numbered(obstacle, i), "world", p_W, placed.shape.triangles, skin, **touch
            )
        else:
            fixed = geometry.PlacedShape(placed.shape, X_WG)
            add_placed(spec, spec.worldbody, fixed, name=name, **touch)
