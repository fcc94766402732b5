# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless loops`, which shows the holes of a cloud or a mesh."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .._arguments import require_integer
from .._commands import FOUND, NOT_FOUND
from ..errors import TaskError

if TYPE_CHECKING:
    import argparse

    from .. import geometry
    from ..frames import Matrix

MESHES = (".stl", ".obj", ".off")
SCENES = (".yaml", ".yml")
POINTS, MOST_POINTS = 2000, 10**7  # sampled on a mesh
MOST_THREADS = 256


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `loops`."""
    parser.description = (
        "Find the holes of an object from a point cloud or mesh of its surface, and the shortest "
        "loop around each. What may be a hole is listed as uncertain, with the reason. The exit "
        "code is 1 if no hole is reliable. For an object that cameras saw, name the scene file of "
        "`graspless see`: then rays that passed through a loop decide whether it is a hole. "
        "Without rays, the distances between the points decide, and no hole is reliable in a cloud "
        "of one side; but with much noise not all such clouds are recognised: give --viewpoints."
    )
    parser.add_argument(
        "file",
        metavar="CLOUD",
        help="point cloud (.ply, .pcd, .xyz, .npy), mesh (.stl, .obj, .off) or scene file (.yaml)",
    )
    parser.add_argument("--object", metavar="NAME", help="object of the scene file")
    parser.add_argument(
        "--viewpoints",
        "--views",
        type=float,
        nargs="+",
        metavar="X Y Z",
        help="positions of the cameras that saw the cloud, three numbers each, in its frame and "
        "unit; gaps between points then count as seen through",
    )
    parser.add_argument(
        "--all-sides",
        action="store_true",
        help="the cloud is of all sides of the object, as closed meshes (.stl, .obj, .off) are: no "
        "loop is the edge of what a camera saw; no effect with rays",
    )
    parser.add_argument(
        "--unit",
        choices=["m", "mm"],
        default="m",
        help="unit of length of the file (default: %(default)s)",
    )
    parser.add_argument(
        "--points",
        type=int,
        metavar="N",
        help=f"number of points to sample on a mesh (default: {POINTS})",
    )
    parser.add_argument(
        "--seed",
        type=int,
        default=1,
        metavar="N",
        help="seed of the sampling (default: %(default)s)",
    )
    parser.add_argument(
        "--max-edge-length",
        "--edge",
        type=float,
        metavar="D",
        help="longest edge of the simplicial complex [m] (default: each hole has its own)",
    )
    parser.add_argument(
        "--polish", action="store_true", help="shorten the loops of a large cloud on all its points"
    )
    parser.add_argument(
        "--json", action="store_true", help="print the loops and the Betti curve as JSON"
    )
    parser.add_argument(
        "--threads", type=int, default=1, metavar="N", help="threads that share the polishing"
    )
    parser.add_argument("--png", metavar="FILE", help="write a picture to FILE")
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    from .. import files, geometry, view
    from ..report import loops as report

    if options.png is not None:
        view.check_png(options.png)
        files.check_writable(options.png)
    cloud, rays, is_closed = _read(options)
    asked = geometry.LoopOptions()
    if options.max_edge_length is not None:
        asked.max_edge_length = options.max_edge_length
    asked.polish = options.polish
    asked.all_sides = options.all_sides or is_closed
    asked.threads = require_integer("--threads", options.threads, least=1, most=MOST_THREADS)
    try:
        found = geometry.shortest_loops(cloud, asked, rays)
    except ValueError as error:
        raise TaskError(f"{options.file}: {error}") from None
    if options.png is not None:
        view.write_loops_png(cloud, found, options.png)
    if options.json:
        print(json.dumps(report.as_dict(found)))
    else:
        print(report.as_text(found))
        if options.png is not None:
            print(f"written: {options.png}")
    return FOUND if found.found else NOT_FOUND


def _read(options: argparse.Namespace) -> tuple[Matrix, list[geometry.RayImage], bool]:
    """Returns the points, the rays of the cameras that saw them: none but for scenes, and True if
    the points are those of a closed mesh.
    """
    is_scene = Path(options.file).suffix.lower() in SCENES
    if is_scene != (options.object is not None):
        raise TaskError(
            f"{options.file}: --object NAME must be given"
            if is_scene
            else f"--object: {options.object}: only for objects of a scene file (.yaml)"
        )
    count = POINTS if options.points is None else options.points
    require_integer("--points", count, least=1, most=MOST_POINTS)
    require_integer("--seed", options.seed, least=0, most=2**64 - 1)
    if options.points is not None and Path(options.file).suffix.lower() not in MESHES:
        raise TaskError(f"--points: {count}: only for meshes ({', '.join(MESHES)})")
    if not is_scene:
        points, is_closed = read_points(options.file, options.unit, count, options.seed)
        return points, _rays(points, options), is_closed
    if options.unit != "m":
        raise TaskError(f"--unit: {options.unit}: not for scene files, which are in metres")
    if options.viewpoints:
        raise TaskError("--viewpoints: only for clouds; a scene file has its rays")
    from ..perception import load_scene
    from ..tasks.scenes import named
    from ..tasks.source import Source

    scene = load_scene(options.file)
    thing = named(scene.objects, options.object, Source("--object", {}), ())
    return thing.points, list(thing.rays), False


def _rays(points: Matrix, options: argparse.Namespace) -> list[geometry.RayImage]:
    """Returns the rays of the cameras of --viewpoints."""
    from .. import geometry

    if not options.viewpoints:
        return []
    if len(options.viewpoints) % 3:
        raise TaskError(
            f"--viewpoints has {len(options.viewpoints)} numbers; it must have three for each "
            "camera: x y z"
        )
    eyes = (0.001 if options.unit == "mm" else 1.0) * np.reshape(options.viewpoints, (-1, 3))
    try:
        return geometry.rays_from_viewpoints(points, eyes)
    except ValueError as error:
        raise TaskError(f"--viewpoints: {error}") from None


def read_points(path: str, unit: str, count: int, seed: int) -> tuple[Matrix, bool]:
    """Returns the points of a cloud, or samples points on the surface of a mesh; and True if the
    mesh is closed.

    Parameters
    ----------
    path : str
        Cloud (.ply, .pcd, .xyz, .npy) or mesh (.stl, .obj, .off).
    unit : str
        Unit of length of the file: m or mm.
    count, seed : int
        Number of points on a mesh, and seed of their sampling.

    Returns
    -------
    array [N, 3]
        [m].
    bool
    """
    from .. import geometry
    from ..tasks.clasp.cloud import is_closed
    from ..tasks.clouds import SUFFIXES, read_cloud

    scale = 0.001 if unit == "mm" else 1.0
    suffix = Path(path).suffix.lower()
    if suffix not in (*SUFFIXES, *MESHES):
        kinds = ", ".join((*SUFFIXES, *MESHES, *SCENES))
        raise TaskError(f"{path}: unknown kind of file (one of: {kinds})")
    try:
        if suffix in SUFFIXES:
            return scale * read_cloud(path), False
        mesh = geometry.read_mesh(path, scale)
        points: Matrix = geometry.sample_surface([geometry.PlacedShape(mesh)], count, seed)
    except ValueError as error:
        raise TaskError(f"{path}: {str(error).removeprefix(f'{path}: ')}") from None
    return points, is_closed(mesh)
