# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slides that go on from a measured pose: law by law, and as files, pictures and trajectories."""

import json

import numpy as np
import pytest

import graspless
from graspless import TaskError, frames, report, slide
from graspless.planning import Budget
from tasks_common import GOOD, reread, without_clock

QUICK = Budget(seconds=10, seed=2)


@pytest.fixture(scope="module")
def plan(tmp_path_factory):
    path = tmp_path_factory.mktemp("task") / "task.yaml"
    path.write_text(GOOD)
    plan = graspless.plan(path)
    assert plan, plan.reason
    return plan


def slide_of(plan):
    return next(segment for segment in plan.segments if segment.name == "slide")


def state(plan, fraction=0.5, x=0.0, y=0.0, z=0.0, yaw=0.0):
    """Joints and object pose on the way, the latter disturbed."""
    way = slide_of(plan)
    k = int(fraction * (len(way) - 1))
    X_WO = frames.translation([x, y, z]) @ way.object_poses[k] @ frames.planar(0, 0, yaw)
    return way.positions[k], X_WO


@pytest.fixture(scope="module")
def rest(plan):
    rest = slide.resume(plan, *state(plan, x=0.006, y=-0.004, yaw=0.08), budget=QUICK)
    assert rest, rest.reason
    return rest


@pytest.mark.parametrize("fraction", [0.0, 0.3, 0.7, 1.0])
def test_goes_on_from_an_undisturbed_state(plan, fraction):
    q, X_WO = state(plan, fraction)
    rest = slide.resume(plan, q, X_WO, budget=QUICK)
    assert rest, rest.reason
    assert graspless.check(rest) == []
    assert [s.name for s in rest.segments] == ["slide", "lift", "reach", "grasp", "close"]
    np.testing.assert_array_equal(rest.segments[0].positions[0], q)
    np.testing.assert_allclose(rest.segments[0].object_poses[0], X_WO, atol=1e-9)
    np.testing.assert_allclose(rest.X_WO_goal, plan.X_WO_goal, atol=1e-6)


def test_goes_on_from_a_disturbed_state(plan, rest):
    assert graspless.check(rest) == []
    q, X_WO = state(plan, x=0.006, y=-0.004, yaw=0.08)
    np.testing.assert_allclose(rest.segments[0].object_poses[0], X_WO, atol=1e-9)
    np.testing.assert_array_equal(rest.resumed.q, q)
    np.testing.assert_allclose(rest.resumed.X_WO_goal, plan.X_WO_goal, atol=1e-12)
    assert plan.resumed is None


def test_keeps_the_goal_where_it_fits(plan):
    problem, kept = plan.task.problem, 0
    for seed in range(1, 9):
        whole = slide.plan(problem, budget=Budget(seconds=10, seed=seed))
        q, X_WO = state(whole, x=0.003, y=-0.002, yaw=0.08)
        rest = slide.resume(problem, q, X_WO, X_WO_goal=whole.X_WO_goal, budget=QUICK)
        assert rest, rest.reason
        kept += np.allclose(rest.X_WO_goal, whole.X_WO_goal, atol=1e-9)
    assert kept >= 6


def test_a_resumed_plan_is_resumed(rest):
    again = slide.resume(rest, *state(rest, 0.5, x=-0.003), budget=QUICK)
    assert again, again.reason
    assert graspless.check(again) == []
    assert again.task.problem is rest.task.problem


def test_takes_a_problem_in_place_of_a_plan(plan):
    q, X_WO = state(plan)
    problem, options = plan.task.problem, plan.task.options
    rest = slide.resume(problem, q, X_WO, options=options, budget=QUICK)
    assert rest.resumed.X_WO_goal is None
    assert graspless.check(rest) == []
    same = slide.resume(plan, q, X_WO, X_WO_goal=plan.X_WO_goal, budget=QUICK)
    assert same.X_WO_goal.tolist() == slide.resume(plan, q, X_WO, budget=QUICK).X_WO_goal.tolist()


def test_same_seed_same_plan(plan):
    at = state(plan, x=0.006, y=-0.004, yaw=0.08)
    first, second = (slide.resume(plan, *at, budget=QUICK) for _ in range(2))
    assert without_clock(first) == without_clock(second)


def test_file_keeps_where_it_goes_on(rest, tmp_path):
    rest.save(tmp_path / "rest.json")
    again = graspless.load_plan(tmp_path / "rest.json")
    assert again == rest
    assert again.to_json() == rest.to_json()
    assert graspless.check(tmp_path / "rest.json") == []
    np.testing.assert_array_equal(again.resumed.q, rest.resumed.q)
    np.testing.assert_allclose(again.X_WO_start, rest.X_WO_start, atol=1e-12)


