# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fingertip tasks that no option was tuned on: blocks, wedges, prisms and scanned boxes."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.spatial import ConvexHull

from graspless import plan as make_plan
from graspless.tasks import task_from_dict

from .fingertip_tasks import _slide, _tumble, contacts, options

if TYPE_CHECKING:
    from numpy.random import Generator

    from graspless.frames import Matrix
    from graspless.tasks import Task

SHAPES = ("block", "wedge", "prism", "scanned box")
ROUGH = 0.001  # largest error of a scanned corner along each axis [m]


def break_tasks(count: int, seed: int) -> list[Task]:
    """Returns tasks that have a plan, with the shapes in turn and one to four fingers."""
    return [break_task(seed, k) for k in range(count)]


def break_task(seed: int, k: int) -> Task:
    """Returns the first of a sequence of random tasks that has a plan."""
    for attempt in range(300):
        random = np.random.default_rng([seed, 7, k, attempt])
        shape = SHAPES[k % len(SHAPES)]
        task = task_from_dict(draw(random, shape), f"bench: {shape} {seed}-{k}")
        if make_plan(task):
            return task
    raise AssertionError(f"no random task {seed}-{k} has a plan")


def draw(random: Generator, shape: str) -> dict[str, Any]:
    """Returns a task with a random object of a shape, and a motion; it may have no plan."""
    vertices = corners(random, shape)
    hull = ConvexHull(vertices)
    mass = float(random.uniform(300, 2000) * hull.volume)
    tumbles = shape in ("block", "scanned box") and random.random() < 0.5
    motion = (
        _tumble(random) if tumbles else _slide(random) if random.random() < 0.8 else _turn(random)
    )
    return {
        "kind": "fingertip",
        "object": {
            "name": shape,
            "vertices": vertices.tolist(),
            "triangles": outward(hull),
            "mass": mass,
        },
        **contacts(random, mass, [0.15, 0.5, 0.25, 0.1]),
        "motion": {"sequence": [motion]},
        "options": options(mass, 4),
        "budget": {"seconds": 10.0},
    }


def corners(random: Generator, shape: str) -> Matrix:
    """Returns the corners of an object [N, 3] that stands on z = 0 [m]."""
    x, y, z = random.uniform(0.03, 0.10, 3)
    if shape == "prism":
        sides = int(random.integers(3, 8))
        turn = np.sort(random.uniform(0, 2 * math.pi / sides, sides))
        turn += 2 * math.pi / sides * np.arange(sides)
        base = np.column_stack([x / 1.6 * np.cos(turn), y / 1.6 * np.sin(turn)])
        return np.vstack([np.column_stack([base, np.full(sides, h)]) for h in (0.0, z)])
    at = np.array([[i, j, k] for k in (0, 1) for j in (0, 1) for i in (0, 1)], dtype=float)
    found: Matrix = (at - [0.5, 0.5, 0.0]) * [x, y, z]
    if shape == "wedge":  # the top slopes along x
        found[at[:, 2] > 0, 2] *= np.where(at[at[:, 2] > 0, 0] > 0, 1.0, random.uniform(0.3, 0.8))
    if shape == "scanned box":  # it stands on a face, and no other is quite flat or square
        error = random.uniform(-ROUGH, ROUGH, (8, 3))
        error[at[:, 2] == 0, 2] = 0
        found += error
    return found


def outward(hull: ConvexHull) -> list[list[int]]:
    """Returns the triangles of a hull, counter-clockwise as seen from outside."""
    faces = []
    for face, equation in zip(hull.simplices, hull.equations, strict=True):
        a, b, c = hull.points[face]
        is_outward = np.cross(b - a, c - a) @ equation[:3] > 0
        faces.append([int(i) for i in (face if is_outward else face[::-1])])
    return faces


def _turn(random: Generator) -> dict[str, Any]:
    angle = random.uniform(0.3, 1.0) * random.choice([-1, 1])
    return {"turn": {"point": [0.0, 0.0, 0.0], "angle": float(angle), "segments": 12}}
