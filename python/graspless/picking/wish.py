# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The object that shall be picked up, and the robot, in the words of task files."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import geometry
from .._arguments import require_path
from ..errors import TaskError, should_be
from ..perception import Scene
from ..tasks import scenes
from ..tasks.documents import rows_of
from ..tasks.rays import rays_fields
from ..tasks.robot_files import resolve_robot
from ..tasks.robots import Robot, build_robot
from ..tasks.shapes import MOST_PADDING, Fields
from ..tasks.source import Source
from ..tasks.statement import pose_fields
from .obstacles import documents
from .result import FILE

if TYPE_CHECKING:
    from .. import robot as robots
    from ..frames import Matrix
    from ..perception import Object, Support


COM_CELL = 0.005  # of the heights by which the centre of mass is found [m]
CLOCKS = 1.0  # difference of the clocks of camera and planner that is allowed [s]


class RobotOnly(Fields):
    """A document with a robot."""

    robot: Robot


@dataclass(frozen=True)
class Wish:
    """An object of a scene, and the robot that shall pick it up.

    Attributes
    ----------
    thing, support : Object, Support
        The object, and what it stands on.
    others : list of Object
        All other objects of the scene.
    supports : list of Support
        All supports of the scene.
    robot : dict
        Field `robot` of a task file.
    lift : float
        Height of the lift [m].
    mass : float or None
        [kg].
    grip_force : float or None
        Force of each finger that pinches, if not that of the hand's effort limits [N].
    beside, around : list of dict
        Obstacles of a task that has the support, and of one that needs it as an obstacle.
    trust : bool
        Let xacro files of the robot read any file and run code.
    padding : float
        Distance to keep from the other objects [m].
    """

    thing: Object
    support: Support
    others: list[Object]
    supports: list[Support]
    robot: dict[str, Any]
    lift: float
    mass: float | None
    grip_force: float | None
    beside: list[dict[str, Any]]
    around: list[dict[str, Any]]
    trust: bool = False
    padding: float = 0.0

    @property
    def room(self) -> float:
        """Distance to other objects that their padding takes, which their hulls exceed [m]."""
        return 1.26 * self.padding

    @property
    def name(self) -> str:
        """Name of the object."""
        return str(self.thing.name)

    @cached_property
    def outline(self) -> geometry.Polygon:
        """Outline of the object in O [m]."""
        return geometry.Polygon(self.thing.outline)

    @cached_property
    def model(self) -> robots.Robot:
        """The robot itself."""
        return robot_of(self.robot, FILE, trust=self.trust)

    @cached_property
    def com(self) -> list[float]:
        """Centre of mass in O, if the object is solid below what the cameras saw of it [m]."""
        seen = _seen(self, COM_CELL)
        heights = np.asarray(seen.heights)
        cells = np.indices(heights.shape) + 0.5
        middle = np.asarray(seen.corner) + COM_CELL * np.average(
            cells.reshape(2, -1), axis=1, weights=heights.ravel()
        )
        height = float((heights**2).sum() / heights.sum()) / 2
        return [round(float(value), 4) for value in (*middle, height)]

    @property
    def real_edges(self) -> list[int]:
        """Indices of the edges of the support beyond which there is nothing."""
        return [i for i, label in enumerate(self.support.edges) if str(label) == "real"]


def robot_of(given: dict[str, Any], file: str, *, trust: bool = False) -> robots.Robot:
    """Returns the robot of a field `robot`. `file` is named in errors."""
    source = Source(file, {"robot": given}, is_trusted=trust)
    fields = source.validate(RobotOnly).robot
    return build_robot(resolve_robot(fields, source, Path.cwd())[0], source, warn=False)


def wish_of(
    scene: Scene,
    file: str,
    name: str,
    robot: Any,
    *,
    lift: float,
    respect: str,
    mass: float | None,
    padding: float = 0.0,
    obstacles: Sequence[dict[str, Any]] = (),
    grip_force: float | None = None,
    trust: bool = False,
) -> Wish:
    """Returns what is asked for. Raises TaskError if there is no such object. `file` is named."""
    if not 0 < lift < 10:
        raise TaskError(f"lift: {lift!r}: should be a height in (0, 10) m")
    if not 0 <= padding <= MOST_PADDING:
        raise TaskError(f"padding: {padding!r}: should be a distance in [0, {MOST_PADDING}] m")
    if mass is not None and not 0 < mass < 1e6:
        raise TaskError(f"mass: {mass!r}: should be a mass in (0, 1e6) kg")
    if grip_force is not None and not 0 < grip_force <= 1000:
        raise TaskError(f"grip_force: {grip_force!r}: should be a force in (0, 1000] N")
    if respect not in scenes.RESPECTS:
        raise TaskError(f"respect: {respect}: {should_be(respect, scenes.RESPECTS)}")
    source = Source(file, {"name": name})
    thing = scenes.named(scene.objects, name, source, ("name",))
    support = scenes.named(scene.supports, thing.support, source, ("name",))

    def seen(*, has_support: bool) -> list[dict[str, Any]]:
        return documents(scenes.obstacles(scene, thing, respect, has_support, padding))

    fields = dict(robot) if isinstance(robot, Mapping) else {"urdf": str(robot)}
    return Wish(
        thing=thing,
        support=support,
        others=[other for other in scene.objects if other.name != name],
        supports=list(scene.supports),
        robot=fields,
        lift=float(lift),
        mass=mass,
        grip_force=grip_force,
        beside=[*obstacles, *seen(has_support=False)],
        around=[*obstacles, *seen(has_support=True)],
        trust=trust,
        padding=padding,
    )


