# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes, supports, outlines, and the loops through the holes of a cloud. Lengths in metres.

>>> from graspless.geometry import shortest_loops  # points: (N, 3)
>>> for loop in shortest_loops(points).loops:  # doctest: +SKIP
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
    Loop,
    LoopOptions,
    Loops,
    LoopStatus,
    Mesh,
    PlacedShape,
    Plateau,
    Polygon,
    PreparedLoop,
    Sphere,
    VirtualLinking,
    clasp_targets,
    gauss_linking,
    linking_number,
    outline,
    read_mesh,
    sample_grid,
    sample_surface,
    shortest_loops,
    spacing,
    thin,
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
    "Loop",
    "LoopOptions",
    "LoopStatus",
    "Loops",
    "Mesh",
    "PlacedShape",
    "Plateau",
    "Polygon",
    "PreparedLoop",
    "Sphere",
    "VirtualLinking",
    "clasp_targets",
    "gauss_linking",
    "linking_number",
    "outline",
    "read_mesh",
    "sample_grid",
    "sample_surface",
    "shortest_loops",
    "spacing",
    "thin",
    "virtual_linking",
    "virtual_linking_gradient",
    "visible_points",
]


def __dir__() -> list[str]:
    return __all__
