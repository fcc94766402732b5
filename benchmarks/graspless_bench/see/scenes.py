# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes with one object on a table over a floor, and the truth about them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import frames, geometry, perception

if TYPE_CHECKING:
    from pathlib import Path

    from graspless.frames import Matrix

HEIGHT = 0.4  # of the table [m]
SIZE = (0.7, 0.6)  # of the table [m]
SLAB = 0.03  # [m]
FAR = 20.0  # height of the camera that sees the silhouette [m]
SUFFIXES = (".stl", ".obj", ".off", ".ply")


@dataclass(frozen=True)
class Shot:
    """A scene and the poses of the cameras that look at it."""

    bodies: list[perception.Body]
    cameras: list[Matrix]
    thickness: float  # height of the object's highest point above the table [m]
    silhouette: Any  # bool [n, n]: projection of the object onto the table, without holes
    places: Matrix  # [n, n, 2] of the silhouette's pixels in the world [m]


def meshes(folder: Path) -> list[Path]:
    """Returns the meshes of a folder."""
    return sorted(path for path in folder.iterdir() if path.suffix.lower() in SUFFIXES)


def lying(read: geometry.Mesh) -> geometry.Mesh:
    """Returns a mesh that lies on the plane z = 0 with the side on which it rests best: the faces
    of its hull that have one direction, within 3 degrees, and the largest area.
    """
    import trimesh

    hull = trimesh.Trimesh(read.vertices, read.triangles).convex_hull
    normals, areas = np.asarray(hull.face_normals), np.asarray(hull.area_faces)
    is_alike = normals @ normals.T > math.cos(math.radians(3))
    down = normals[int(np.argmax(is_alike @ areas))]
    X_down = trimesh.geometry.align_vectors(down, [0, 0, -1])
    vertices = frames.transform(np.asarray(X_down), read.vertices)
    middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2
    middle[2] = vertices[:, 2].min()
    return geometry.Mesh(vertices - middle, read.triangles)


def shot(mesh: geometry.Mesh, rng: np.random.Generator) -> Shot:
    """Returns a scene with the mesh at a random pose on the table, seen from two sides."""
    x, y = rng.uniform(-0.12, 0.12, size=2)
    X_WO = frames.planar(x, y, rng.uniform(0, 2 * math.pi))
    X_WO[2, 3] = HEIGHT
    thing = perception.Body([geometry.PlacedShape(mesh)], X_WO)
    cameras = []
    side = rng.uniform(-math.pi, math.pi)
    for turn in (0.0, rng.uniform(2, 4)):
        up, distance = rng.uniform(math.radians(40), math.radians(65)), rng.uniform(0.6, 0.9)
        level = np.array([math.cos(side + turn), math.sin(side + turn)])
        offset = [*(distance * math.cos(up) * level), distance * math.sin(up)]
        cameras.append(perception.look_at(np.add([0, 0, HEIGHT], offset), [x / 2, y / 2, HEIGHT]))
    silhouette, places = _silhouette(thing)
    highest = float(mesh.vertices[:, 2].max())
    return Shot([*surroundings(), thing], cameras, highest, silhouette, places)


def surroundings() -> list[perception.Body]:
    """Returns the table and the floor."""
    return [_box([*SIZE, SLAB], HEIGHT - SLAB / 2), _box([6, 6, 0.02], -0.01)]


def _box(size: list[float], z: float) -> perception.Body:
    shape = geometry.PlacedShape(geometry.Box(size))
    return perception.Body([shape], frames.translation([0, 0, z]))


def _silhouette(thing: perception.Body) -> tuple[Any, Matrix]:
    """Projects a body onto the table: the image of a camera far above it."""
    from scipy import ndimage

    pixels = 640
    camera = perception.Camera(pixels, pixels, math.radians(6))
    above = frames.translation([*thing.X_WB[:2, 3], HEIGHT + FAR])
    above[:3, :3] = np.diag([1.0, -1.0, -1.0])
    mask = np.asarray(perception.cast_rays([thing], above, camera).label) == 0
    rows, columns = np.indices(mask.shape)
    scale = FAR / camera.K[0, 0]
    places = np.stack([columns - camera.K[0, 2], camera.K[1, 2] - rows], axis=-1) * scale
    return ndimage.binary_fill_holes(mask), places + thing.X_WB[:2, 3]
