# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Known holes: how many are found, in clean and noisy clouds of several sizes."""

from __future__ import annotations

import functools
import importlib
import importlib.util
import time
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import geometry

from ..bar import told
from .shapes import Shape, with_holes, without_holes

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from ..machine import Row

    Points = np.ndarray[Any, np.dtype[np.float64]]

SIZES = (1000, 2000, 5000)
NOISES = (0.0, 0.5)  # standard deviation, relative to the distance of neighbouring points
PEER_RATIO = 2.25  # death / birth of a hole, by GUDHI's alpha complex


@functools.cache
def shapes() -> list[Shape]:
    return with_holes() + without_holes()


def count(seeds: int) -> int:
    """Returns the number of clouds."""
    return len(shapes()) * len(SIZES) * len(NOISES) * seeds


def cloud(shape: Shape, size: int, noise: float, seed: int) -> Points:
    """Returns points [size, 3] on the surface of a shape, moved at random, in O [m]."""
    points = geometry.sample_surface(shape.parts, size, seed)
    moves = np.random.default_rng(seed).normal(0, 1, points.shape)
    moved: Points = points + noise * geometry.spacing(points) * moves
    return moved


def rows(
    seeds: int, seed: int, tell: Callable[[int, str], None] = lambda done, name: None
) -> Iterator[Row]:
    """Returns a row for every shape, size, noise and seed."""
    clouds = product(shapes(), SIZES, NOISES, range(seed, seed + seeds))
    for asked in told(clouds, tell, lambda one: f"{one[0].name}, {one[1]} points"):
        yield _measure(*asked)


def _measure(shape: Shape, size: int, noise: float, seed: int) -> Row:
    points = cloud(shape, size, noise, seed)
    start = time.perf_counter()
    loops = geometry.shortest_loops(points)
    seconds = time.perf_counter() - start
    found, uncertain = len(loops.found), len(loops.uncertain)
    may_be = found < shape.holes <= found + uncertain
    verdict = "right" if found == shape.holes else "uncertain" if may_be else "wrong"
    row: Row = {
        "object": shape.name,
        "points": size,
        "noise": noise,
        "seed": seed,
        "holes": shape.holes,
        "found": found,
        "uncertain": uncertain,
        "meridians": len(loops.meridians),
        "verdict": verdict,
        "seconds": seconds,
    }
    return row | _peer(points)


def _peer(points: Points) -> Row:
    """Counts the lasting classes of GUDHI's alpha complex, if GUDHI is installed."""
    if importlib.util.find_spec("gudhi") is None:
        return {}
    gudhi = importlib.import_module("gudhi")
    start = time.perf_counter()
    tree = gudhi.AlphaComplex(points=points).create_simplex_tree()
    tree.compute_persistence(homology_coeff_field=2)
    spans = tree.persistence_intervals_in_dimension(1)  # squares of radii
    lasting = int(np.sum(spans[:, 1] >= PEER_RATIO**2 * spans[:, 0]))
    return {"gudhi": lasting, "gudhi_seconds": time.perf_counter() - start}


def sums(of: list[Row]) -> Row:
    """Returns the number of clouds with each verdict, and the median time [s]."""
    row: Row = {
        "clouds": len(of),
        **{v: sum(row["verdict"] == v for row in of) for v in ("right", "uncertain", "wrong")},
        "seconds": float(np.median([row["seconds"] for row in of])),
    }
    if all("gudhi" in row for row in of):
        row["gudhi_right"] = sum(row["gudhi"] == row["holes"] for row in of)
        row["gudhi_seconds"] = float(np.median([row["gudhi_seconds"] for row in of]))
    return row


def by_object(found: list[Row]) -> list[Row]:
    """Returns the sums of every object."""
    names = dict.fromkeys((row["object"], row["holes"]) for row in found)
    return [
        {"name": name, "holes": holes, **sums([row for row in found if row["object"] == name])}
        for name, holes in names
    ]


def totals(found: list[Row]) -> Row:
    """Returns the sums of all objects with holes, and of all without."""
    kinds = {"with holes": True, "without holes": False}
    parts = {
        name: [row for row in found if (row["holes"] > 0) == has_holes]
        for name, has_holes in kinds.items()
    }
    return {name: sums(of) for name, of in parts.items() if of}
