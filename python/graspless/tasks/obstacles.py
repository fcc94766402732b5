# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The obstacles of a task, in every kind alike."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
from pydantic import AfterValidator

from .. import geometry
from .shapes import Obstacle, pose_matrix, regular_polygon
from .source import Source, at

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from ..frames import Matrix

    Shape = geometry.Box | geometry.Sphere | geometry.Capsule | geometry.Convex | geometry.Mesh


def _with_own_names(obstacles: list[Obstacle]) -> list[Obstacle]:
    names = [obstacle.name for obstacle in obstacles]
    if twice := {name for name in names if names.count(name) > 1}:
        raise ValueError(f"name given twice: {', '.join(sorted(twice))}")
    return obstacles


Obstacles = Annotated[list[Obstacle], AfterValidator(_with_own_names)]


def resolve_obstacles(
    obstacles: Sequence[Obstacle], source: Source, directory: Path
) -> list[Obstacle]:
    """The same obstacles with absolute paths of their meshes."""
    return [_resolved(obstacle, source, i, directory) for i, obstacle in enumerate(obstacles)]


def obstacle_meshes(obstacles: Sequence[Obstacle]) -> set[Path]:
    """The mesh files that resolved obstacles read."""
    return {Path(obstacle.mesh.file) for obstacle in obstacles if obstacle.mesh}


def placed_obstacles(
    obstacles: Sequence[Obstacle], source: Source
) -> Iterator[tuple[str, list[geometry.PlacedShape], Matrix]]:
    """Name, shapes in the body's frame B, and X_WB of each."""
    for i, obstacle in enumerate(obstacles):
        with at(source, "obstacles", i):
            placed = geometry.PlacedShape(_shape(obstacle), np.eye(4))
        yield obstacle.name, [placed], pose_matrix(obstacle.pose)


def _resolved(obstacle: Obstacle, source: Source, index: int, directory: Path) -> Obstacle:
    if obstacle.mesh is None:
        return obstacle
    path = directory / obstacle.mesh.file
    if not path.is_file():
        raise source.error(("obstacles", index, "mesh", "file"), "no such file")
    mesh = obstacle.mesh.model_copy(update={"file": str(path.resolve())})
    return obstacle.model_copy(update={"mesh": mesh})


def _shape(obstacle: Obstacle) -> Shape:
    if obstacle.box is not None:
        return geometry.Box(np.array(obstacle.box))
    if obstacle.sphere is not None:
        return geometry.Sphere(obstacle.sphere.radius)
    if obstacle.capsule is not None:
        return geometry.Capsule(obstacle.capsule.radius, obstacle.capsule.length)
    if obstacle.cylinder is not None:
        rod = obstacle.cylinder
        # A prism that holds the cylinder: FCL's own cylinders have open faults.
        ring = regular_polygon(rod.radius / np.cos(np.pi / 24), 24)
        heights = (-rod.length / 2, rod.length / 2)
        return geometry.Convex(
            np.concatenate([np.column_stack([ring, np.full(24, z)]) for z in heights])
        )
    assert obstacle.mesh is not None
    return geometry.read_mesh(obstacle.mesh.file, np.array(obstacle.mesh.scale))
