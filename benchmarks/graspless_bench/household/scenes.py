# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A thing on a table before a robot, others beside it, and what depth cameras see of them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial import ConvexHull

from graspless import frames, geometry, perception
from graspless.simulation.slide.shapes import points_along
from graspless.simulation.slide.truth import Body, Truth

from . import things

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from graspless.frames import Matrix

CENTER = (0.65, 0.0)  # of the table [m]; its top is in z = 0 of the robot's base
SLAB = 0.04  # thickness of the table [m]
FLOOR_POSE = frames.translation([0.65, 0.0, -0.75])
EYES = ((-0.05, 0.0, 0.75), (1.35, 0.0, 0.75))  # of the cameras: at the base, and opposite [m]
ROOM = 0.12  # half width of the square in which objects are placed [m]
MARGIN = 0.02  # between an object and the edge of the table [m]
GAP = (0.03, 0.15)  # least distance between objects, and the largest of a neighbour [m]
STEP = 0.01  # between points of a border [m]
TRIES = 300  # of places
_CIRCLE = np.linspace(0, 2 * math.pi, 48, endpoint=False)
TABLES = {
    "square": np.array([[-0.35, -0.35], [0.35, -0.35], [0.35, 0.35], [-0.35, 0.35]]),
    "round": 0.38 * np.column_stack([np.cos(_CIRCLE), np.sin(_CIRCLE)]),
    "L": np.array(
        [[-0.35, -0.35], [0.35, -0.35], [0.35, 0.35], [-0.05, 0.35], [-0.05, -0.05], [-0.35, -0.05]]
    ),
}  # corners, counterclockwise [m]


@dataclass(frozen=True)
class Placed:
    """A thing in a pose X_WT [4, 4] in the world."""

    thing: things.Thing
    X_WT: Matrix

    @property
    def points(self) -> Matrix:
        """Vertices [N, 3] in the world [m]."""
        return frames.transform(self.X_WT, np.asarray(self.thing.mesh.vertices))

    @property
    def body(self) -> Body:
        """Its convex parts in the world."""
        return self.thing.body.moved(self.X_WT)

    @property
    def surface(self) -> perception.Body:
        """Its mesh, as cameras see it."""
        shape = geometry.Mesh(self.thing.mesh.vertices, self.thing.mesh.faces)
        return perception.Body([geometry.PlacedShape(shape)], self.X_WT)

    @property
    def border(self) -> Matrix:
        """Points [N, 2] around the convex hull of its projection onto the table [m]."""
        flat = self.points[:, :2]
        return points_along(geometry.Polygon(flat[ConvexHull(flat).vertices]), STEP)


@dataclass(frozen=True)
class Setting:
    """A table, a thing on it, and others around that.

    Attributes
    ----------
    table : array [N, 2]
        Corners, counterclockwise, in the world [m].
    target : Placed
    others : list of Placed
    """

    table: Matrix
    target: Placed
    others: list[Placed]


def setting(
    table: Matrix,
    thing: things.Thing,
    others: Sequence[things.Thing],
    rng: np.random.Generator,
) -> Setting | None:
    """Lets a thing come to rest at a random place of a table, and others beside it.

    Those for which there is no room are left out. Returns None if there is none for the thing.

    Parameters
    ----------
    table : array [N, 2]
        Corners in a frame at CENTER; it is turned by a random quarter.
    thing : Thing
    others : sequence of Thing
    rng : Generator
    """
    turned = frames.planar(*CENTER, float(rng.integers(4)) * math.pi / 2)
    corners = table @ turned[:2, :2].T + turned[:2, 3]
    ground = geometry.Polygon(corners)
    target = _placed(thing, np.array(CENTER), ROOM, ground, [], rng)
    if target is None:
        return None
    around: list[Placed] = []
    for other in others:
        middle = target.border.mean(axis=0)
        reach = _radius(target.border) + np.linalg.norm(other.mesh.extents) / 2 + GAP[1]
        found = _placed(other, middle, float(reach), ground, [target, *around], rng)
        around += [] if found is None else [found]
    return Setting(corners, target, around)


