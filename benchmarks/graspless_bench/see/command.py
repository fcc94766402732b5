# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench see`."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from graspless.errors import TaskError

from ..arguments import add_output, chosen, finish, positive

if TYPE_CHECKING:
    import argparse

    from graspless import geometry

GRIDS = ("outlines", "holes", "plans")


def add_parser(experiments: Any) -> None:
    """Adds `see` to the experiments."""
    parser = experiments.add_parser(
        "see",
        help="tables and objects in depth images",
        description="Renders objects on a table, as a depth camera sees them, and compares what is "
        "perceived with the truth. Grid outlines: each object lying, from two sides, with three "
        "levels of noise. Grid holes: nine kinds of objects standing, from eight sides, with five "
        "levels of noise; loops around no hole are wrong. Grid plans: times from images to "
        "slides and clasps that are checked.",
    )
    parser.add_argument(
        "folder",
        type=Path,
        nargs="?",
        help="folder of meshes (.stl, .obj, .off, .ply) [m]; by default, objects made of parts",
    )
    parser.add_argument("--grid", choices=GRIDS, default=GRIDS[0], help="(%(default)s)")
    parser.add_argument(
        "--poses", type=positive(int), default=10, metavar="N", help="poses of each mesh (10)"
    )
    parser.add_argument("--mesh", action="append", metavar="NAME", help="only this one; repeat")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="seed of the poses (1)")
    add_output(parser, _run, "write the result as JSON, and see.md, there")


def _run(options: argparse.Namespace) -> int:
    from ..bar import Bar
    from . import holes, plans, report, run

    named = {} if options.grid == "plans" else _named(options)
    load = os.getloadavg()
    with Bar(f"bench see, {options.grid}", len(named) or plans.count()) as bar:
        if options.grid == "plans":
            result = report.of_plans(plans.run(bar.tell), load)
        elif options.grid == "holes":
            result = report.of_holes(holes.run(list(named), bar.tell), load)
        else:
            rows = run.run(named, options.poses, options.seed, bar.tell)
            result = report.of_outlines(rows, load, is_own=options.folder is None)
    return finish(options, result, report)


def _named(options: argparse.Namespace) -> dict[str, geometry.Mesh]:
    """Returns the meshes to try by name."""
    from graspless import geometry

    from . import holes, own

    if options.grid == "holes":
        if options.folder is not None:
            raise TaskError(
                f"{options.folder}: --grid holes knows the holes of its own objects only"
            )
        known = {name: own.mesh_of(own.by_name()[name]) for name in holes.NAMES}
        return chosen("mesh", options.mesh, known)
    if options.folder is None:
        return chosen("mesh", options.mesh, own.small())
    paths = paths_of(options.folder, options.mesh)
    return {path.stem: geometry.read_mesh(str(path)) for path in paths}


def paths_of(folder: Path, names: list[str] | None) -> list[Path]:
    """Returns the meshes of a folder, or those of the names. Raises TaskError if there is none."""
    from .scenes import meshes

    if not folder.is_dir():
        raise TaskError(f"{folder}: no such folder")
    known = {path.stem: path for path in meshes(folder)}
    if not known:
        raise TaskError(f"{folder}: has no meshes (.stl, .obj, .off, .ply)")
    return list(chosen("mesh", names, known).values())
