# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects, supports and obstacles of tasks that name a scene file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np

from .. import geometry
from ..errors import TaskError
from .obstacles import OF_SCENE
from .shapes import Obstacle, Shape
from .statement import pose_of

if TYPE_CHECKING:
    from collections.abc import Collection
    from pathlib import Path

    from ..frames import Matrix
    from ..perception import Object, Scene, Support
    from .source import Location, Source

Respect = Literal["nothing", "objects", "unseen"]
RESPECTS: tuple[Respect, ...] = get_args(Respect)
RESPECT = (
    "obstacles of the scene: nothing; objects: the other objects, and supports less than 0.5 m "
    "below; unseen: also the space that no ray reached, except behind the object itself"
)
PADDING = "distance to keep from the other objects of the scene [m]"
SLAB = 0.02  # thickness of supports as obstacles [m]
GROWN = 0.003  # mean width by which a hull that stands for an outline is larger [m]
UNSEEN = "unseen "  # begins the names of spaces that no ray reached
BELOW = 0.5  # depth at which a support, such as the floor, is in nobody's way [m]
SAME = 0.005  # difference in height of supports that may be one, which a shadow divides [m]
SUNK = 0.001  # depth of the tops of such supports, as obstacles, below what the object is on [m]


def require_scene(given: Collection[str]) -> None:
    """Raises ValueError if a field of an object is given that only one of a scene has."""
    for name in ("respect", "padding"):
        if name in given:
            raise ValueError(f"{name} is for objects of a scene")


def load(path: str, source: Source, place: Location, directory: Path) -> Scene:
    """Reads the scene file that a task names."""
    from ..perception import load_scene

    try:
        scene = load_scene(directory / path)
    except TaskError as error:
        raise source.error(place, str(error)) from None
    if not scene:
        raise source.error(place, f"nothing was found in this scene: {scene.reason}")
    return scene


def named(items: Any, name: str, source: Source, place: Location) -> Any:
    """Returns the object or support of a scene with this name."""
    for item in items:
        if item.name == name:
            return item
    names = ", ".join(item.name for item in items) or "none"
    raise source.error(place, f"the scene has no '{name}' (one of: {names})")


def real_edges(support: Support, source: Source, place: Location) -> list[int]:
    """Returns the indices of the real edges of a support."""
    edges = [i for i, label in enumerate(support.edges) if str(label) == "real"]
    if not edges:
        what = f"{support.name} of the scene has no real edge that an object could be slid over"
        raise source.error(place, f"{what}; look at the table from further away")
    return edges


def obstacles(
    scene: Scene, thing: Object, respect: str, has_support: bool, padding: float = 0.0
) -> list[Obstacle]:
    """Returns what a planner must keep clear of.

    Parameters
    ----------
    scene : Scene
    thing : Object
        Object of the task, which is none of the obstacles.
    respect : str
        What counts: see RESPECT.
    has_support : bool
        True if the support below the object counts too.
    padding : float
        Distance to keep from the other objects [m].
    """
    if respect == "nothing":
        return []
    found = [
        Obstacle(name=f"{OF_SCENE}{other.name}",
                 parts=_prisms(outline_of(other), 0.0, other.thickness),
                 pose=pose_of(other.X_WO), padding=padding)
        for other in scene.objects
        if other.name != thing.name
    ]  # fmt: skip
    own = next(support for support in scene.supports if support.name == thing.support)
    for support in scene.supports:
        if support.name == own.name and not has_support:
            continue
        above = float(own.X_WS[:3, 2] @ (support.X_WS[:3, 3] - own.X_WS[:3, 3]))
        if above < -BELOW:
            continue
        found.append(slab(support, 0.0 if abs(above) > SAME else -SUNK - max(above, 0.0)))
    if respect == "unseen":
        spaces = [space for space in scene.unseen if space.behind != thing.name]
        found += [
            Obstacle(name=f"{UNSEEN}{i}", convex=np.asarray(space.vertices).tolist())
            for i, space in enumerate(spaces)
        ]
    return found


def slab(support: Support, top: float = 0.0) -> Obstacle:
    """Returns a support as an obstacle; `top` is the height of its upper face in S [m]."""
    parts = _prisms(support.polygon, top - SLAB, top)
    return Obstacle(name=f"{OF_SCENE}{support.name}", parts=parts, pose=pose_of(support.X_WS))


def is_of_scene(name: str) -> bool:
    """Returns True if an obstacle is called as those from a scene are."""
    return name.startswith(OF_SCENE)


def outline_of(other: Object) -> Matrix:
    """Returns the outline of an obstacle: its convex hull if this is hardly larger.

    Noisy outlines fall into dozens of convex parts, each of which is tested for collisions.
    """
    from .chain.lying import convex_hull

    outline = np.asarray(other.outline)
    hull = convex_hull(outline)
    added = geometry.Polygon(hull).area - geometry.Polygon(outline).area
    around = float(np.linalg.norm(hull - np.roll(hull, 1, axis=0), axis=1).sum())
    return hull if added <= GROWN * around else outline


def _prisms(corners: Matrix, low: float, high: float) -> list[Shape]:
    """Returns prisms over the convex parts of a polygon."""
    return [
        Shape(convex=[[float(x), float(y), z] for z in (low, high) for x, y in part.vertices])
        for part in geometry.Polygon(corners).convex_parts()
    ]


def planar_pose(X_WS: Matrix, X_WO: Matrix) -> dict[str, float]:
    """Returns x, y and yaw of an object on its support."""
    X_SO = np.asarray(np.linalg.inv(X_WS) @ X_WO)
    x, y, yaw = X_SO[0, 3], X_SO[1, 3], np.arctan2(X_SO[1, 0], X_SO[0, 0])
    return {"x": float(x), "y": float(y), "yaw": float(yaw)}
