# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sizes that look like millimetres."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ..source import Source
    from . import model

LARGEST = 2.0  # [m]; something wider than this is not slid over a table by one finger
LARGEST_SUPPORT = 5.0  # [m]


def warn_of_sizes(task: model.OnSupport, source: Source) -> None:
    """Warns of an object and a support that look like millimetres."""
    for section, shape, largest in (
        ("object", task.object, LARGEST),
        ("support", task.support, LARGEST_SUPPORT),
    ):
        for field, size in _sizes(shape):
            if max(size) > largest:
                what = f"is {size[0]:.4g} x {size[1]:.4g} m; lengths are in metres"
                source.warn((section, field), what)
    if (task.object.thickness or 0.0) > LARGEST:
        what = f"is {task.object.thickness:.4g} m; lengths are in metres"
        source.warn(("object", "thickness"), what)


def _sizes(shape: model.Object | model.Support) -> Iterator[tuple[str, tuple[float, float]]]:
    if shape.rectangle is not None:
        yield "rectangle", (shape.rectangle.size[0], shape.rectangle.size[1])
    if shape.circle is not None:
        yield "circle", (2 * shape.circle.radius, 2 * shape.circle.radius)
    if shape.polygon is not None:
        x, y = zip(*shape.polygon, strict=True)
        yield "polygon", (max(x) - min(x), max(y) - min(y))
