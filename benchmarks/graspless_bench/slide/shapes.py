# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frozen tables and objects of the slide experiments. All results depend on them.

Fig. 7 and 9 of the paper show them without dimensions. We chose dimensions that look like the
figures and lie within the WAM's reach. Lengths in metres; tables in the WAM's base frame,
objects in a frame of their own.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

Points = list[tuple[float, float]]


def regular(radius: float, corners: int, center: tuple[float, float] = (0, 0)) -> Points:
    """Returns a regular polygon."""
    angles = [2 * math.pi * i / corners for i in range(corners)]
    return [(center[0] + radius * math.cos(a), center[1] + radius * math.sin(a)) for a in angles]


def _box(x0: float, y0: float, x1: float, y1: float) -> Points:
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def _crescent(outer: float, inner: float, shift: float, pieces: int = 24) -> Points:
    """Returns a disc without another disc, whose centre is `shift` to the right."""
    x = (shift**2 + outer**2 - inner**2) / (2 * shift)
    y = math.sqrt(outer**2 - x**2)
    a, b = math.atan2(y, x), math.atan2(y, x - shift)
    out = [a + (2 * math.pi - 2 * a) * i / pieces for i in range(pieces + 1)]
    back = [2 * math.pi - b - (2 * math.pi - 2 * b) * i / pieces for i in range(1, pieces)]
    points = [(outer * math.cos(t), outer * math.sin(t)) for t in out]
    return points + [(shift + inner * math.cos(t), inner * math.sin(t)) for t in back]


def _centimetres(*corners: tuple[float, float]) -> Points:
    return [(x / 100, y / 100) for x, y in corners]


TABLES: dict[str, Points] = {
    "square": _box(0.30, -0.35, 1.00, 0.35),
    "round": regular(0.35, 100, (0.65, 0)),  # 100 edge points, as in the paper
    "triangle": [(0.30, -0.45), (0.98, 0), (0.30, 0.45)],
    "long": _box(0.35, -0.60, 0.75, 0.60),
}

_SIDE = 0.13
OBJECTS: dict[str, Points] = {
    "square": _box(-0.05, -0.05, 0.05, 0.05),
    "circle": regular(0.055, 48),
    "triangle": [
        (0, _SIDE / math.sqrt(3)),
        (-_SIDE / 2, -_SIDE / 2 / math.sqrt(3)),
        (_SIDE / 2, -_SIDE / 2 / math.sqrt(3)),
    ],
    "crescent": _crescent(0.07, 0.055, 0.03),
    "irregular": _centimetres(
        *((-5.5, -2), (-2, -5), (3, -3.5), (5.5, -1), (3, 2)),
        *((4, 5), (-1, 4), (-3.5, 4.5), (-4, 1)),
    ),
}

LETTERS: dict[str, Points] = {  # 10 cm high; an outline has no hole, so the A's counter is filled
    "Y": _centimetres(
        *((-1.2, -5), (1.2, -5), (1.2, -0.5), (4.5, 5), (1.7, 5)),
        *((0, 2), (-1.7, 5), (-4.5, 5), (-1.2, -0.5)),
    ),
    "A": _centimetres(
        *((-4.5, -5), (-2, -5), (-1.2, -2.4), (1.2, -2.4), (2, -5)),
        *((4.5, -5), (1.4, 5), (-1.4, 5)),
    ),
    "L": _centimetres((-3, -5), (3.5, -5), (3.5, -2.6), (-0.6, -2.6), (-0.6, 5), (-3, 5)),
    "E": _centimetres(
        *((-3.3, -5), (3.3, -5), (3.3, -2.8), (-0.9, -2.8), (-0.9, -1.1), (2.5, -1.1)),
        *((2.5, 1.1), (-0.9, 1.1), (-0.9, 2.8), (3.3, 2.8), (3.3, 5), (-3.3, 5)),
    ),
}

THICKNESS = 0.005  # of all objects: plastic plates


def outline_of(name: str, scale: float = 1) -> Points:
    """Returns the outline of an object or letter."""
    shape: Sequence[tuple[float, float]] = OBJECTS.get(name) or LETTERS[name]
    return [(scale * x, scale * y) for x, y in shape]
