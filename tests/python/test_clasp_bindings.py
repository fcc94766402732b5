# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The clasp planner from Python: numpy in and out, errors that name what is wrong, no lock held."""

import threading
import time

import numpy as np
import pytest

from clasp_common import X_WO, arm_and_hand, problem, purse
from graspless import clasp, collision, geometry
from graspless.planning import Budget

ENDLESS = clasp.Options(min_linking=0.999)  # no hand closes so far around a handle


@pytest.fixture(scope="module")
def plan():
    found = clasp.plan(problem(), budget=Budget(seconds=20, seed=3))
    assert found, found.reason
    return found


def test_structs_take_their_fields_as_keywords():
    options = clasp.Options(targets=9, stability=clasp.StabilityOptions(moves=100))
    assert (options.targets, options.resolution) == (9, 0.01)
    assert options.stability.moves == 100
    assert "targets=9" in repr(options)
    tip = clasp.CurveNode(link="finger", p_L=[0, 0, 0.05])
    finger = clasp.Finger(name="index", nodes=[clasp.CurveNode(link="palm"), tip])
    hand = clasp.Hand(fingers=[finger], thumb=finger, sideways_H=[1, 0, 0])
    assert hand.fingers[0].nodes[1].link == "finger"
    np.testing.assert_array_equal(hand.fingers[0].nodes[1].p_L, [0, 0, 0.05])
    np.testing.assert_array_equal(hand.sideways_H, [1, 0, 0])
    for struct in (clasp.Options, clasp.Hand, clasp.Stability, clasp.StabilityOptions):
        with pytest.raises(TypeError, match="incompatible"):
            struct(unknown=1)


def test_hand_of_a_file_and_of_text_are_the_same():
    robot, hand, _ = arm_and_hand()
    assert [finger.name for finger in hand.fingers] == ["finger_1", "finger_2"]
    assert hand.thumb.nodes[0].link == "palm"
    clasp.validate(hand, robot)
    with pytest.raises(ValueError, match="my_hand"):
        clasp.hand_from_yaml("fingers: 3", what="my_hand")


def test_object_knows_its_loops():
    thing = purse()
    assert thing.points.shape == (2000, 3)
    assert len(thing.loops.found) == 1
    assert thing.loops.found[0].points.shape[1] == 3
    assert thing.surface.triangles.shape[1] == 3
    assert 0 < thing.spacing < 0.05
    assert isinstance(thing.loop_options, geometry.LoopOptions)
    assert repr(thing) == "<Object 'purse' of 2000 points and 1 loops>"


