# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Structs from keywords, plans rebuilt in Python, queries that other threads and Ctrl-C reach."""

import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

from graspless import slide
from graspless.planning import Budget
from graspless.slide import (
    FingerModel,
    Hand,
    Object,
    Obstacle,
    Options,
    Plan,
    Problem,
    Search,
    Segment,
    Statistics,
    Status,
    Support,
)

SQUARE = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
ENDLESS = Options(min_overhang=0.0999, com_margin=0.04)  # no pair of the card can be valid


def test_structs_take_their_fields_as_keywords():
    options = Options(search=Search.paper, min_depth=0.001)
    assert options.search is Search.paper
    assert (options.min_depth, options.max_depth) == (0.001, None)
    assert "min_depth=0.001" in repr(options)
    hand = Hand(finger_model=FingerModel.none, fingers=["a", "b"])
    assert hand.fingers == ("a", "b")
    hand.fingers = ["c"]
    assert hand.fingers == ("c",)
    for struct in (Options, Hand, Statistics, Budget):
        with pytest.raises(TypeError, match="incompatible"):
            struct(unknown=1)
        with pytest.raises(TypeError, match="incompatible"):
            struct(1)


def test_a_center_of_mass_lies_in_the_hull_of_the_outline():
    wedge = Object.prism("wedge", [[-0.06, -0.04], [0.06, -0.04], [-0.06, 0.04]], 0.003)
    for com in ([0, 0, 0.001], [-0.06, 0.04, 0.003], [0.02 + 1e-17, -0.04 / 3 + 1e-15, 0]):
        np.testing.assert_array_equal(wedge.with_com(com).com, com)
    for com in ([0.05, 0.035, 0.001], [-0.061, 0, 0.001], [0, 0, -0.001], [0, 0, 0.004]):
        with pytest.raises(ValueError, match="convex hull of the outline of object 'wedge', at a"):
            wedge.with_com(com)


def test_objects_from_outline_and_cloud():
    card = Object.from_polygon("card", 0.05 * SQUARE, 0.002)
    assert card.points.shape[1] == 2
    np.testing.assert_allclose(card.com, [0, 0, 0.001], atol=1e-9)
    assert card.with_mass(0.5).mass == 0.5
    assert card.with_com([0.01, 0, 0]).com[0] == 0.01
    assert card.scaled(0.5).outline.area == pytest.approx(card.outline.area / 4)
    cloud = Object.from_cloud("cloud", np.c_[card.points, np.full(len(card.points), 0.002)])
    assert cloud.thickness == pytest.approx(0.002)
    np.testing.assert_allclose(slide.center_of_mass([[0, 0, 0], [1, 0, 0]], [1, 3]), [0.75, 0, 0])


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Object.from_polygon("x", [[0, 0]], 0.01), "outline"),
        (lambda: Object.from_polygon("x", "square", 0.01), "outline must be a Polygon or an array"),
        (lambda: Object.from_polygon("x", SQUARE, -1), "thickness"),
        (lambda: Object.from_cloud("x", [[0, 0]]), r"p_OP has shape \(1, 2\)"),
        (lambda: Object.from_cloud("x", np.zeros((0, 3))), "p_OP|points"),
        (lambda: Support(SQUARE, np.diag([1, -1, -1, 1])), "tilt|60"),
        (lambda: Support(SQUARE, np.eye(4), slab=0), "slab"),
        (lambda: Segment("slide", np.zeros((2, 8)), [np.eye(4)]), "slide.*2 positions but 1"),
        (lambda: Segment("slide", np.zeros(8), [np.eye(4)]), r"positions has shape \(8,\)"),
        (lambda: slide.center_of_mass([[0, 0, 0]], [1, 2]), "mass"),
        (lambda: slide.validate(Options(min_depth=0.05, max_depth=0.04)), "min_depth.*max_depth"),
        (lambda: Budget(seconds=0), "seconds"),
        (lambda: Budget(seconds=float("nan")), "seconds"),
        (lambda: Budget(iterations=-1), "iterations"),
    ],
)
def test_bad_input_is_a_value_error_that_names_it(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_problem_checks_sizes(wam, card_problem):
    card, support, X_WO = card_problem.object, card_problem.support, card_problem.X_WO_start
    with pytest.raises(ValueError, match=r"q_home has shape \(3,\)"):
        Problem(wam, Hand(), card, support, X_WO, [0, 0, 0])
    cup = Obstacle("cup", card.shapes)
    crowded = Problem(wam, Hand(), card, support, X_WO, card_problem.q_home, [cup])
    assert [obstacle.name for obstacle in crowded.obstacles] == ["cup"]
    bad = Problem(wam, Hand(arm="arms"), card, support, X_WO, card_problem.q_home)
    with pytest.raises(ValueError, match="arms"):
        slide.validate(bad)


def test_plan_can_be_rebuilt():
    plan = Plan()
    assert not plan
    plan.status = Status.solved
    plan.segments = [Segment("slide", np.ones((3, 8)), np.tile(np.eye(4), (3, 1, 1)))]
    plan.joint_names = ["a"]
    plan.statistics = Statistics(nodes=7, refusals={"start: reach": 2})
    plan.statistics.pairs = 3
    assert plan
    assert plan.segments[0].positions.shape == (3, 8)
    assert plan.segments[0].object_poses.shape == (3, 4, 4)
    assert len(plan.segments[0]) == 3
    stats = plan.statistics.as_dict()
    assert (stats["nodes"], stats["pairs"], stats["refusals"]) == (7, 3, {"start: reach": 2})
    with pytest.raises(AttributeError):
        plan.segments.append(None)
    with pytest.raises(ValueError, match="X_WO_goal"):
        plan.X_WO_goal = np.zeros((4, 4))


def test_plans_and_repeats(card_problem):
    first, second = (slide.plan(card_problem, budget=Budget(seconds=20, seed=3)) for _ in range(2))
    assert first, first.reason
    assert slide.check(card_problem, first) == []
    assert [segment.name for segment in first.segments][:3] == ["approach", "press", "slide"]
    for a, b in zip(first.segments, second.segments, strict=True):
        np.testing.assert_array_equal(a.positions, b.positions)
        np.testing.assert_array_equal(a.object_poses, b.object_poses)


def test_arrays_that_are_copies_cannot_be_changed(card_problem):
    """Else the change would be lost without a word."""
    segment = Segment("slide", np.ones((3, 8)), np.tile(np.eye(4), (3, 1, 1)))
    ended = Problem(
        card_problem.robot, Hand(), card_problem.object, card_problem.support,
        card_problem.X_WO_start, card_problem.q_home, X_WO_end=np.eye(4),
    )  # fmt: skip
    support = card_problem.support
    arrays = [segment.positions, segment.object_poses, ended.X_WO_start, ended.X_WO_end]
    arrays += [
        ended.q_home,
        ended.object.com,
        support.X_WS,
        support.polygon.vertices,
        Plan().X_WO_goal,
    ]
    for array in arrays:
        with pytest.raises(ValueError, match="read-only"):
            array[:] = 0
    positions = segment.positions.copy()
    positions[0] = 2
    assert Segment("slide", positions, segment.object_poses).positions[0, 0] == 2


def test_a_plan_of_other_motions_does_not_hold(card_problem):
    plan = slide.plan(card_problem, budget=Budget(seconds=20))
    plan.segments = plan.segments[::-1]
    assert slide.check(card_problem, plan)


def test_seconds_are_kept(card_problem):
    start = time.perf_counter()
    plan = slide.plan(card_problem, ENDLESS, Budget(seconds=0.2))
    assert not plan
    assert plan.reason
    assert time.perf_counter() - start < 0.2 + 0.15


def test_other_threads_run_meanwhile(card_problem):
    ticks = []

    def count():
        while not done.wait(0.01):
            ticks.append(time.perf_counter())

    done = threading.Event()
    thread = threading.Thread(target=count)
    thread.start()
    slide.plan(card_problem, ENDLESS, Budget(seconds=0.5))
    done.set()
    thread.join()
    assert len(ticks) > 10


def test_a_search_that_the_time_ended_says_so(card_problem):
    late = slide.plan(card_problem, ENDLESS, Budget(seconds=0.1))
    assert "; the time limit ended the search; most frequent rejections: " in late.reason
    whole = slide.plan(card_problem, ENDLESS, Budget(seconds=60, iterations=20))
    assert not late
    assert not whole
    assert "time" not in whole.reason


def test_stop_from_another_thread(card_problem):
    budget = Budget(seconds=30)
    timer = threading.Timer(0.2, budget.stop)
    timer.start()
    start = time.perf_counter()
    plan = slide.plan(card_problem, ENDLESS, budget)
    assert time.perf_counter() - start < 0.2 + 0.3
    assert plan.status is Status.interrupted
    assert budget.is_stopped
    timer.join()


def test_ctrl_c_raises_keyboard_interrupt(card_problem):
    signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_REAL, 0.2)
    start = time.perf_counter()
    try:
        with pytest.raises(KeyboardInterrupt):
            slide.plan(card_problem, ENDLESS, Budget(seconds=30))
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
    assert time.perf_counter() - start < 0.2 + 0.3


