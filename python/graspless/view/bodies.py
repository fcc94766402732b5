# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies to draw: coloured triangles in the frame of a body."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames, geometry
from .._xml import origin, parse
from ..errors import TaskError
from ..tasks.meshes import prepare_meshes
from ..tasks.robots import robot_meshes
from .visuals import UnreadableError, read_visual, warn_once

if TYPE_CHECKING:
    import xml.etree.ElementTree as ET
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from .._core.robot import Robot
    from ..frames import Matrix
    from ..tasks import Task
    from ..tasks.robots import Robot as RobotFields

Color = tuple[float, float, float]

ARM: Color = (0.78, 0.79, 0.80)
OBJECT: Color = (0.95, 0.65, 0.15)
TABLE: Color = (0.80, 0.72, 0.60)
OBSTACLE: Color = (0.45, 0.55, 0.68)
TRAIL: Color = (0.78, 0.10, 0.32)
WIDE = 1.5  # from here on, an obstacle need not fit into a picture [m]
FINGER: Color = (0.22, 0.58, 1.00)
LOOP: Color = (0.10, 0.55, 0.60)
GHOST: Color = (0.35, 0.55, 0.95)


@dataclass
class Part:
    """Triangles of one colour.

    Attributes
    ----------
    vertices : array [V, 3]
        In the body's frame [m].
    triangles : array [T, 3]
        Rows of vertex indices, counter-clockwise seen from outside.
    color : tuple
        Red, green, blue, each 0 to 1.
    normals : array [V, 3] or None
        Normals for shading, of either sign; None: those of the triangles.
    """

    vertices: Matrix
    triangles: NDArray[np.int64]
    color: Color
    normals: Matrix | None = None


@dataclass
class Body:
    """Parts that move together; a flat body is shaded by face."""

    name: str
    parts: list[Part] = field(default_factory=list)
    is_flat: bool = False


def fields_of(task: Task) -> Any:
    """Returns the fields of a task file; None if no file can express the problem."""
    try:
        return task.fields
    except TaskError:
        return None


def robot_bodies(robot: Robot, fields: RobotFields | None) -> list[Body]:
    """Returns one body per link, in the order of Robot.frame_names: its visuals, or its shapes."""
    names = list(robot.frame_names)
    bodies = [Body(name) for name in names]
    text = (fields and fields.urdf_text) or "<robot/>"
    root = parse(text)
    palette = {
        material.get("name", ""): _color(material)
        for material in root.iter("material")
        if material.find("color") is not None
    }
    if fields is not None:
        prepare_meshes(robot_meshes(fields))
    drawn = set()
    for link in root.findall("link"):
        name = link.get("name", "")
        try:
            for visual in link.findall("visual"):
                assert fields is not None
                bodies[names.index(name)].parts += _visual_parts(visual, palette, fields)
                drawn.add(name)
        except UnreadableError as error:
            # Only the look is lost: the plan and its check use the collision shapes.
            bodies[names.index(name)].parts.clear()
            drawn.discard(name)
            warn_once(f"{name}: drawn by its collision shapes: {error}")
    for index, placed in robot.shapes:
        if names[index] not in drawn:
            bodies[index].parts.append(placed_part(placed, ARM))
    return bodies


def robot(task: Task) -> list[Body]:
    """Returns one body per link of the task's robot, in the order of Robot.frame_names."""
    fields = fields_of(task)
    mine = task.problem.robot if task.arm is None else task.arm.robot
    return robot_bodies(mine, fields and fields.robot)


def vertices_of(placed: Iterable[tuple[Body, Matrix]]) -> Matrix:
    """Returns the vertices of bodies with their poses in the world, [N, 3] there."""
    return np.concatenate(
        [frames.transform(X_WB, part.vertices) for body, X_WB in placed for part in body.parts]
    )


def without_wide(placed: Iterable[tuple[Body, Matrix]]) -> list[tuple[Body, Matrix]]:
    """Returns placed bodies without floors and walls, which a picture may cut off."""
    return [one for one in placed if np.ptp(vertices_of([one]), axis=0).max() < WIDE]


