# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Signs that the cameras saw only a part of an object."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import geometry
from ..tasks.chain.lying import convex_hull
from .wish import simplified

if TYPE_CHECKING:
    from .wish import Wish


def covered(wish: Wish) -> str:
    """Says what lies over the object."""
    own = wish.outline
    for other in wish.others:
        if other.support != wish.thing.support:
            continue
        X_OO = np.linalg.inv(wish.thing.X_WO) @ other.X_WO
        ring = np.asarray(other.outline) @ X_OO[:2, :2].T + X_OO[:2, 3]
        if _overlap(own, geometry.Polygon(ring)):
            return f"'{other.name}' overlaps it seen from above: it lies over it, under it or in it"
    return ""


def _overlap(a: geometry.Polygon, b: geometry.Polygon) -> bool:
    """Returns True if a point well within one outline lies in the other."""
    for one, other in ((a, b), (b, a)):
        inner = np.asarray(one.vertices)
        inner = inner + 0.2 * (np.asarray(one.centroid) - inner)
        if any(one.contains(p) and other.contains(p) for p in inner):
            return True
    return False


def cut_off(wish: Wish) -> str:
    """Says that the sides of the outline are not all sides of the object."""
    if wish.thing.touches_border:
        return "the image cuts it off: a finger could be inside the rest of it; move the camera"
    return ""


def warnings_of(wish: Wish) -> list[str]:
    """Returns the warnings of the scene about the object, where it is cut off with their reason."""
    cut = cut_off(wish)
    if not cut:
        return list(wish.thing.warnings)
    told = cut.partition(":")[0]
    return [cut, *(text for text in wish.thing.warnings if not text.startswith(told))]


def sliver(wish: Wish, smooth: float) -> str:
    """Says that the centre of mass of what was seen is beside the outline.

    `smooth` is the tolerance of the outline [m].
    """
    hull = geometry.Polygon(convex_hull(simplified(np.asarray(wish.thing.outline), smooth)))
    if hull.contains(wish.com[:2]):
        return ""
    return (
        "most of it is hidden: its outline is only a sliver of what was seen; add a view from "
        "another side"
    )