TWO_THREADS = """
import threading, time
import numpy as np
import graspless
from graspless import _data, collision, geometry, slide

around, across = np.meshgrid(*(np.arange(n) * 2 * np.pi / n for n in (400, 250)), indexing="ij")
radius = 2 + 0.8 * np.cos(across)
ring = radius * np.cos(around), radius * np.sin(around), 0.8 * np.sin(across)
i = np.arange(around.size).reshape(around.shape)
j, k, diagonal = np.roll(i, -1, 0), np.roll(i, -1, 1), np.roll(np.roll(i, -1, 0), -1, 1)
triangles = np.stack([i, j, diagonal, i, diagonal, k], -1).reshape(-1, 3)
mesh = geometry.Mesh(np.stack(ring, -1).reshape(-1, 3), triangles)
task = graspless.load_task(_data.directory("examples") / "01_slide_card.yaml")
given = task.problem
obstacles = [slide.Obstacle("ring", [geometry.PlacedShape(mesh)])]
problem = slide.Problem(given.robot, given.hand, given.object, given.support, given.X_WO_start,
                        given.q_home, obstacles)
plan = slide.plan(given, task.options)
world = collision.World()
world.add_body("ring", [geometry.PlacedShape(mesh)])
world.add_body("ball", [geometry.PlacedShape(geometry.Sphere(0.05))])
X = np.eye(4)
X[0, 3] = 2.8
world.set_pose("ball", X)
world.add_pair("ring", "ball")
thread = threading.Thread(target=lambda: slide.check(problem, plan, task.options))
thread.start()
time.sleep(WAIT)
print(world.collides())
thread.join()
"""


@pytest.mark.parametrize("wait", [0.02, 0.1])
def test_two_threads_may_need_the_same_mesh(wait):
    """One prepares it, and looks for Ctrl-C meanwhile; the other waits for it with the GIL."""
    program = TWO_THREADS.replace("WAIT", str(wait))
    command = [sys.executable, "-c", program]
    done = subprocess.run(command, timeout=120, capture_output=True, text=True, check=True)
    assert done.stdout == "True\n"
