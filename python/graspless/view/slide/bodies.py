# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies of a slide: the table, the thin object, and the path of the fingertip."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ... import frames
from ..bodies import OBJECT, TABLE, TRAIL, Body, Color, Part, placed_part
from ..tubes import tube

if TYPE_CHECKING:
    from ... import geometry
    from ...tasks import Task
    from ..film import Film

TRAIL_WIDTH = 0.008  # [m]
CONTACT: Color = (0.84, 0.18, 0.24)
CONTACT_RADIUS = 0.012  # [m]


def table_body(task: Task) -> Body:
    """Returns the support, in S."""
    support = task.problem.support
    return Body("table", [prism(support.polygon, -support.slab, 0.0, TABLE)], is_flat=True)


def object_body(task: Task) -> Body:
    """Returns the object, in O."""
    thing = task.problem.object
    if thing.heights is not None:
        return Body("object", [_joined([placed_part(p, OBJECT) for p in thing.shapes])], True)
    return Body("object", [prism(thing.outline, 0.0, thing.thickness, OBJECT)], is_flat=True)


def _joined(parts: list[Part]) -> Part:
    """Returns parts of one colour as one."""
    counts = np.cumsum([0, *(len(part.vertices) for part in parts)])
    return Part(
        np.concatenate([part.vertices for part in parts]),
        np.concatenate([p.triangles + n for p, n in zip(parts, counts[:-1], strict=True)]),
        parts[0].color,
    )


def prism(outline: geometry.Polygon, bottom: float, top: float, color: Color) -> Part:
    """Returns the prism over a polygon between two heights [m]."""
    vertices: list[Any] = []
    triangles: list[list[int]] = []

    def add(points: Any, faces: list[list[int]]) -> None:
        triangles.extend([[i + len(vertices) for i in face] for face in faces])
        vertices.extend(points)

    for part in outline.convex_parts():
        ring = np.asarray(part.vertices)
        fan = [[0, i, i + 1] for i in range(1, len(ring) - 1)]
        add(np.column_stack([ring, np.full(len(ring), top)]), fan)
        add(np.column_stack([ring, np.full(len(ring), bottom)]), [face[::-1] for face in fan])
    ring = np.asarray(outline.vertices)
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        side = [[*a, bottom], [*b, bottom], [*b, top], [*a, top]]
        add(side, [[0, 1, 2], [0, 2, 3]])
    return Part(np.array(vertices), np.array(triangles), color)


def trail_body(shown: Film) -> Body:
    """Returns the fingertip's path of the slide as a ribbon just above the object, in the world."""
    rows = shown.rows("slide")
    problem = shown.plan.task.problem
    X_WS = np.asarray(problem.support.X_WS)
    tips_W = shown.frame(problem.hand.fingertip)[rows, :3, 3]
    tips = frames.transform(np.linalg.inv(X_WS), tips_W)
    steps = np.linalg.norm(np.diff(tips[:, :2], axis=0), axis=1)
    tips = tips[np.concatenate([[True], steps > 1e-9])] if len(tips) else tips
    if len(tips) < 2:
        return Body("trail")
    along = np.gradient(tips[:, :2], axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-12)
    across = np.column_stack([-along[:, 1], along[:, 0], np.zeros(len(along))]) * TRAIL_WIDTH / 2
    middle = np.column_stack([tips[:, :2], np.full(len(tips), problem.object.top + 0.002)])
    ribbon = np.concatenate([middle + across, middle - across])
    n = len(tips)
    i = np.arange(n - 1)
    quads = [np.stack([i, i + n, i + n + 1], axis=1), np.stack([i, i + n + 1, i + 1], axis=1)]
    part = Part(frames.transform(X_WS, ribbon), np.concatenate(quads), TRAIL)
    return Body("trail", [part])


def contact_body(shown: Film) -> Body:
    """Returns a ring around the contact point, in O.

    There the tip first touches the object, and the effective tip stays there until the lift.
    """
    rows = shown.rows("press")
    problem = shown.plan.task.problem
    top = problem.object.top
    if not len(rows):
        return Body("contact")
    tips_W = shown.frame(problem.hand.fingertip)[rows, :3, 3]
    X_WO = shown.object_poses[rows[0]]
    tips = (tips_W - X_WO[:3, 3]) @ X_WO[:3, :3]
    # Downwards: heights increase along the reversed rows.
    x, y = (np.interp(top, tips[::-1, 2], tips[::-1, k]) for k in (0, 1))
    angles = np.linspace(0, 2 * np.pi, 25)[:-1]
    ring = CONTACT_RADIUS * np.column_stack([np.cos(angles), np.sin(angles), 0 * angles])
    return Body("contact", [tube(ring + [x, y, top], 0.0015, CONTACT, closed=True)])
