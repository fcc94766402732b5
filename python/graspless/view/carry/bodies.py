# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies of a carry: the held object, and the support that it comes from."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ... import geometry
from ..bodies import OBJECT, TABLE, Body, fields_of, placed_part
from ..surface import surface_part

if TYPE_CHECKING:
    from ...frames import Matrix
    from ...tasks import Task

SUPPORT = "support"


def object_body(task: Task) -> Body:
    """Returns the object, in O; for a point cloud, its surface."""
    parts = []
    for placed in task.problem.object.shapes:
        shape = placed.shape
        if isinstance(shape, geometry.Mesh):
            parts.append(surface_part(shape.vertices, shape.triangles, OBJECT))
        else:
            parts.append(placed_part(placed, OBJECT))
    fields = fields_of(task)
    is_flat = fields is None or fields.object.clasp is None
    return Body("object", parts, is_flat=is_flat)


def supports(task: Task) -> list[tuple[Body, Matrix]]:
    """Returns the support with its pose in the world, if the object comes from a slide."""
    fields = fields_of(task)
    if fields is None:
        return []
    return [
        (
            Body("table", [placed_part(p, TABLE) for p in obstacle.shapes], is_flat=True),
            np.asarray(obstacle.X_WB),
        )
        for obstacle in task.problem.obstacles
        if obstacle.name == SUPPORT and fields.support is not None
    ]
