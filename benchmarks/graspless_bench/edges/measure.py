# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Edges between the rows of plans: certified, sampled, and with a ball beside them."""

from __future__ import annotations

import math
import time
from collections import Counter
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from graspless import collision, frames, geometry

from .kinds import FREE

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from graspless.collision import Obstacle
    from graspless.scene import Scene

    from .kinds import Case

    Array = NDArray[np.float64]

COARSE, FINE, ORACLE = 0.05, 0.01, 1e-4  # joint steps of samples [rad]
ORACLE_EDGES = 10  # of each plan
CLUTTER, TRIES = "clutter", 100
OBJECT = "object -"  # in a condition: the object that rests


class Edge(NamedTuple):
    """The straight motion to a row of a segment."""

    segment: Any
    row: int

    def samples(self, step: float) -> Iterator[Array]:
        """Yields configurations at equal joint steps, both ends included."""
        before, after = self.segment.positions[self.row - 1 : self.row + 1]
        pieces = max(1, math.ceil(np.abs(after - before).max() / step - 1e-9))
        for i in range(pieces + 1):
            yield before + (after - before) * i / pieces


def edges_of(plan: Any) -> list[Edge]:
    """Returns the edges of the segments in which nothing may touch."""
    return [
        Edge(segment, row)
        for segment in plan.segments
        if segment.name in FREE
        for row in range(1, len(segment))
    ]


def touches(bodies: Scene, edge: Edge, step: float) -> bool:
    """True if a sample of an edge touches."""
    return any(bodies.collision(q) is not None for q in edge.samples(step))


def clutter(case: Case, plan: Any, rng: np.random.Generator) -> list[Obstacle]:
    """Returns a ball beside the way of the hand."""
    edges = edges_of(plan)
    edge = edges[rng.integers(len(edges))]
    p = case.robot.pose(case.frame, edge.segment.positions[edge.row])[:3, 3]
    away = rng.normal(size=3)
    p = p + rng.uniform(0.02, 0.12) * away / np.linalg.norm(away)
    ball = geometry.PlacedShape(geometry.Sphere(float(rng.uniform(0.005, 0.03))))
    return [collision.Obstacle(CLUTTER, [ball], frames.translation(p))]


def measure_clutter(case: Case, plan: Any, rng: np.random.Generator, counts: Counter[str]) -> None:
    """Counts the edges beside a ball that samples let through and the certificate does not."""
    edges = edges_of(plan)
    for _ in range(TRIES):
        ball = clutter(case, plan, rng)
        try:
            found = case.planner.certify(case.among(ball), plan, case.options)
        except ValueError:  # the object of a fingertip plan touches it
            continue
        doubts = {(d.segment, d.row): d for d in found.doubts if CLUTTER in d.condition}
        beside = [(e, doubts[key]) for e in edges if (key := (e.segment.name, e.row)) in doubts]
        if not any(OBJECT in doubt.condition for _, doubt in beside):
            break  # a ball within the object, which rests there, would be in nobody's way
    else:
        return
    for edge, doubt in beside:
        counts[f"clutter: {doubt.verdict}"] += 1
        bodies = case.bodies(ball, edge.segment)
        for step in (COARSE, FINE):
            counts[f"clutter: {doubt.verdict}, {step} rad sees nothing"] += not touches(
                bodies, edge, step
            )


def measure(case: Case, rng: np.random.Generator, counts: Counter[str]) -> float | None:
    """Plans, certifies and looks closely at some certified edges. Returns seconds of CPU time."""
    plan = case.planner.plan(case.problem, case.options, case.budget)
    if not plan:
        counts["not solved"] += 1
        return None
    counts["faulty"] += bool(case.planner.check(case.problem, plan, case.options))
    began = time.process_time()
    found = case.planner.certify(case.problem, plan, case.options)
    seconds = time.process_time() - began
    counts["plans"] += 1
    counts["certified plans"] += bool(found)
    counts["edges"] += found.num_edges
    counts["certified edges"] += found.num_certified
    for doubt in found.doubts:
        counts[f"{doubt.verdict}: {doubt.condition}"] += 1
    doubted = {(doubt.segment, doubt.row) for doubt in found.doubts}
    proven = [edge for edge in edges_of(plan) if (edge.segment.name, edge.row) not in doubted]
    for i in rng.choice(len(proven), min(ORACLE_EDGES, len(proven)), replace=False):
        counts["certified edges, sampled at 0.0001 rad"] += 1
        bodies = case.bodies([], proven[i].segment)
        counts["violations"] += touches(bodies, proven[i], ORACLE)
    measure_clutter(case, plan, rng, counts)
    return seconds
