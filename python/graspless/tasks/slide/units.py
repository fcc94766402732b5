# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that look like millimetres or degrees."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from .. import shapes
    from ..source import Location, Source
    from . import model

LARGEST = 2.0  # [m]; something wider than this is not slid over a table by one finger
LARGEST_SUPPORT = 5.0  # [m]


def warn_of_units(task: model.OnSupport, source: Source) -> None:
    """Warns of lengths and angles that look like millimetres or degrees."""
    for section, shape, largest in (
        ("object", task.object, LARGEST),
        ("support", task.support, LARGEST_SUPPORT),
    ):
        for field, size in _sizes(shape):
            if max(size) > largest:
                what = f"is {size[0]:.4g} x {size[1]:.4g} m; lengths are in metres"
                source.warn((section, field), what)
    for location, angle in _angles(task):
        if abs(angle) > 2 * math.pi:
            source.warn(location, "is more than a turn; angles are in radians")


def _sizes(shape: model.Object | model.Support) -> Iterator[tuple[str, tuple[float, float]]]:
    if shape.rectangle is not None:
        yield "rectangle", (shape.rectangle.size[0], shape.rectangle.size[1])
    if shape.circle is not None:
        yield "circle", (2 * shape.circle.radius, 2 * shape.circle.radius)
    if shape.polygon is not None:
        x, y = zip(*shape.polygon, strict=True)
        yield "polygon", (max(x) - min(x), max(y) - min(y))


def _angles(task: model.OnSupport) -> Iterator[tuple[Location, float]]:
    poses: list[tuple[Location, shapes.Pose | None]] = [
        (("robot", "pose"), task.robot.pose),
        (("support", "pose"), task.support.pose),
        *((("obstacles", i, "pose"), obstacle.pose) for i, obstacle in enumerate(task.obstacles)),
    ]
    for location, pose in poses:
        for i, angle in enumerate((pose and pose.rpy) or []):
            yield (*location, "rpy", i), angle
    if task.object.pose is not None:
        yield ("object", "pose", "yaw"), task.object.pose.yaw
