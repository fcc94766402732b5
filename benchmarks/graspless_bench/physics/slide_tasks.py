# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of the frozen grid with the defaults, for the physics engine."""

from __future__ import annotations

from typing import TYPE_CHECKING

from graspless.tasks import Task, read_task

from ..slide.grid import HOME, MIN_DEPTH, PAPERS_HAND, Start, Trial, starts
from ..slide.shapes import TABLES, THICKNESS, outline_of

if TYPE_CHECKING:
    from collections.abc import Iterator


def physics_tasks(count: int, seed: int = 1, finger_model: str = "flexure") -> Iterator[Task]:
    """Returns the start problems of the slide bench's row *defaults* as tasks.

    Parameters
    ----------
    count : int
        Number of tasks. Task k does not depend on it.
    seed : int
        Of their poses.
    finger_model : str
        "flexure", or "impedance": the paper's formula on the commanded tip.
    """
    for start in starts(count, seed):
        yield physics_task(start, finger_model)


def physics_task(start: Start, finger_model: str = "flexure") -> Task:
    """Returns a start problem of the slide bench as a task."""
    import yaml

    x, y, yaw = start.draw_pose()
    depth = Trial.range
    is_papers = finger_model != "flexure"  # which knows no friction
    document = {
        "kind": "slide",
        "robot": {"urdf": "wam_t42", "home": HOME},
        "hand": {"finger_model": finger_model, "wrist_stiffness": PAPERS_HAND.wrist_stiffness},
        "object": {
            "name": start.object,
            "polygon": [list(corner) for corner in outline_of(start.object, start.scale)],
            "thickness": THICKNESS,
            "pose": {"x": x, "y": y, "yaw": yaw},
        },
        "support": {"polygon": [list(corner) for corner in TABLES[start.table]]},
        "options": {"min_depth": MIN_DEPTH, "max_depth": MIN_DEPTH + depth}
        | ({"refuse_lag": False} if is_papers else {}),
        "budget": {"seed": start.draw_seed()},
    }
    return read_task(yaml.safe_dump(document), start.name)
