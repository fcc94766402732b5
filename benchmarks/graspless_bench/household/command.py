# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench household`."""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from graspless.errors import TaskError

from ..arguments import add_output, check_writable, finish, positive

if TYPE_CHECKING:
    import argparse

FILMS = 10  # at most


def add_parser(experiments: Any) -> None:
    """Adds `household` to the experiments."""
    parser = experiments.add_parser(
        "household",
        help="objects of a folder: seen, picked up, and lifted in MuJoCo",
        description="Drops each mesh of a folder onto a table that is square, round or L-shaped, "
        "every other time beside two others. Renders what noisy depth cameras see, picks the "
        "object up in whichever way works, and executes the plan in MuJoCo, slides in closed loop, "
        "with the true meshes as convex parts, and with other friction, mass and flexures (needs "
        "`pip install vhacdx`).",
    )
    parser.add_argument("folder", type=Path, help="folder of meshes (.stl, .obj, .off, .ply) [m]")
    parser.add_argument(
        "--robots", default="wam_t42", metavar="LIST", help="robots, by comma (%(default)s)"
    )
    parser.add_argument(
        "--poses", type=positive(int), default=10, metavar="N", help="drops of each mesh (10)"
    )
    parser.add_argument(
        "--views", default="1", metavar="LIST", help="numbers of cameras, 1, 2 or 1,2 (%(default)s)"
    )
    parser.add_argument("--mesh", action="append", metavar="NAME", help="only this one; repeat")
    parser.add_argument(
        "--masses", type=Path, metavar="FILE", help="YAML file of masses by name [kg] (default 0.2)"
    )
    parser.add_argument(
        "--excluded",
        type=Path,
        metavar="FILE",
        help="YAML file of the meshes that a robot's hand cannot take: `robot: {mesh: reason}`; "
        "they are run, and counted apart",
    )
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="seed of the places (1)")
    parser.add_argument(
        "--jobs", type=positive(int), default=1, metavar="J", help="processes (%(default)s)"
    )
    add_output(
        parser,
        _run,
        "write household.json, household.md and household.png there; an interrupted run goes "
        "on from household.rows",
    )
    parser.add_argument(
        "--films",
        type=Path,
        metavar="DIR",
        help="write replays of up to ten trials there that were executed and failed",
    )


def _robots(text: str) -> list[str]:
    from .trial import label_of

    robots = [name.strip() for name in text.split(",")]
    if len({label_of(robot) for robot in robots}) < len(robots):
        raise TaskError(f"--robots: {text}: their names should differ")
    return robots


def _views(text: str) -> list[int]:
    if text not in ("1", "2", "1,2"):
        raise TaskError(f"--views: {text}: should be 1, 2 or 1,2")
    return [int(count) for count in text.split(",")]


def _run(options: argparse.Namespace) -> int:
    from ..bar import Bar
    from ..see.command import paths_of
    from . import pictures, report
    from .run import queries, read_excluded, read_masses, run

    paths = paths_of(options.folder, options.mesh)
    masses = read_masses(options.masses)
    robots, views = _robots(options.robots), _views(options.views)
    excluded = read_excluded(options.excluded, {path.stem for path in paths}, robots)
    if find_spec("vhacdx") is None:
        raise TaskError("bench household: needs vhacdx for convex parts: pip install vhacdx")
    if options.films is not None:
        check_writable(options.films)
        options.films.mkdir(parents=True, exist_ok=True)
    log = None if options.out is None else options.out / "household.rows"
    load = os.getloadavg()
    everything = paths_of(options.folder, None)
    asked = queries(paths, robots, views, options.poses, masses, options.seed, everything)
    with Bar("bench household", len(asked)) as bar:
        rows = run(asked, options.jobs, log, bar.tell)
    code = finish(options, report.as_result(rows, load, excluded), report)
    if log is not None:
        pictures.draw(rows, asked, options.out / "household.png")
        log.unlink(missing_ok=True)
    if options.films is not None:
        pictures.film(rows, asked, options.films, FILMS)
    return code