@pytest.mark.parametrize(
    ("edit", "fault"),
    [
        (lambda d: d.pop("resumed"), "segments are not approach"),
        (lambda d: d["resumed"]["q"].__setitem__(0, 1.0), "was interrupted"),
        (lambda d: d["resumed"]["X_WO"].__setitem__(0, 0.5), "not at its start"),
        (lambda d: d["resumed"]["X_WO"].__setitem__(2, 0.1), "does not lie flat"),
    ],
)
def test_check_finds_edits_of_the_state(rest, tmp_path, edit, fault):
    document = json.loads(rest.to_json())
    edit(document)
    assert any(fault in found for found in graspless.check(reread(document, tmp_path / "p.json")))


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ({"q": [0.0], "X_WO": [0, 0, 0, 1, 0, 0, 0]}, "resumed.q has 1 values"),
        ({"q": [0.0] * 15, "X_WO": [0, 0, 0, 2, 0, 0, 0]}, "unit length"),
        ({"X_WO": [0, 0, 0, 1, 0, 0, 0]}, "q"),
    ],
)
def test_bad_states_in_files_are_refused(rest, tmp_path, value, message):
    document = json.loads(rest.to_json())
    if len(value.get("q", ())) > 1:
        value["q"] = document["resumed"]["q"]
    document["resumed"] = value
    with pytest.raises(TaskError, match=message):
        reread(document, tmp_path / "p.json")


def test_is_timed_drawn_and_reported(rest):
    trajectory = graspless.time(rest)
    np.testing.assert_allclose(trajectory.positions[0], rest.segments[0].positions[0], atol=1e-12)
    assert trajectory.names[0] == "slide"
    rest.plot()
    assert "slides" in report.as_text(rest)


@pytest.mark.parametrize(
    ("disturbed", "status", "reason"),
    [
        ({"z": 0.03}, "off_support", "30 mm above the support"),
        ({"x": 0.3}, "contact_lost", "beside the object"),
    ],
)
def test_lost_objects_are_a_status(plan, disturbed, status, reason):
    rest = slide.resume(plan, *state(plan, **disturbed), budget=QUICK)
    assert not rest
    assert rest.status == status
    assert reason in rest.reason
    assert list(rest.segments) == []
    assert reason in rest.to_json()
    rest.plot()


def test_the_simulation_refuses_what_does_not_begin_at_rest(rest):
    pytest.importorskip("mujoco")
    from graspless.simulation import slide as simulated
    from graspless.simulation.variation import Variation

    for simulate in (
        lambda: graspless.simulate(rest),
        lambda: graspless.simulate(rest, closed_loop=True),
        lambda: simulated.start(rest, Variation()),
    ):
        with pytest.raises(TaskError, match="simulate the plan that was interrupted"):
            simulate()


def test_lost_contact_is_a_status(plan):
    _, X_WO = state(plan)
    rest = slide.resume(plan, plan.task.problem.q_home, X_WO, budget=QUICK)
    assert rest.status == "contact_lost"
    assert "above the object's top face" in rest.reason


@pytest.mark.parametrize("y", [0.0, 0.15])
def test_restarts_where_the_contact_is_lost(plan, tmp_path, y):
    q, X_WO = state(plan, y=y)
    anew = slide.restart(plan, q, X_WO, budget=QUICK)
    assert anew, anew.reason
    assert graspless.check(anew) == []
    names = ["retreat", "approach", "press", "slide", "lift", "reach", "grasp", "close"]
    assert [s.name for s in anew.segments] == names
    np.testing.assert_array_equal(anew.segments[0].positions[0], q)
    np.testing.assert_allclose(anew.segments[1].object_poses[0], X_WO, atol=1e-9)
    assert anew.resumed.X_WO_goal is None
    anew.save(tmp_path / "anew.json")
    assert graspless.check(tmp_path / "anew.json") == []
    trajectory = graspless.time(anew)
    np.testing.assert_allclose(trajectory.positions[0], q, atol=1e-12)
    assert "retreat" in report.as_text(anew)


def test_restarts_from_home(plan):
    _, X_WO = state(plan)
    anew = slide.restart(plan, plan.task.problem.q_home, X_WO, budget=QUICK)
    assert anew, anew.reason
    assert graspless.check(anew) == []
    assert graspless.time(anew).duration > 0


def test_does_not_let_the_object_fall(plan):
    q, X_WO = state(plan)
    X_WO[1, 3] = 0.355
    anew = slide.restart(plan, q, X_WO, budget=QUICK)
    assert anew.status == "off_support"
    assert "falls" in anew.reason


def test_mistakes_raise(plan):
    q, X_WO = state(plan)
    for bad, match in [
        ((q[:3], X_WO), "q must have"),
        ((np.full_like(q, np.nan), X_WO), "q"),
        ((q, np.eye(3)), "X_WO"),
        ((q, 2 * X_WO), "X_WO"),
        ((q, np.full((4, 4), np.inf)), "X_WO"),
    ]:
        for again in (slide.resume, slide.restart):
            with pytest.raises(ValueError, match=match):
                again(plan, *bad, budget=QUICK)
