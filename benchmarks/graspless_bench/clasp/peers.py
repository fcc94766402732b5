# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Section V-D: rate at which a planner that knows contacts but no loops envelops a handle."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np

from .. import _peers
from ..bar import told
from . import measure
from .grid import purses

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from ..machine import Row
    from .grid import Trial

BODY_HEIGHT = 0.185  # of the purse, and a little [m]: what is higher is its handle


def rows(
    seeds: int, start: int, seconds: float | None, tell: Callable[[int, str], None]
) -> Iterator[Row]:
    """Returns two rows for every trial: one of the Grasp-RRT and one of ours."""
    for trial in told(purses(seeds, start), tell):
        yield grasp(trial, seconds)
        ours = measure.measure(trial, seconds)
        yield {
            "planner": "ours",
            "envelops": ours["found"] and ours["virtual_linking_min"] > 0,
            "on_handle": ours["found"],
            **{key: ours[key] for key in ("hand", "pose", "seed", "found", "seconds", "load")},
        }


def grasp(trial: Trial, seconds: float | None) -> Row:
    """Returns the row of one run of the Grasp-RRT."""
    load = os.getloadavg()[0]
    grasp = _peers.grasp_rrt(trial.make_problem(), trial.make_budget(seconds))
    return {
        "planner": "grasp_rrt",
        "hand": trial.hand,
        "pose": trial.pose,
        "seed": trial.seed,
        "found": bool(grasp),
        "envelops": bool(grasp) and grasp.envelops,
        "on_handle": bool(grasp) and bool(np.all(grasp.contacts[:, 2] > BODY_HEIGHT)),
        "contacts": len(grasp.contacts),
        "quality": grasp.quality,
        "approaches": grasp.approaches,
        "grasps": grasp.grasps,
        "nodes": grasp.nodes,
        "seconds": grasp.seconds,
        "load": round(load, 2),
    }


def totals(found: list[Row]) -> Row:
    """Returns the counts of grasps, on the handle and around it, for each planner."""
    return {
        planner: {
            "runs": len(of),
            **{key: sum(row[key] for row in of) for key in ("found", "on_handle", "envelops")},
        }
        for planner in ("grasp_rrt", "ours")
        if (of := [row for row in found if row["planner"] == planner])
    }
