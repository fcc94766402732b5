# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holes of the five objects in clouds of all kinds, and the time to find them."""

from __future__ import annotations

import dataclasses
import os
import time
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import clasp, geometry

from ..bar import told
from .grid import POINTS

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from ..machine import Row

    Points = np.ndarray[Any, np.dtype[np.float64]]

HOLES = {"purse": 1, "bag": 1, "travel_bag": 1, "lawn_mower": 2, "chair": 7}
VIEWPOINTS = ((1.5, 1.0, 1.2), (-1.5, -1.0, 1.2))  # in O [m]
PATCHES, PATCH_SPACINGS = 3, 3.0  # balls that are cut out, and their radius
RUNS = 5


@dataclasses.dataclass(frozen=True)
class Cloud:
    """Kind of point cloud, and the options of the search for its holes.

    Attributes
    ----------
    kind : str
        Name in results.
    points : int
        Number of points on the object's whole surface.
    change : function
        Change of the whole cloud.
    options : dict
        Fields of geometry.LoopOptions.
    views : int
        Number of the viewpoints whose rays are given; 0: none are.
    """

    kind: str
    points: int
    change: Callable[[Points], Points]
    options: dict[str, Any] = dataclasses.field(default_factory=dict)
    views: int = 0


def noisy(points: Points, spacings: float = 0.5) -> Points:
    deviation = spacings * geometry.spacing(points)
    moves = np.random.default_rng(1).normal(0, deviation, size=points.shape)
    moved: Points = points + moves
    return moved


def patchy(points: Points) -> Points:
    """Removes the points in some balls."""
    middles = points[np.random.default_rng(1).choice(len(points), PATCHES, replace=False)]
    radius = PATCH_SPACINGS * geometry.spacing(points)
    distances = np.linalg.norm(points[:, None] - middles, axis=2)
    kept: Points = points[distances.min(axis=1) > radius]
    return kept


def seen(points: Points, views: int) -> Points:
    """Returns the points that are visible from any of the first viewpoints."""
    indices = [geometry.visible_points(points, v) for v in np.array(VIEWPOINTS[:views])]
    return points[np.unique(np.concatenate(indices))]


CLOUDS = (
    Cloud("clean", POINTS, lambda p: p),
    Cloud("noise, half the spacing", POINTS, noisy),
    Cloud("missing patches", POINTS, patchy),
    Cloud("one view", POINTS, lambda p: seen(p, 1), views=1),
    Cloud("two views", POINTS, lambda p: seen(p, 2), views=2),
    Cloud("10,000 points, exact", 10_000, lambda p: p, {"max_points": 20_000}),
    Cloud("100,000 points, thinned", 100_000, lambda p: p),
    Cloud("100,000 points, polished", 100_000, lambda p: p, {"polish": True}),
)


def rows(tell: Callable[[int, str], None] = lambda done, name: None) -> Iterator[Row]:
    """Returns a row for every object and cloud, with the least time of several runs."""
    whole: dict[tuple[str, int], Points] = {}
    asked = told(product(HOLES, CLOUDS), tell, lambda one: f"{one[0]}, {one[1].kind}")
    for name, cloud in asked:
        if (name, cloud.points) not in whole:
            shapes = clasp.sample_object(name)
            whole[name, cloud.points] = geometry.sample_surface(shapes, cloud.points)
        yield _measure(name, cloud, cloud.change(whole[name, cloud.points]))


def _measure(name: str, cloud: Cloud, points: Points) -> Row:
    options = geometry.LoopOptions(**cloud.options)
    load, times = os.getloadavg()[0], list[float]()
    while len(times) < RUNS and sum(times) < 1:
        start = time.perf_counter()
        eyes = np.reshape(VIEWPOINTS[: cloud.views], (-1, 3))
        rays = geometry.rays_from_viewpoints(points, eyes)
        found = geometry.shortest_loops(points, options, rays)
        times.append(time.perf_counter() - start)
    return {
        "object": name,
        "cloud": cloud.kind,
        "points": len(points),
        "holes": HOLES[name],
        "loops": len(found.found),
        "lengths": [round(loop.length, 4) for loop in found.found],
        "meridians": len(found.meridians),
        "status": found.status.name,
        "plateau": [found.plateau.lower, found.plateau.upper],
        "seconds": min(times),
        "load": round(load, 2),
    }


def totals(found: list[Row]) -> Row:
    """Returns the objects with exactly the true holes, and times, for every kind of cloud."""
    result = {}
    for cloud in CLOUDS:
        of = [row for row in found if row["cloud"] == cloud.kind]
        result[cloud.kind] = {
            "right": sum(row["loops"] == row["holes"] for row in of),
            "objects": len(of),
            "max_seconds": max((row["seconds"] for row in of), default=None),
        }
    return result