def test_sample_objects():
    names = clasp.sample_object_names()
    assert list(names) == ["purse", "bag", "travel_bag", "lawn_mower", "chair"]
    shapes = clasp.sample_object("bag", scale=0.5)
    assert isinstance(shapes[0], geometry.PlacedShape)
    with pytest.raises(ValueError, match="travel_bag"):
        clasp.sample_object("basket")


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: clasp.Object.from_cloud("x", np.zeros((30, 2))), r"p_OP has shape \(30, 2\)"),
        (lambda: clasp.Object.from_cloud("x", np.zeros((30, 3))), "point"),
        (lambda: clasp.Object.from_cloud("x", np.full((30, 3), np.nan)), "nan nan nan"),
        (lambda: problem(q_start=[0, 0]), r"q_start has shape \(2,\)"),
        (lambda: problem(X_WO=np.zeros((4, 4))), "X_WO is not a rigid transform"),
        (lambda: problem(marks=[[0, 0]]), r"marks has shape \(1, 2\)"),
        (lambda: problem(pull_W=[0, 0]), r"pull_W has shape \(2,\)"),
        (lambda: clasp.validate(problem(loops=[3])), "loops"),
        (lambda: clasp.validate(problem(pull_W=[0, 0, 0])), "pull_W"),
        (lambda: clasp.validate(clasp.Options(min_linking=2)), "min_linking"),
        (
            lambda: clasp.Segment(
                "reach", np.zeros((2, 12)), np.zeros((2, 4, 4)), np.zeros((3, 2))
            ),
            "reach.*2 positions",
        ),
        (lambda: clasp.plan(problem(), clasp.Options(targets=-1)), "targets"),
        (lambda: clasp.test_stability(problem(), np.zeros(12), 7), "loop"),
        (lambda: clasp.test_stability(problem(), np.zeros(3), 0), r"q has shape \(3,\)"),
    ],
)
def test_bad_input_is_a_value_error_that_names_it(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_problem_gives_back_what_it_was_given():
    cup = collision.Obstacle("cup", clasp.sample_object("purse"))
    given = problem(obstacles=[cup], loops=[0], marks=[[0, 0, 0.3]], pull_W=[0, 0, 1])
    np.testing.assert_allclose(given.X_WO, X_WO)
    np.testing.assert_array_equal(given.marks, [[0, 0, 0.3]])
    np.testing.assert_array_equal(given.pull_W, [0, 0, 1])
    assert [obstacle.name for obstacle in given.obstacles] == ["cup"]
    assert given.loops == [0]
    assert problem().pull_W is None
    assert problem().marks.shape == (0, 3)


def test_plans_and_holds(plan):
    assert [segment.name for segment in plan.segments] == ["reach", "close"]
    for segment in plan.segments:
        assert segment.positions.shape == (len(segment), 12)
        assert segment.virtual_linking.shape == (len(segment), 2)
    assert plan.segments[-1].virtual_linking[-1].min() >= plan.min_linking
    assert plan.stability.secure
    assert plan.loop == 0
    assert plan.tree.p_W.shape == (len(plan.tree), 3)
    assert plan.tree.parents[0] == 0
    assert clasp.check(problem(), plan) == []


def test_same_seed_gives_the_same_plan(plan):
    again = clasp.plan(problem(), budget=Budget(seconds=20, seed=3))
    for mine, theirs in zip(plan.segments, again.segments, strict=True):
        np.testing.assert_array_equal(mine.positions, theirs.positions)
        np.testing.assert_array_equal(mine.virtual_linking, theirs.virtual_linking)
    np.testing.assert_array_equal(plan.tree.p_W, again.tree.p_W)


def test_plan_can_be_rebuilt(plan):
    made = clasp.Plan()
    assert not made
    made.status, made.joint_names = plan.status, plan.joint_names
    made.segments = [
        clasp.Segment(s.name, s.positions, s.object_poses, s.virtual_linking) for s in plan.segments
    ]
    made.loop, made.target, made.min_linking = plan.loop, plan.target, plan.min_linking
    made.stability = plan.stability
    made.tree = clasp.Tree(plan.tree.p_W, plan.tree.parents, plan.tree.path)
    assert clasp.check(problem(), made) == []
    made.segments = made.segments[::-1]
    assert clasp.check(problem(), made)
    made.statistics = clasp.Statistics(cycles=7, refusals={"collision": 2})
    stats = made.statistics.as_dict()
    assert (stats["cycles"], stats["refusals"]) == (7, {"collision": 2})


def test_an_optional_part_outlives_its_plan():
    plan = clasp.Plan()
    plan.status = clasp.Status.solved
    plan.certificate = clasp.Certificate(between=("palm of the hand", "tip of a long finger"))
    part = plan.certificate
    plan.certificate = None
    assert list(part.between) == ["palm of the hand", "tip of a long finger"]


def test_clasp_is_secure_and_the_open_hand_is_not(plan):
    robot, hand, _ = arm_and_hand()
    q = plan.segments[-1].positions[-1]
    held = clasp.test_stability(problem(), q, plan.loop)
    assert held.secure
    assert held.margin == plan.stability.margin
    opened = q.copy()
    joints = list(robot.group(hand.hand))
    opened[joints] = np.array(robot.state(hand.open))[joints]
    lost = clasp.test_stability(problem(), opened, plan.loop)
    assert not lost.secure
    assert lost.escapes > 0
    assert lost.margin <= 0


def test_a_hand_in_the_object_is_not_tested(plan):
    beside = problem()
    moved = np.array(beside.X_WO)
    moved[0, 3] += 0.03
    robot, hand, _ = arm_and_hand()
    within = clasp.Problem(robot, hand, beside.object, moved, beside.q_start)
    blocked = clasp.test_stability(within, plan.segments[-1].positions[-1], plan.loop)
    assert not blocked.secure
    assert (blocked.escapes, blocked.checks, blocked.withstands) == (0, 0, 0)


def test_a_search_that_the_time_ended_says_so():
    late = clasp.plan(problem(), ENDLESS, Budget(seconds=0.2))
    assert "; the time limit ended the search; most often: " in late.reason
    whole = clasp.plan(problem(), ENDLESS, Budget(seconds=60, iterations=3))
    assert (late.status, whole.status) == (clasp.Status.not_found, clasp.Status.not_found)
    assert "time" not in whole.reason


def test_other_threads_run_meanwhile():
    budget = Budget(seconds=60)
    threading.Timer(0.3, budget.stop).start()
    start = time.monotonic()
    found = clasp.plan(problem(), ENDLESS, budget)
    assert found.status is clasp.Status.interrupted
    assert time.monotonic() - start < 10
