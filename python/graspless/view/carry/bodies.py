# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the hand holds, and the support that it is taken from."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ... import geometry
from ..bodies import OBJECT, TABLE, Body, placed_part
from ..surface import surface_part

if TYPE_CHECKING:
    from ...frames import Matrix
    from ...tasks import Task

SUPPORT = "support"


def object_body(task: Task) -> Body:
    """The object, in O; of a cloud the outside of its K_d."""
    parts = []
    for placed in task.problem.object.shapes:
        shape = placed.shape
        if isinstance(shape, geometry.Mesh):
            parts.append(surface_part(shape.vertices, shape.triangles, OBJECT))
        else:
            parts.append(placed_part(placed, OBJECT))
    return Body("object", parts, is_flat=task.fields.object.clasp is None)


def supports(task: Task) -> list[tuple[Body, Matrix]]:
    """The support of a slide, if the object comes from one, with its pose in the world."""
    return [
        (
            Body("table", [placed_part(p, TABLE) for p in obstacle.shapes], is_flat=True),
            np.asarray(obstacle.X_WB),
        )
        for obstacle in task.problem.obstacles
        if obstacle.name == SUPPORT and task.fields.support is not None
    ]