def obstacles(task: Task) -> list[tuple[Body, Matrix]]:
    """Returns the obstacles with their poses in the world, without the support of a carry."""
    fields, known = fields_of(task), task.problem.obstacles
    count = len(known) if fields is None else len(fields.obstacles or ())  # a support comes last
    return [
        (Body(o.name, [placed_part(placed, OBSTACLE) for placed in o.shapes]), np.asarray(o.X_WB))
        for o in known[:count]
    ]


def placed_part(placed: geometry.PlacedShape, color: Color) -> Part:
    """Returns a collision shape in its body's frame."""
    import trimesh

    shape: Any = placed.shape
    if isinstance(shape, geometry.Box):
        mesh = trimesh.creation.box(shape.size)
    elif isinstance(shape, geometry.Sphere):
        mesh = trimesh.creation.uv_sphere(shape.radius, count=(13, 24))
    elif isinstance(shape, geometry.Capsule):
        mesh = _capsule(shape.radius, shape.length)
    elif isinstance(shape, geometry.Mesh):
        mesh = trimesh.Trimesh(shape.vertices, shape.triangles, process=False)
    else:
        mesh = trimesh.Trimesh(shape.vertices).convex_hull
    return _part(mesh, np.asarray(placed.X_BG), color)


def _visual_parts(visual: ET.Element, palette: dict[str, Color], robot: RobotFields) -> list[Part]:
    import trimesh

    shape = visual.find("geometry/*")
    if shape is None:
        return []
    mesh: Any
    material = visual.find("material")
    color = ARM
    if material is not None:
        named = palette.get(material.get("name", ""), ARM)
        color = _color(material) if material.find("color") is not None else named
    if shape.tag == "box":
        mesh = trimesh.creation.box(_numbers(shape.get("size"), [1, 1, 1]))
    elif shape.tag == "sphere":
        mesh = trimesh.creation.uv_sphere(float(shape.get("radius", 1)), count=(13, 24))
    elif shape.tag == "cylinder":
        mesh = _cylinder(float(shape.get("radius", 1)), float(shape.get("length", 1)))
    elif shape.tag == "capsule":
        mesh = _capsule(float(shape.get("radius", 1)), float(shape.get("length", 1)))
    else:
        mesh = read_visual(shape.get("filename", ""), robot)
        mesh.apply_scale(_numbers(shape.get("scale"), [1, 1, 1]))
    return [_part(mesh, origin(visual), color)]


def _capsule(radius: float, length: float) -> Any:
    import trimesh

    mesh = trimesh.creation.capsule(height=length, radius=radius, count=(12, 24))
    mesh.apply_translation([0, 0, -mesh.bounds.mean(axis=0)[2]])
    return mesh


def _cylinder(radius: float, length: float) -> Any:
    """Returns a cylinder around the circle, so that spheres at its ends show no edges."""
    import trimesh

    sides = 24
    return trimesh.creation.cylinder(radius / np.cos(np.pi / sides), length, sections=sides)


def _part(mesh: Any, X_BG: Matrix, color: Color) -> Part:
    vertices, triangles = _split_edges(
        np.asarray(mesh.vertices, dtype=float), np.asarray(mesh.faces, dtype=np.int64)
    )
    return Part(frames.transform(X_BG, vertices), triangles, color)


def _split_edges(p: Matrix, f: NDArray[np.int64]) -> tuple[Matrix, NDArray[np.int64]]:
    """Splits the corners at sharp edges, so that shading does not round them off."""
    areas = np.cross(p[f[:, 1]] - p[f[:, 0]], p[f[:, 2]] - p[f[:, 0]])
    smooth = np.zeros_like(p)
    for k in range(3):
        np.add.at(smooth, f[:, k], areas)
    lengths = np.linalg.norm(smooth[f], axis=2) * np.linalg.norm(areas, axis=1)[:, None]
    sharp = np.einsum("fkj,fj->fk", smooth[f], areas) < 0.8 * lengths
    triangles = f.copy()
    triangles[sharp] = len(p) + np.arange(np.count_nonzero(sharp))
    return np.concatenate([p, p[f[sharp]]]), triangles


def _color(material: ET.Element) -> Color:
    color = material.find("color")
    rgba = _numbers(None if color is None else color.get("rgba"), [*ARM, 1])
    return rgba[0], rgba[1], rgba[2]


def _numbers(text: str | None, default: list[float]) -> list[float]:
    return default if text is None else [float(word) for word in text.split()]
