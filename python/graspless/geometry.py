# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes, polygons, point clouds, linking numbers, and loops through the holes of a cloud.

Lengths are in metres. Points are rows: (N, 3), or (N, 2) in a plane.

>>> from graspless.geometry import shortest_loops  # points: (N, 3)
>>> for loop in shortest_loops(points).found:  # doctest: +SKIP
...     print(loop.length, loop.points)
"""

from ._core.geometry import (
    Band,
    BettiCurve,
    Box,
    Capsule,
    ClaspTarget,
    Complex,
    Convex,
    Edge,
    Filtration,
    HeightMap,
    Loop,
    LoopOptions,
    Loops,
    LoopStatus,
    Mesh,
    PlacedShape,
    Plateau,
    Polygon,
    PreparedLoop,
    RayImage,
    Sphere,
    VirtualLinking,
    clasp_targets,
    columns,
    downsample,
    gauss_linking,
    linking_number,
    outline,
    rays_from_viewpoints,
    read_mesh,
    sample_grid,
    sample_surface,
    seen_heights,
    shortest_loops,
    spacing,
    virtual_linking,
    virtual_linking_gradient,
    visible_points,
)

__all__ = [
    "Band",
    "BettiCurve",
    "Box",
    "Capsule",
    "ClaspTarget",
    "Complex",
    "Convex",
    "Edge",
    "Filtration",
    "HeightMap",
    "Loop",
    "LoopOptions",
    "LoopStatus",
    "Loops",
    "Mesh",
    "PlacedShape",
    "Plateau",
    "Polygon",
    "PreparedLoop",
    "RayImage",
    "Sphere",
    "VirtualLinking",
    "clasp_targets",
    "columns",
    "downsample",
    "gauss_linking",
    "linking_number",
    "outline",
    "rays_from_viewpoints",
    "read_mesh",
    "sample_grid",
    "sample_surface",
    "seen_heights",
    "shortest_loops",
    "spacing",
    "virtual_linking",
    "virtual_linking_gradient",
    "visible_points",
]


def __dir__() -> list[str]:
    return __all__