def object_fields(wish: Wish, smooth: float = 0.0) -> dict[str, Any]:
    """Returns the object of a slide or a pinch; `smooth` is the tolerance of its outline [m]."""
    outline = np.asarray(wish.thing.outline)
    place = scenes.planar_pose(wish.support.X_WS, wish.thing.X_WO)
    return {
        "name": wish.name,
        "polygon": rows_of(simplified(outline, smooth) if smooth > 0 else outline),
        "thickness": float(wish.thing.thickness),
        "pose": place,
        "com": wish.com,
        **({} if wish.mass is None else {"mass": wish.mass}),
    }


def heights_fields(wish: Wish, cell: float) -> dict[str, Any]:
    """Returns the heights of an object as the cameras measured them, in cells of a side [m]."""
    seen, top = _seen(wish, cell), float(wish.thing.thickness)
    rows, undersides = (
        np.round(np.asarray(values), 4).clip(max=top).tolist()
        for values in (seen.heights, seen.undersides)
    )
    return {
        "corner": [float(value) for value in seen.corner],
        "cell": cell,
        "rows": rows,
        "undersides": undersides,
    }


def _seen(wish: Wish, cell: float) -> geometry.HeightMap:
    """Returns the heights of an object as the cameras measured them."""
    thing = wish.thing
    top = float(thing.thickness)
    return geometry.seen_heights(thing.points, thing.rays, wish.outline, top, cell)


def support_fields(support: Support, edges: list[int] | None) -> dict[str, Any]:
    """Returns the support of a slide or a pinch."""
    given: dict[str, Any] = {
        "polygon": rows_of(support.polygon),
        "pose": pose_fields(support.X_WS),
    }
    return given if edges is None else given | {"usable_edges": edges}


def cloud_fields(wish: Wish) -> dict[str, Any]:
    """Returns the object of a clasp."""
    return {
        "name": wish.name,
        "points": rows_of(wish.thing.points),
        "pose": pose_fields(wish.thing.X_WO),
        "rays": [rays_fields(image) for image in wish.thing.rays],
        **({} if wish.mass is None else {"mass": wish.mass}),
    }


def stale(scene: Scene, max_age: float) -> str:
    """Says why a scene is too old, or nothing."""
    if not 0 < max_age < float("inf"):
        raise TaskError(f"max_age: {max_age!r}: should be an age in (0, inf) s")
    if scene.stamp is None:
        return f"nobody noted when its images were taken; at most {max_age:g} s ago is allowed"
    age = time.time() - scene.stamp
    if age < -CLOCKS:
        return f"its images were taken {-age:.1f} s in the future: the clocks differ"
    if not age <= max_age:
        return f"its images were taken {age:.1f} s ago, at most {max_age:g} s are allowed"
    return ""


def read_scene(scene: Any) -> tuple[Scene, str]:
    """Returns a scene with an object, and what to call it. Raises TaskError if there is nothing."""
    from ..perception import load_scene

    if isinstance(scene, Scene):
        file = "scene"
    else:
        file = str(require_path("scene", scene, "a graspless.perception.Scene"))
        scene = load_scene(file)
    if not scene:
        raise TaskError(f"{file}: nothing was found in this scene: {scene.reason}")
    if not scene.objects:
        raise TaskError(f"{file}: no object was found in this scene: {scene.reason}")
    return scene, file


def simplified(ring: Matrix, tolerance: float) -> Matrix:
    """Returns corners [M, 2] of a ring [N, 2] such that the others are within `tolerance` [m].

    By Douglas and Peucker. A ring that would cross itself is returned as it is.
    """
    first = int(np.argmax(np.linalg.norm(ring - ring.mean(axis=0), axis=1)))
    turned = np.roll(ring, -first, axis=0)
    far = int(np.argmax(np.linalg.norm(turned - turned[0], axis=1)))
    closed = np.vstack([turned, turned[:1]])
    kept = [*_kept(closed, 0, far, tolerance), *_kept(closed, far, len(ring), tolerance)]
    found: Matrix = closed[kept]
    try:
        geometry.Polygon(found)
    except ValueError:
        return ring
    return found


def _kept(line: Matrix, first: int, last: int, tolerance: float) -> list[int]:
    """Returns the rows of a line from `first` to before `last` that are kept."""
    along = line[last] - line[first]
    off = line[first : last + 1] - line[first]
    away = np.abs(along[0] * off[:, 1] - along[1] * off[:, 0]) / max(np.linalg.norm(along), 1e-12)
    k = first + int(np.argmax(away))
    if away[k - first] <= tolerance:
        return [first]
    return [*_kept(line, first, k, tolerance), *_kept(line, k, last, tolerance)]


def distance_to(p: np.ndarray, a: np.ndarray, b: np.ndarray) -> float:
    """Returns the distance of a point from the segment between two others [m]."""
    along = b - a
    t = np.clip((p - a) @ along / max(float(along @ along), 1e-12), 0, 1)
    return float(np.linalg.norm(p - a - t * along))


def dense(ring: np.ndarray, spacing: float) -> np.ndarray:
    """Returns points [N, 2] along a closed ring, at most `spacing` apart [m]."""
    pieces = []
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / spacing)))
        pieces.append(a + (b - a) * np.arange(count)[:, None] / count)
    return np.concatenate(pieces)
