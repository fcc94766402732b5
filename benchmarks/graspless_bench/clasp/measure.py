# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the clasp planner's trials, checks every plan, and makes rows of results of them."""

from __future__ import annotations

import math
import os
import statistics
import time
from typing import TYPE_CHECKING

import numpy as np

from graspless import clasp, frames, geometry
from graspless._core import clasp as core  # the file's numbers are not wanted

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from ..machine import Row
    from .grid import Trial

# Section V-A.
CYCLES_OF_ALL, FEW_CYCLES = 52, 10


def measure(trial: Trial, seconds: float | None) -> Row:
    """Plans once, and tests the result."""
    problem, options = trial.make_problem(), trial.make_options()
    load = os.getloadavg()[0]
    start = time.perf_counter()
    plan = core.plan(problem, options, trial.make_budget(seconds))
    elapsed = time.perf_counter() - start
    if plan.status is clasp.Status.interrupted:
        raise KeyboardInterrupt
    done = plan.statistics
    row = {
        "hand": trial.hand,
        "object": trial.object,
        "pose": trial.pose,
        "seed": trial.seed,
        "asked": options.min_linking,
        "found": bool(plan),
        "status": plan.status.name,
        "cycles": done.cycles,
        "nodes": done.nodes,
        "restarts": done.restarts,
        "seconds": elapsed,
        "stability_seconds": done.stability_seconds,
        "insecure_clasps": done.refusals.get("clasp: not secure", 0),
        **_of_clasp(problem, plan, options),
        "faults": list(clasp.check(problem, plan, options)) if plan else [],
        "load": round(load, 2),
        "reason": plan.reason,
    }
    return row


def _of_clasp(problem: clasp.Problem, plan: core.Plan, options: clasp.Options) -> Row:
    names = ("virtual_linking_min", "virtual_linking_max", "gauss_min", "gauss_max", "margin")
    if not plan:
        return {**dict.fromkeys(names), "secure": False, "open_hand_escapes": None}
    linking = plan.segments[-1].virtual_linking[-1]
    gauss = gauss_linking(problem, plan)
    return {
        "min_linking": plan.min_linking,
        "linking_reached": float(np.min(plan.segments[0].virtual_linking[-1])),
        "virtual_linking_min": float(np.min(linking)),
        "virtual_linking_max": float(np.max(linking)),
        "gauss_min": min(gauss),
        "gauss_max": max(gauss),
        "path_nodes": len(plan.tree.path),
        "loop": plan.loop,
        "secure": bool(plan.stability.secure),
        "margin": plan.stability.margin,
        "open_hand_escapes": _opened_escapes(problem, plan, options),
    }


def gauss_linking(problem: clasp.Problem, plan: core.Plan) -> list[float]:
    """Returns |Gauss linking integral| of each open finger curve with the loop (Fig. 6)."""
    robot, hand = problem.robot, problem.hand
    poses = robot.forward(plan.segments[-1].positions[-1])
    loop = frames.transform(problem.X_WO, problem.object.loops.found[plan.loop].points)

    def corners(finger: clasp.Finger) -> list[frames.Matrix]:
        return [frames.transform(poses[robot.frame(n.link)], n.p_L) for n in finger.nodes]

    thumb = corners(hand.thumb)
    curves = [np.array(corners(finger)[::-1] + thumb) for finger in hand.fingers]
    return [abs(geometry.gauss_linking(loop, curve, b_is_closed=False)) for curve in curves]


def _opened_escapes(problem: clasp.Problem, plan: core.Plan, options: clasp.Options) -> bool:
    """Runs the negative control: the same arm with the hand open."""
    robot, hand = problem.robot, problem.hand
    q = np.array(plan.segments[-1].positions[-1])
    joints = robot.group(hand.hand)
    q[joints] = robot.state(hand.open)[joints]
    return clasp.test_stability(problem, q, plan.loop, options.stability).escapes > 0


def totals(rows: Sequence[Row]) -> Row:
    """Returns the counts of Section V-A over all rows."""
    found = [row for row in rows if row["found"]]
    cycles = [row["cycles"] for row in found] + [math.inf] * (len(rows) - len(found))
    seconds = [row["seconds"] for row in rows]
    return {
        "tasks": len(rows),
        "found": len(found),
        f"within_{CYCLES_OF_ALL}_cycles": sum(c <= CYCLES_OF_ALL for c in cycles),
        f"under_{FEW_CYCLES}_cycles": sum(c < FEW_CYCLES for c in cycles),
        "median_cycles": _finite(statistics.median(cycles)) if rows else None,
        "max_cycles": _finite(max(cycles)) if rows else None,
        "median_seconds": statistics.median(seconds) if rows else None,
        "max_seconds": max(seconds, default=None),
        "secure": sum(row["secure"] for row in found),
        "insecure_clasps_refused": sum(row["insecure_clasps"] for row in rows),
        "open_hand_escapes": sum(bool(row["open_hand_escapes"]) for row in found),
        "faults": sum(bool(row["faults"]) for row in found),
    }


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def complaints(rows: Iterable[Row]) -> list[str]:
    """Returns the plans that fail their check()."""
    return [
        f"{row['hand']}, {row['object']}, pose {row['pose']}, seed {row['seed']}: {fault}"
        for row in rows
        for fault in row["faults"][:3]
    ]
