# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Obstacles of a task, the same for all kinds."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
from pydantic import AfterValidator

from .. import collision, geometry
from ..files import absence
from .meshes import require_fetched
from .shapes import MeshFile, Obstacle, Shape, given_twice, pose_matrix, regular_polygon
from .source import Source, at

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix
    from .source import Location

    AnyShape = geometry.Box | geometry.Sphere | geometry.Capsule | geometry.Convex | geometry.Mesh


def _with_own_names(obstacles: list[Obstacle]) -> list[Obstacle]:
    if twice := given_twice(obstacle.name for obstacle in obstacles):
        raise ValueError(f"name given twice: {twice}")
    return obstacles


OF_SCENE = "scene "  # begins the names of obstacles from scenes
SMALLEST, LARGEST = 1e-3, 20.0  # longest side of a mesh that nobody doubts [m]

Obstacles = Annotated[list[Obstacle], AfterValidator(_with_own_names)]


def resolve_obstacles(
    obstacles: Sequence[Obstacle], source: Source, directory: Path
) -> list[Obstacle]:
    """Returns the obstacles with absolute paths of their meshes."""
    return [_resolved(obstacle, source, i, directory) for i, obstacle in enumerate(obstacles)]


def obstacle_meshes(obstacles: Sequence[Obstacle]) -> set[Path]:
    """Returns the mesh files of resolved obstacles."""
    shapes = [shape for body in obstacles for shape in (body, *(body.parts or ()))]
    return {Path(shape.mesh.file) for shape in shapes if shape.mesh}


def build_obstacles(obstacles: Sequence[Obstacle], source: Source) -> list[collision.Obstacle]:
    """Returns the obstacles of resolved fields."""
    built = []
    for i, obstacle in enumerate(obstacles):
        with at(source, "obstacles", i):
            shapes = obstacle.parts or [obstacle]
            parts = placed_parts(shapes, alone=not obstacle.parts)
        for k, (shape, part) in enumerate(zip(shapes, parts, strict=True)):
            if shape.mesh is not None and isinstance(part.shape, geometry.Mesh):
                inner = ("parts", k) if obstacle.parts else ()
                size = np.ptp(np.asarray(part.shape.vertices), axis=0)
                _warn_of_size(size, ("obstacles", i, *inner, "mesh"), source)
        pose = pose_matrix(obstacle.pose)
        built.append(collision.Obstacle(obstacle.name, parts, pose, obstacle.padding))
    return built


def placed_parts(parts: Sequence[Shape], alone: bool = False) -> list[geometry.PlacedShape]:
    """Returns the parts of a body in its frame. If `alone`, the only part is at the origin."""
    return [
        geometry.PlacedShape(_shape(part), np.eye(4) if alone else pose_matrix(part.pose))
        for part in parts
    ]


def _warn_of_size(size: Matrix, place: Location, source: Source) -> None:
    """Warns of the sides [3] of a mesh that look like another unit than metres."""
    what = f"is {size[0]:.4g} x {size[1]:.4g} x {size[2]:.4g} m; lengths are in metres"
    if size.max() > LARGEST:
        source.warn(place, f"{what}; of a mesh in millimetres write 'unit: mm'")
    elif size.max() < SMALLEST:
        source.warn(place, f"{what}; of a mesh in metres write no scale and no unit")


def _resolved(obstacle: Obstacle, source: Source, index: int, directory: Path) -> Obstacle:
    place = ("obstacles", index)
    update: dict[str, object] = {"mesh": _mesh(obstacle, source, place, directory)}
    if obstacle.parts is not None:
        update["parts"] = [
            part.model_copy(update={"mesh": _mesh(part, source, (*place, "parts", k), directory)})
            for k, part in enumerate(obstacle.parts)
        ]
    return obstacle.model_copy(update=update)


def _mesh(shape: Shape, source: Source, place: Location, directory: Path) -> MeshFile | None:
    """Returns the absolute path of the shape's mesh file."""
    if shape.mesh is None:
        return None
    path = directory / shape.mesh.file
    if not path.is_file():
        raise source.error((*place, "mesh", "file"), absence(path))
    return shape.mesh.model_copy(update={"file": str(path.resolve())})


def _shape(shape: Shape) -> AnyShape:
    if shape.box is not None:
        return geometry.Box(np.array(shape.box))
    if shape.sphere is not None:
        return geometry.Sphere(shape.sphere.radius)
    if shape.capsule is not None:
        return geometry.Capsule(shape.capsule.radius, shape.capsule.length)
    if shape.convex is not None:
        return geometry.Convex(np.array(shape.convex))
    if shape.vertices is not None:
        return geometry.Mesh(np.array(shape.vertices), np.array(shape.triangles))
    if shape.cylinder is not None:
        rod = shape.cylinder
        # A prism that holds the cylinder: FCL's own cylinders have open faults.
        ring = regular_polygon(rod.radius / np.cos(np.pi / 24), 24)
        heights = (-rod.length / 2, rod.length / 2)
        return geometry.Convex(
            np.concatenate([np.column_stack([ring, np.full(24, z)]) for z in heights])
        )
    assert shape.mesh is not None
    require_fetched([Path(shape.mesh.file)])
    return geometry.read_mesh(shape.mesh.file, shape.mesh.factors)
