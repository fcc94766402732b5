# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of a task's object, which are read from a file or sampled."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ... import geometry
from ..._core import clasp
from ...files import absence
from ..clouds import read_cloud
from ..documents import rows_of
from ..meshes import require_fetched
from ..rays import Rays, rays_fields
from ..source import Source, at

if TYPE_CHECKING:
    from pathlib import Path

    from ...frames import Matrix
    from . import model

LARGEST = 5.0  # [m]; nobody clasps a larger object
MOST = 10_000_000  # points
DEFAULT = 2000  # points, as in the paper
SOURCES = ("cloud", "mesh", "sample", "points")  # fields of an object, of which one is given


def resolve_object(thing: model.Object, source: Source, directory: Path) -> model.Object:
    """Returns the object with its points inline, and with the rays of its viewpoints."""
    with at(source, "object", thing.first_of(*SOURCES)):
        shapes = _shapes(thing, source, directory)
    points = object_points(thing, shapes, source, directory)
    update: dict[str, Any] = {
        "points": rows_of(points),
        "cloud": None,
        "mesh": None,
        "sample": None,
        "unit": "m",
        "scale": 1.0,
        "views": [],
        "noise": 0.0,
    }
    if thing.loops.all_sides is None and not thing.views and _are_closed(shapes):
        update["loops"] = thing.loops.model_copy(update={"all_sides": True})
    if thing.views:
        with at(source, "object", "views"):
            rays = geometry.rays_from_viewpoints(points, np.array(thing.views))
        update["rays"] = [Rays.model_validate(rays_fields(image)) for image in rays]
    return thing.model_copy(update=update)


def object_points(
    thing: model.Object, shapes: list[geometry.PlacedShape], source: Source, directory: Path
) -> Matrix:
    """[N, 3] points on the object, in O [m]; `shapes` are those on which they are sampled."""
    field = thing.first_of(*SOURCES)
    with at(source, "object", field):
        points = thing.scale * _points(thing, shapes, directory)
    if len(points) > MOST:
        raise source.error(("object", field), f"has {len(points)} points; at most {MOST} can be")
    size = np.ptp(points, axis=0) if len(points) else np.zeros(3)
    if size.max() > LARGEST:
        what = f"is {size[0]:.4g} x {size[1]:.4g} x {size[2]:.4g} m; lengths are in metres"
        hint = "; of a file in millimetres write 'unit: mm' beside it"
        is_file = thing.cloud is not None or thing.mesh is not None
        source.warn(("object", field), what + (hint if is_file else ""))
    if thing.views:
        with at(source, "object", "views"):
            points = _seen(points, thing.views)
    if thing.noise > 0:
        noise = np.random.default_rng(thing.seed).normal(scale=thing.noise, size=points.shape)
        points = points + noise
    return points


def _points(thing: model.Object, shapes: list[geometry.PlacedShape], directory: Path) -> Matrix:
    if isinstance(thing.points, list):
        return np.array(thing.points, dtype=float).reshape(-1, 3)
    if thing.cloud is not None:
        return _unit(thing) * read_cloud(directory / thing.cloud)
    return np.asarray(geometry.sample_surface(shapes, thing.points or DEFAULT, thing.seed))


def _shapes(thing: model.Object, source: Source, directory: Path) -> list[geometry.PlacedShape]:
    """Returns the shapes on which the points are sampled; none if they are given."""
    if thing.mesh is not None:
        path = directory / thing.mesh.file
        if not path.is_file():
            raise source.error(("object", "mesh", "file"), absence(path))
        require_fetched([path])
        mesh = geometry.read_mesh(str(path), _unit(thing) * thing.mesh.factors)
        return [geometry.PlacedShape(mesh, np.eye(4))]
    return [] if thing.sample is None else clasp.sample_object(thing.sample)


def _unit(thing: model.Object) -> float:
    return 0.001 if thing.unit == "mm" else 1.0


def _are_closed(shapes: list[geometry.PlacedShape]) -> bool:
    """Returns True of the shapes of an object that comes with graspless, and of a closed mesh."""
    meshes = [part.shape for part in shapes if isinstance(part.shape, geometry.Mesh)]
    return bool(shapes) and all(is_closed(mesh) for mesh in meshes)


def is_closed(mesh: geometry.Mesh) -> bool:
    """Returns True if each edge of a mesh joins two triangles, as points that are equal are one."""
    import trimesh

    surface: Any = trimesh.Trimesh(np.asarray(mesh.vertices), np.asarray(mesh.triangles))
    return bool(surface.is_watertight)


def _seen(points: Matrix, views: list[list[float]]) -> Matrix:
    """Returns the points that are visible from at least one of the viewpoints."""
    seen = np.zeros(len(points), dtype=bool)
    for view in views:
        seen[geometry.visible_points(points, np.array(view))] = True
    return np.asarray(points[seen])
