# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Problems of growing size."""

from __future__ import annotations

import dataclasses
import json
import math
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from graspless import batch, clasp, collision, frames, geometry, slide
from graspless._core import fingertip as core  # plans without their files' documents

from ..fingertip import grid
from ..slide.grid import Start, Trial, among

if TYPE_CHECKING:
    from collections.abc import Callable

VOXEL = 0.02  # edge of a box of an occupancy map [m]
WALL = 0.9  # distance of the wall of obstacles beside the arm [m]
TASKS = 24  # of a batch


class Done(NamedTuple):
    """End of a run: its status, and the seconds that count if not those of the whole call."""

    status: str
    seconds: float | None = None


@dataclasses.dataclass(frozen=True)
class Curve:
    """A problem that grows.

    Attributes
    ----------
    name : str
        Name in results.
    grows : str
        Quantity that `sizes` count.
    sizes : tuple of int
    make : function
        Makes the query of a size. Only the query is timed.
    is_wall : bool
        Measure wall clock: for several threads or processes.
    needs : str
        Module that must be installed.
    """

    name: str
    grows: str
    sizes: tuple[int, ...]
    make: Callable[[int], Callable[[], Done]]
    is_wall: bool = False
    needs: str = ""


def _fingertip(document: dict[str, Any], **options: Any) -> Callable[[], Done]:
    changed = document | {"options": document.get("options", {}) | options}
    task: Any = grid.Trial("scaling", changed).make_task()
    return lambda: Done(core.plan(task.problem, task.options, task.budget).status.name)


def _prism(sides: int) -> dict[str, Any]:
    """A prism with this many sides, which is slid by its size."""
    angles = 2 * math.pi * np.arange(sides) / sides
    ring = 5 * np.column_stack([np.cos(angles), np.sin(angles)])
    vertices = [[*map(float, p), z] for z in (0.0, 5.0) for p in ring]
    lower, upper = list(range(sides)), list(range(sides, 2 * sides))
    triangles = [[lower[0], lower[i + 1], lower[i]] for i in range(1, sides - 1)]
    triangles += [[upper[0], upper[i], upper[i + 1]] for i in range(1, sides - 1)]
    for i in range(sides):
        j = (i + 1) % sides
        triangles += [[lower[i], lower[j], upper[j]], [lower[i], upper[j], upper[i]]]
    thing = {"name": "prism", "vertices": vertices, "triangles": triangles, "mass": 1.0}
    return grid.slide() | {"object": thing}


def _slide(obstacles: list[collision.Obstacle]) -> Callable[[], Done]:
    trial = Trial(Start("square", "square", 1.0, 0, 1), defaults=True)
    problem = among(trial.make_problem(), obstacles)
    options = trial.make_options()
    return lambda: Done(slide.plan(problem, options, trial.make_budget(30)).status.name)


def _voxels(count: int) -> Callable[[], Done]:
    """Boxes of an occupancy map: a wall beside the arm, from its middle outwards."""
    side = math.ceil(math.sqrt(count))
    cells = [(i - side // 2, j) for j in range(side) for i in range(side)][:count]
    box = geometry.Box([VOXEL] * 3)
    shapes = [
        geometry.PlacedShape(box, frames.translation([VOXEL * i, WALL, VOXEL * j]))
        for i, j in cells
    ]
    return _slide([collision.Obstacle("map", shapes)])


def _triangles(count: int) -> Callable[[], Done]:
    """One mesh of an uneven wall of 2 m x 2 m beside the arm."""
    cells = round(math.sqrt(count / 2))
    line = np.linspace(-1, 1, cells + 1)
    x, z = np.meshgrid(line, line + 1)
    bumps = 0.01 * np.sin(40 * x) * np.sin(37 * z)
    vertices = np.column_stack([x.ravel(), WALL + bumps.ravel(), z.ravel()])
    first = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    above = first + cells + 1
    triangles = np.vstack(
        [
            np.column_stack([first, first + 1, above]),
            np.column_stack([first + 1, above + 1, above]),
        ]
    )
    mesh = geometry.Mesh(vertices, triangles)
    return _slide([collision.Obstacle("mesh", [geometry.PlacedShape(mesh)])])


def _loops(points: int) -> Callable[[], Done]:
    cloud = geometry.sample_surface(clasp.sample_object("purse"), points)
    options = geometry.LoopOptions()
    return lambda: Done(geometry.shortest_loops(cloud, options).status.name)


def _batch(jobs: int) -> Callable[[], Done]:
    """Plans a batch in as many processes."""
    return lambda: _planned(jobs=jobs)


def _dask(workers: int) -> Callable[[], Done]:
    """Plans a batch by as many workers of Dask, which are started before."""

    def query() -> Done:
        from dask import distributed

        local: Any = distributed.LocalCluster
        with local(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster:
            return _planned(dask=cluster.scheduler_address)

    return query


def _planned(**workers: Any) -> Done:
    with tempfile.TemporaryDirectory() as folder:
        tasks = Path(folder) / "tasks"
        tasks.mkdir()
        for number in range(TASKS):
            motion = {"tumble": {"over": "+x", "segments": 60 + number}}
            document = grid.cork() | {"motion": motion}
            (tasks / f"{number:02}.yaml").write_text(json.dumps(document), encoding="utf-8")
        summary = batch(tasks, Path(folder) / "plans", **workers)
    return Done("solved" if summary.held == TASKS else "not_all", summary.seconds)


A, D = grid.slide(), grid.tumble(has_side_wall=True)
CURVES = (
    Curve(
        "fingertip: locations",
        "locations per side of a face, case d",
        (5, 7, 11, 15, 21, 31),
        lambda n: _fingertip(D, locations_per_side=n),
    ),
    Curve(
        "fingertip: segments",
        "segments of the motion, case c",
        (15, 30, 60, 120, 240),
        lambda n: _fingertip(grid.tumble(has_side_wall=False, segments=n)),
    ),
    Curve(
        "fingertip: fingers",
        "fingers, case a",
        (2, 3, 4),
        lambda n: _fingertip(A | {"fingers": A["fingers"] | {"count": n}}),
    ),
    Curve(
        "fingertip: lattice",
        "poses a side of a lattice of x, y and yaw",
        (10, 20, 30, 50, 100),
        lambda n: _fingertip(grid.slide_and_turn(n)),
    ),
    Curve(
        "fingertip: faces",
        "sides of a prism that is slid",
        (4, 8, 16, 32),
        lambda n: _fingertip(_prism(n)),
    ),
    Curve("slide: boxes", "boxes of an occupancy map", (1, 10, 100, 1000, 10_000), _voxels),
    Curve(
        "slide: triangles",
        "triangles of one obstacle",
        (200, 2000, 20_000, 200_000, 1_000_000),
        _triangles,
    ),
    Curve("loops: points", "points of the purse", (1000, 10_000, 100_000, 1_000_000), _loops),
    Curve(
        "threads",
        "threads, case d with 21 locations per side",
        (1, 2),
        lambda n: _fingertip(D, locations_per_side=21, threads=n),
        is_wall=True,
    ),
    Curve("processes", f"processes, a batch of {TASKS} tumbles", (1, 2), _batch, is_wall=True),
    Curve(
        "Dask workers",
        f"workers, a batch of {TASKS} tumbles",
        (1, 2),
        _dask,
        is_wall=True,
        needs="dask.distributed",
    ),
)