def _placed(
    thing: things.Thing,
    center: Matrix,
    room: float,
    ground: geometry.Polygon,
    others: Sequence[Placed],
    rng: np.random.Generator,
) -> Placed | None:
    """Returns a thing at rest within a square [m] of a table, beside the first of the others."""
    yaw = rng.uniform(0, 2 * math.pi)
    turned = Placed(thing, frames.planar(0.0, 0.0, yaw) @ things.dropped(thing, rng))
    border = turned.border
    middle = (border.min(axis=0) + border.max(axis=0)) / 2
    taken = [other.border for other in others]
    for _ in range(TRIES):
        shift = center + rng.uniform(-room, room, size=2) - middle
        own = border + shift
        if min(ground.depth(p) for p in own) < MARGIN or not _fits(own, taken):
            continue
        return Placed(thing, frames.translation([*shift, 0.0]) @ turned.X_WT)
    return None


def _fits(border: Matrix, others: Sequence[Matrix]) -> bool:
    """Returns True if a border is near the first of others, and clear of all."""
    gaps = [_gap(border, other) for other in others]
    return all(gap > GAP[0] for gap in gaps) and all(gap < GAP[1] for gap in gaps[:1])


def _gap(a: Matrix, b: Matrix) -> float:
    """Returns the distance of two borders, 0 if one lies in the other [m]."""
    for one, other in ((a, b), (b, a)):
        if geometry.Polygon(one).contains(other[0]):
            return 0.0
    return float(np.linalg.norm(a[:, None] - b[None], axis=2).min())


def _radius(border: Matrix) -> float:
    return float(np.linalg.norm(border - border.mean(axis=0), axis=1).max())


def seen(given: Setting, seed: int, views: int) -> perception.Scene:
    """Returns what noisy depth cameras see of a table: the first `views` of EYES."""
    looked = [rendered(given, eye, (*CENTER, 0.0), seed + i) for i, eye in enumerate(EYES[:views])]
    depth, X_WC = ([getattr(frame, name) for frame in looked] for name in ("depth", "X_WC"))
    return perception.perceive(depth, looked[0].K, X_WC)


def rendered(
    given: Setting,
    eye: ArrayLike,
    at: ArrayLike,
    seed: int = 1,
    noise: perception.Noise | None = None,
) -> perception.Frame:
    """Returns what a depth camera sees that looks from one point [3] at another [m]."""
    bodies = [
        perception.Body([geometry.PlacedShape(geometry.Box([6, 6, 0.02]))], FLOOR_POSE),
        perception.Body([_slab(part) for part in geometry.Polygon(given.table).convex_parts()]),
        *(item.surface for item in (given.target, *given.others)),
    ]
    return perception.render(bodies, perception.look_at(eye, at), noise=noise, seed=seed)


def _slab(part: geometry.Polygon) -> geometry.PlacedShape:
    """Returns the prism of a convex part of a table, under z = 0."""
    corners = np.array(part.vertices)
    levels = [np.column_stack([corners, np.full(len(corners), z)]) for z in (-SLAB, 0.0)]
    return geometry.PlacedShape(geometry.Convex(np.concatenate(levels)))


def nearest(scene: perception.Scene, target: Placed) -> perception.Object | None:
    """Returns the object of a scene that is where a thing is, if there is one."""
    low, high = target.points.min(axis=0)[:2], target.points.max(axis=0)[:2]
    for found in sorted(scene.objects, key=lambda item: -len(item.points)):
        ring = np.asarray(found.outline) @ found.X_WO[:2, :2].T + found.X_WO[:2, 3]
        middle = (ring.min(axis=0) + ring.max(axis=0)) / 2
        if (middle > low - 0.01).all() and (middle < high + 0.01).all():
            return found
    return None


def truth(given: Setting, X_WO: Matrix) -> Truth:
    """Returns the things, the target in the frame O in which a plan has put its object."""
    target = given.target.body.moved(np.asarray(np.linalg.inv(X_WO)))
    return Truth(target, [item.body for item in given.others])
