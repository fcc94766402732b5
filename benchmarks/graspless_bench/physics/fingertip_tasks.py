# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fingertip tasks for the physics bench: the paper's four cases and random ones."""

from __future__ import annotations

import copy
import itertools
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import plan as make_plan
from graspless.tasks import task_from_dict

from ..fingertip.grid import CASES

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.random import Generator

    from graspless.tasks import Task

RANDOM = 50
UNIT = 0.01  # the paper's unit of length, where it is one centimetre [m]


def physics_tasks(count: int | None = None, seed: int = 1) -> Iterator[Task]:
    """Yields cases a to d with 1 cm as unit of length, then random tasks that have a plan.

    Parameters
    ----------
    count : int, optional
        Number of tasks, 54 by default.
    seed : int
        Seed of the random tasks. Task k does not depend on `count`.
    """
    count = len("abcd") + RANDOM if count is None else count
    tasks = [task_from_dict(scaled(CASES[name]), f"bench: physics {name}") for name in "abcd"]
    yield from tasks[:count]
    yield from (random_task(seed, k) for k in range(count - len(tasks)))


def forceful_tasks(count: int, seed: int = 1) -> Iterator[Task]:
    """Yields those of `physics_tasks` that tumble the object: fingers hold it then, not the floor
    alone.
    """
    most = len("abcd") + RANDOM
    tasks = (task for task in physics_tasks(most, seed) if _tumbles(task))
    yield from itertools.islice(tasks, count)


def _tumbles(task: Task) -> bool:
    motion = task.to_dict()["motion"]
    return any("tumble" in step for step in motion.get("sequence", [motion]))


def random_task(seed: int, k: int) -> Task:
    """Returns the first of a sequence of random tasks that has a plan."""
    for attempt in range(100):
        document = draw(np.random.default_rng([seed, k, attempt]))
        task = task_from_dict(document, f"bench: physics {seed}-{k}")
        if make_plan(task):
            return task
    raise AssertionError(f"no random task {seed}-{k} has a plan")


def scaled(document: dict[str, Any], unit: float = UNIT) -> dict[str, Any]:
    """Returns a case of the paper at another size, with the same plan and forces."""
    task = copy.deepcopy(document)
    task["object"]["box"] = [unit * side for side in task["object"]["box"]]
    task["fingers"]["radius"] *= unit
    for wall in task.get("walls", []):
        wall["offset"] *= unit
    if "slide" in task["motion"]:
        slide = task["motion"]["slide"]
        slide["translation"] = [unit * step for step in slide["translation"]]
    task["options"] = task.get("options", {}) | {"regrasp_cost": 100.0 * unit}
    return task


def draw(random: Generator) -> dict[str, Any]:
    """Returns a task with a random block and motion, which may have no plan."""
    size = random.uniform(0.03, 0.10, 3)
    steps = [
        [_slide(random)],
        [_tumble(random)],
        [_slide(random), _tumble(random)],
    ][random.choice(3, p=[0.4, 0.4, 0.2])]
    walls = []
    if random.random() < 0.3:  # no motion goes towards it
        gap = float(random.uniform(0.002, 0.01))
        walls = [{"name": "beside", "normal": [0, -1, 0], "offset": -float(size[1] / 2 + gap)}]
    straight = "slide" not in steps[0] or steps[0]["slide"]["translation"][1] <= 0
    mass = float(random.uniform(300, 2000) * np.prod(size))
    return {
        "kind": "fingertip",
        "object": {"name": "block", "box": [float(side) for side in size], "mass": mass},
        **contacts(random, mass, [0.15, 0.7, 0.15]),
        "walls": walls if straight else [],
        "motion": {"sequence": steps},
        "options": options(mass, 5),
        "budget": {"seconds": 30.0},
    }


def contacts(random: Generator, mass: float, shares: list[float]) -> dict[str, Any]:
    """Returns random fingers and friction; `shares` are the chances of 1, 2, ... fingers."""
    return {
        "fingers": {
            "count": int(random.choice(np.arange(len(shares)) + 1, p=shares)),
            "radius": float(random.uniform(0.006, 0.012)),
            "max_normal_force": float(random.uniform(0.6, 2.0) * 9.8 * mass),
            "friction": _about(random.uniform(0.5, 1.0)),
        },
        "friction": _about(random.uniform(0.3, 0.8)),
    }


def options(mass: float, locations_per_side: int) -> dict[str, Any]:
    """Returns the options of the search in a random task."""
    return {
        "locations_per_side": locations_per_side,
        "min_stability": 0.05 * 9.8 * mass,
        "regrasp_cost": 1.0,
        "explain": False,
    }


def _about(friction: float) -> list[float]:
    """Returns the interval of 10 % around a value, by which trials vary it."""
    return [0.9 * float(friction), 1.1 * float(friction)]


def _slide(random: Generator) -> dict[str, Any]:
    way, far = random.uniform(-math.pi, math.pi), random.uniform(0.03, 0.08)
    translation = [float(far * math.cos(way)), float(far * math.sin(way)), 0.0]
    return {"slide": {"translation": translation, "segments": 12}}


def _tumble(random: Generator) -> dict[str, Any]:
    return {"tumble": {"over": str(random.choice(["+x", "-x", "-y"])), "segments": 18}}
