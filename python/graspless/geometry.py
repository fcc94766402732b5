# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes, supports and outlines. Lengths in metres."""

from ._core.geometry import (
    Band,
    Box,
    Capsule,
    Convex,
    Edge,
    Mesh,
    PlacedShape,
    Polygon,
    Sphere,
    outline,
    read_mesh,
    sample_grid,
)

__all__ = [
    "Band",
    "Box",
    "Capsule",
    "Convex",
    "Edge",
    "Mesh",
    "PlacedShape",
    "Polygon",
    "Sphere",
    "outline",
    "read_mesh",
    "sample_grid",
]
