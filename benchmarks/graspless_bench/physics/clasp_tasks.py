# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Problems of the clasp planner as tasks for the physics engine."""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING

import yaml

from graspless.robot import Robot, builtin
from graspless.tasks import read_task

from ..clasp.grid import POINTS, SECONDS, START, paper

if TYPE_CHECKING:
    from collections.abc import Iterator

    from graspless.tasks import Task

    from ..clasp.grid import Trial


def physics_tasks(count: int | None = None, seed: int = 1) -> Iterator[Task]:
    """Returns the first `count` tasks of Section V-A, named by their trials; all 60 by default."""
    for index, trial in enumerate(paper(1, seed)):
        if index == count:
            return
        yield make_task(trial)


def make_task(trial: Trial) -> Task:
    """Returns a trial of the planner's bench as a task."""
    x, y, z, degrees = trial.place
    document = {
        "kind": "clasp",
        "robot": {"urdf": trial.hand, "home": _home(trial.hand)},
        "object": {
            "name": trial.object,
            "sample": trial.object,
            "points": POINTS,
            "pose": {"position": [x, y, z], "rpy": [0.0, 0.0, math.radians(degrees)]},
        },
        "budget": {"seconds": SECONDS, "seed": trial.seed},
    }
    return read_task(yaml.safe_dump(document), trial.name)


@functools.cache
def _home(hand: str) -> dict[str, float]:
    """Returns the arm's joints at the start. Those of the hand are as in its open state."""
    robot = Robot.from_urdf_file(str(builtin(hand)))
    names = [robot.joint_names[i] for i in robot.group("arm")]
    return {name: float(q) for name, q in zip(names, START, strict=True)}
