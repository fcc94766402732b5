# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench edges`: what lies between the rows of slides, proven and sampled."""

from __future__ import annotations

import itertools
import json
import math
import time
from collections import Counter
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from graspless import collision, frames, geometry, scene, slide
from graspless._commands import FOUND, NOT_FOUND

from .arguments import positive
from .slide.grid import Start, Trial, among
from .slide.shapes import OBJECTS, TABLES

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator

    from numpy.typing import NDArray

    Array = NDArray[np.float64]

FREE = ("approach", "reach", "grasp")  # segments in which nothing may touch
COARSE, FINE, ORACLE = 0.05, 0.01, 1e-4  # joint steps of samples [rad]
ORACLE_EDGES = 10  # of each plan
CLUTTER = "clutter"


class Edge(NamedTuple):
    """The straight motion to a row of a segment."""

    segment: str
    row: int
    before: Array
    after: Array

    def samples(self, step: float) -> Iterator[Array]:
        """Yields configurations at equal joint steps, both ends included."""
        pieces = max(1, math.ceil(np.abs(self.after - self.before).max() / step - 1e-9))
        for i in range(pieces + 1):
            yield self.before + (self.after - self.before) * i / pieces


def trials() -> Iterator[Trial]:
    """Yields problems with the library's own margins, over all tables and objects."""
    for index in itertools.count():
        for table, thing in itertools.product(TABLES, OBJECTS):
            yield Trial(Start(table, thing, 1.0, index, 14), defaults=True)


def edges_of(plan: Any) -> list[Edge]:
    """Returns the edges of the segments in which nothing may touch."""
    return [
        Edge(segment.name, row, segment.positions[row - 1], segment.positions[row])
        for segment in plan.segments
        if segment.name in FREE
        for row in range(1, len(segment))
    ]


def scene_of(problem: slide.Problem, X_WO: Array) -> scene.Scene:
    """Returns the robot among support, obstacles and the object at a pose."""
    bodies = scene.Scene(problem.robot)
    bodies.add_obstacle("support", problem.support.shapes, problem.support.X_WS)
    bodies.add_obstacle("object", problem.object.shapes, X_WO, touches_base=False)
    for obstacle in problem.obstacles:
        bodies.add_obstacle(obstacle.name, obstacle.shapes, obstacle.X_WB)
    return bodies


def cluttered(problem: slide.Problem, plan: Any, rng: np.random.Generator) -> slide.Problem:
    """Returns the problem with a ball beside the way of the hand."""
    edges = edges_of(plan)
    edge = edges[rng.integers(len(edges))]
    p = problem.robot.pose(problem.hand.grasp_frame, edge.after)[:3, 3]
    away = rng.normal(size=3)
    p = p + rng.uniform(0.02, 0.12) * away / np.linalg.norm(away)
    ball = geometry.PlacedShape(geometry.Sphere(float(rng.uniform(0.005, 0.03))))
    return among(problem, [collision.Obstacle(CLUTTER, [ball], frames.translation(p))])


def touches(bodies: scene.Scene, edge: Edge, step: float) -> bool:
    """True if a sample of an edge touches."""
    return any(bodies.collision(q) is not None for q in edge.samples(step))


def measure_clutter(
    trial: Trial, plan: Any, rng: np.random.Generator, counts: Counter[str]
) -> None:
    """Counts the edges beside a ball that samples let through and the certificate does not."""
    problem = cluttered(trial.make_problem(), plan, rng)
    found = slide.certify(problem, plan, trial.make_options())
    doubts = {(d.segment, d.row): d.verdict for d in found.doubts if CLUTTER in d.condition}
    places = {segment.name: segment.object_poses[0] for segment in plan.segments}
    for edge in edges_of(plan):
        verdict = doubts.get((edge.segment, edge.row))
        if verdict is None:
            continue
        counts[f"clutter: {verdict}"] += 1
        bodies = scene_of(problem, places[edge.segment])
        for step in (COARSE, FINE):
            counts[f"clutter: {verdict}, {step} rad sees nothing"] += not touches(
                bodies, edge, step
            )


def measure(trial: Trial, rng: np.random.Generator, counts: Counter[str]) -> float | None:
    """Plans, certifies and looks closely at some certified edges. Returns seconds of CPU time."""
    problem, options = trial.make_problem(), trial.make_options()
    plan = slide.plan(problem, options, trial.make_budget(10))
    if not plan:
        counts["not solved"] += 1
        return None
    counts["faulty"] += bool(slide.check(problem, plan, options))
    began = time.process_time()
    found = slide.certify(problem, plan, options)
    seconds = time.process_time() - began
    counts["plans"] += 1
    counts["certified plans"] += bool(found)
    counts["edges"] += found.num_edges
    counts["certified edges"] += found.num_certified
    for doubt in found.doubts:
        counts[f"{doubt.verdict}: {doubt.condition}"] += 1
    doubted = {(doubt.segment, doubt.row) for doubt in found.doubts}
    proven = [edge for edge in edges_of(plan) if (edge.segment, edge.row) not in doubted]
    places = {segment.name: segment.object_poses[0] for segment in plan.segments}
    for i in rng.choice(len(proven), min(ORACLE_EDGES, len(proven)), replace=False):
        bodies = scene_of(problem, places[proven[i].segment])
        counts["certified edges, sampled at 0.0001 rad"] += 1
        counts["violations"] += touches(bodies, proven[i], ORACLE)
    measure_clutter(trial, plan, rng, counts)
    return seconds


def add_parser(experiments: Any) -> None:
    """Adds `edges` to the experiments."""
    parser = experiments.add_parser(
        "edges",
        help="certificates of slides, and what samples miss",
        description="Plans slides with the WAM, certifies them, samples some certified edges "
        "at 0.0001 rad, and puts a ball beside the way of each: counts the edges that samples let "
        "through and the certificate refutes. Exit 1 when a sample violates a certificate.",
    )
    parser.add_argument("--plans", type=positive(int), default=300, metavar="N", help="(300)")
    parser.add_argument("--json", action="store_true", help="print the result as JSON")
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    counts: Counter[str] = Counter({"violations": 0})
    rng = np.random.default_rng(14)
    times = [measure(trial, rng, counts) for trial in itertools.islice(trials(), options.plans)]
    solved = [1e3 * seconds for seconds in times if seconds is not None]
    median, most = (float(np.quantile(solved, q)) for q in (0.5, 0.99))
    if options.json:
        print(json.dumps(dict(counts) | {"median_ms": median, "p99_ms": most}))
    else:
        for name, count in sorted(counts.items()):
            print(f"{count:8}  {name}")
        print(f"CPU time of a certificate: median {median:.1f} ms, 99 % {most:.1f} ms")
    return NOT_FOUND if counts["violations"] else FOUND
