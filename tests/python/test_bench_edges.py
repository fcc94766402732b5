# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark of edges: its oracle sees what stands in the way."""

import collections
import json

import numpy as np
import pytest

from graspless import collision, frames, geometry
from graspless.cli import main
from graspless_bench.edges import kinds, measure


@pytest.fixture(scope="module", params=["slide", "pinch", "carry", "fingertip"])
def planned(request):
    case = next(kinds.MAKERS[request.param]())
    plan = case.planner.plan(case.problem, case.options, case.budget)
    assert plan
    return case, plan


def ball_at(X):
    shapes = [geometry.PlacedShape(geometry.Sphere(0.004))]
    return [collision.Obstacle(measure.CLUTTER, shapes, frames.translation(X[:3, 3]))]


def test_a_ball_in_the_way_is_seen(planned):
    case, plan = planned
    edges = measure.edges_of(plan)
    edge = edges[len(edges) // 2]
    assert not measure.touches(case.bodies([], edge.segment), edge, measure.FINE)
    hand = case.robot.pose("wam_link_7", edge.segment.positions[edge.row])
    assert measure.touches(case.bodies(ball_at(hand), edge.segment), edge, measure.FINE)


def test_a_held_object_is_tested_against_obstacles():
    case = next(kinds.MAKERS["carry"]())
    p = case.problem
    plan = case.planner.plan(p, case.options, case.budget)
    edge = measure.edges_of(plan)[-1]
    X_FO = np.linalg.inv(p.robot.pose(p.frame, p.q_start)) @ p.object.X_WB
    end = p.robot.pose(p.frame, edge.segment.positions[edge.row]) @ X_FO
    low = end @ frames.translation([0, 0, -0.045])  # in the bar, below the fingers
    assert measure.touches(case.bodies(ball_at(low), edge.segment), edge, measure.FINE)


def test_clutter_does_not_stand_in_the_object(planned):
    case, plan = planned
    counts = collections.Counter()
    for seed in range(5):
        measure.measure_clutter(case, plan, np.random.default_rng(seed), counts)
    refuted = counts["clutter: refuted"]
    assert refuted > 0
    assert counts[f"clutter: refuted, {measure.FINE} rad sees nothing"] < 0.1 * refuted


@pytest.mark.parametrize("kind", kinds.MAKERS)
def test_no_sample_violates_a_certificate(kind, capsys):
    assert main(["bench", "edges", "--kind", kind, "--plans", "2", "--json"]) == 0
    counts = json.loads(capsys.readouterr().out)
    assert counts["violations"] == 0
    assert counts["certified edges, sampled at 0.0001 rad"] > 0
    assert counts["plans"] == 2
