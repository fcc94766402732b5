# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A mesh in a stable pose on a table before a robot, and what a depth camera sees of it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import trimesh

from graspless import frames, geometry, perception
from graspless.simulation.slide.scene import Body

if TYPE_CHECKING:
    from pathlib import Path

    from graspless.frames import Matrix

TABLE = (0.7, 0.7, 0.04)  # [m]; its top is in z = 0 of the robot's base
CENTER = (0.65, 0.0)  # of the table [m]
FLOOR = -0.75  # [m]
EYES = ((-0.05, 0.0, 0.75), (1.35, 0.0, 0.75))  # of the cameras: at the base, and opposite [m]
ROOM = 0.12  # half width of the square in which objects are placed [m]
PARTS = 32  # convex parts of an object, at most


@dataclass(frozen=True)
class Placed:
    """A mesh on the table.

    Attributes
    ----------
    mesh : trimesh.Trimesh
        In its own frame T.
    X_WT : array [4, 4]
        Pose in the world.
    mass : float
        [kg].
    """

    mesh: Any
    X_WT: Matrix
    mass: float

    @property
    def points(self) -> Matrix:
        """Vertices [N, 3] in the world [m]."""
        return frames.transform(self.X_WT, np.asarray(self.mesh.vertices))


def stable_poses(path: Path, count: int) -> tuple[Any, list[Matrix]]:
    """Returns a mesh and poses [4, 4] in which it rests, those on the largest sides first.

    A side is what its hull's faces of one direction, within 3 degrees, have in common. The centroid
    of the hull must be over it.
    """
    read = geometry.read_mesh(str(path))
    mesh = trimesh.Trimesh(read.vertices, read.triangles)
    hull = mesh.convex_hull
    normals, areas = np.asarray(hull.face_normals), np.array(hull.area_faces)
    is_alike = normals @ normals.T > math.cos(math.radians(3))
    poses: list[Matrix] = []
    while len(poses) < count and areas.any():
        best = int(np.argmax(is_alike @ areas))
        X = np.asarray(trimesh.geometry.align_vectors(normals[best], [0, 0, -1]))
        faces = np.asarray(hull.faces)[is_alike[best]]
        areas[is_alike[best]] = 0
        base = frames.transform(X, np.asarray(hull.vertices)[np.unique(faces)])[:, :2]
        if _is_over(base, frames.transform(X, np.asarray(hull.center_mass)[None])[0, :2]):
            poses.append(X)
    return mesh, poses


def _is_over(base: Matrix, p: Matrix) -> bool:
    """Returns True if a point lies in the convex hull of others, all in a plane."""
    around = base - p
    angles = np.sort(np.arctan2(around[:, 1], around[:, 0]))
    gaps = np.diff(np.append(angles, angles[0] + 2 * math.pi))
    return bool(gaps.max() < math.pi)


def placed(mesh: Any, X_lying: Matrix, mass: float, rng: np.random.Generator) -> Placed:
    """Returns the mesh at a random place and heading on the table."""
    turned = frames.transform(X_lying, np.asarray(mesh.vertices))
    middle = (turned.min(axis=0) + turned.max(axis=0)) / 2
    x, y = np.add(CENTER, rng.uniform(-ROOM, ROOM, size=2))
    lowest = frames.translation([-middle[0], -middle[1], -turned[:, 2].min()])
    X_WT = frames.planar(x, y, rng.uniform(0, 2 * math.pi)) @ lowest @ X_lying
    return Placed(mesh, np.asarray(X_WT), mass)


def seen(thing: Placed, seed: int, views: int) -> perception.Scene:
    """Returns what noisy depth cameras see of the table: the first `views` of EYES."""
    bodies = [
        _box(TABLE, (*CENTER, -TABLE[2] / 2)),
        _box((6, 6, 0.02), (0.65, 0.0, FLOOR)),
        perception.Body(
            [geometry.PlacedShape(geometry.Mesh(thing.mesh.vertices, thing.mesh.faces))], thing.X_WT
        ),
    ]
    frames_seen = [
        perception.render(bodies, perception.look_at(eye, [*CENTER, 0.0]), seed=seed + i)
        for i, eye in enumerate(EYES[:views])
    ]
    depth, X_WC = ([getattr(f, name) for f in frames_seen] for name in ("depth", "X_WC"))
    return perception.perceive(depth, frames_seen[0].K, X_WC)


def nearest(scene: perception.Scene, thing: Placed) -> perception.Object | None:
    """Returns the object of a scene that is where the mesh is, if there is one."""
    points = thing.points
    low, high = points.min(axis=0)[:2], points.max(axis=0)[:2]
    for found in sorted(scene.objects, key=lambda item: -len(item.points)):
        ring = np.asarray(found.outline) @ found.X_WO[:2, :2].T + found.X_WO[:2, 3]
        middle = (ring.min(axis=0) + ring.max(axis=0)) / 2
        if (middle > low - 0.01).all() and (middle < high + 0.01).all():
            return found
    return None


def truth(thing: Placed, X_WO: Matrix) -> Body:
    """Returns the mesh as convex parts in the frame O in which a plan has put its object."""
    X_OT = np.linalg.inv(X_WO) @ thing.X_WT
    parts = trimesh.decomposition.convex_decomposition(
        thing.mesh, maxConvexHulls=PARTS, resolution=60_000
    )
    hulls = [frames.transform(X_OT, np.asarray(part["vertices"])) for part in parts]
    solid = [trimesh.Trimesh(**part).convex_hull for part in parts]
    volumes = np.array([part.volume for part in solid])
    shares = thing.mass * volumes / volumes.sum()
    com = sum(m * part.center_mass for m, part in zip(shares, solid, strict=True)) / thing.mass
    inertia = np.zeros((3, 3))
    for m, part in zip(shares, solid, strict=True):
        off = part.center_mass - com
        own = part.moment_inertia * m / max(part.volume, 1e-12)
        inertia += own + m * (off @ off * np.eye(3) - np.outer(off, off))
    R = X_OT[:3, :3]
    return Body(hulls, thing.mass, frames.transform(X_OT, com[None])[0], R @ inertia @ R.T)


def _box(size: Any, center: Any) -> perception.Body:
    shape = geometry.PlacedShape(geometry.Box(np.array(size)))
    return perception.Body([shape], frames.translation(center))
