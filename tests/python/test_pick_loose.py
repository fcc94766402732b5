# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bags that are clasped by their handle, carried as they hang, and put down."""

import itertools
import json
from types import SimpleNamespace

import numpy as np
import pytest

import graspless
from graspless import clasp, frames, geometry, perception
from graspless.errors import TaskError
from graspless.picking import loose
from graspless.plan_files import plan_of
from graspless.plan_files.text import document_of
from pick_common import TABLE, body

BAG = ([0.24, 0.10, 0.20], [0, 0, 0.1])
HANDLE = (
    ([0.018, 0.018, 0.11], [-0.065, 0, 0.25]),
    ([0.018, 0.018, 0.11], [0.065, 0, 0.25]),
    ([0.148, 0.018, 0.018], [0, 0, 0.296]),
)
START, END = (0.6, 0.17, 0.4), (0.6, -0.2, 0.2)


def bag(x, y, yaw):
    """A bag of boxes, 30 cm high with its handle."""
    shapes = [
        geometry.PlacedShape(geometry.Box(size), frames.translation(place))
        for size, place in (BAG, *HANDLE)
    ]
    return perception.Body(shapes, frames.planar(x, y, yaw))


def seen(*others):
    """The perceived scene of a bag and others on a table, from two sides."""
    bodies = [body(*TABLE), body([6, 6, 0.02], 0.65, 0.0, -0.75), bag(*START), *others]
    eyes = ([0.0, -0.7, 0.8], [0.0, 0.8, 0.8])
    views = [perception.render(bodies, perception.look_at(eye, [0.6, 0.1, 0.15])) for eye in eyes]
    images = zip(*((view.depth, view.K, view.X_WC) for view in views), strict=True)
    return graspless.perceive(*(list(image) for image in images))


def name_of(scene):
    return min(scene.objects, key=lambda o: np.linalg.norm(o.X_WO[:2, 3] - START[:2])).name


ROBOT = {"urdf": "kr5_sdh", "pose": {"position": [0, 0, 0.15]}}


def picked(scene, place, **fields):
    given = {"strategies": ["clasp"], "seconds": 60, **fields}
    return graspless.pick(scene, name_of(scene), ROBOT, place=place, **given)


@pytest.fixture(scope="module")
def scene():
    return seen()


@pytest.fixture(scope="module")
def plan(scene):
    x, y, yaw = END
    found = picked(scene, {"pose": {"x": x, "y": y, "yaw": yaw}})
    assert found, found.reason
    return found.plan


def reloaded(plan, change=lambda document: None):
    document = json.loads(json.dumps(document_of(plan)))  # the plan keeps its own lists
    change(document)
    return plan_of(document, "plan")


def curves(problem, q):
    """Curves of the fingers from tip to tip in the world, and the loop."""
    hand, robot = problem.hand, problem.robot

    def points(finger):
        poses = [(robot.pose(robot.frame(node.link), q), node.p_L) for node in finger.nodes]
        return np.array([X[:3, :3] @ p + X[:3, 3] for X, p in poses])

    thumb = points(hand.thumb)
    return [np.concatenate([points(finger)[::-1], thumb]) for finger in hand.fingers]


def linked(plan, q, X_WO):
    """Number of fingers that are linked with the loop of the clasp."""
    grasp = plan.stages[0]
    loop = np.asarray(grasp.task.problem.object.loops.found[grasp.loop].points)
    prepared = geometry.PreparedLoop(loop @ X_WO[:3, :3].T + X_WO[:3, 3])
    return int(np.count_nonzero(prepared.linking_numbers(curves(grasp.task.problem, q))))


def test_a_bag_is_put_down(plan):
    assert plan.names == ["clasp", "lift", "place"]
    assert graspless.check(plan) == []
    end = plan.stages[-1].segments[-1].object_poses[-1]
    assert end[:2, 3] == pytest.approx(END[:2], abs=1e-3)
    assert np.arctan2(end[1, 0], end[0, 0]) == pytest.approx(END[2], abs=1e-3)
    assert end[2, 3] == pytest.approx(0.0, abs=2e-3)
    assert end[:3, 2] == pytest.approx([0, 0, 1], abs=5e-3)


def test_each_stage_begins_where_the_one_before_ended(plan):
    for before, after in itertools.pairwise(plan.stages):
        last, first = before.segments[-1], after.segments[0]
        assert first.positions[0] == pytest.approx(last.positions[-1], abs=1e-9)
        assert first.object_poses[0] == pytest.approx(last.object_poses[-1], abs=1e-9)


def test_the_object_goes_with_the_hand_and_then_rests(plan):
    robot, frame = plan.stages[0].task.problem.robot, plan.stages[1].task.problem.frame
    held = {}
    for stage in plan.stages[1:]:
        for segment in stage.segments:
            for q, X_WO in zip(segment.positions, segment.object_poses, strict=True):
                if segment.name in ("open", "retreat"):
                    assert pytest.approx(segment.object_poses[-1], abs=1e-9) == X_WO
                else:
                    X_FO = np.linalg.inv(robot.pose(robot.frame(frame), q)) @ X_WO
                    assert held.setdefault("X_FO", X_FO) == pytest.approx(X_FO, abs=1e-6)


def test_the_hand_is_out_of_the_handle_at_the_end(plan):
    last = plan.stages[-1].segments
    opened, retreat = last[-2], last[-1]
    assert linked(plan, opened.positions[0], opened.object_poses[0]) > 0
    assert linked(plan, retreat.positions[-1], retreat.object_poses[-1]) == 0


def test_it_hangs_on_the_way(plan):
    lift, place = plan.stages[1].task.problem, plan.stages[2].task.problem
    assert lift.X_WO_hanging is not None
    robot, frame = lift.robot, lift.robot.frame(lift.frame)
    in_hand = [
        np.linalg.inv(robot.pose(frame, problem.q_start)) @ problem.X_WO_hanging
        for problem in (lift, place)
    ]
    assert in_hand[1] == pytest.approx(in_hand[0], abs=1e-9)
    grasp = plan.stages[0]
    found = clasp.find_hang(grasp.task.problem, grasp.segments[-1].positions[-1], grasp.loop)
    assert found.holds
    assert pytest.approx(lift.X_WO_hanging, abs=1e-9) == found.X_WO
    mean = np.asarray(grasp.task.problem.object.loops.surface.points).mean(axis=0)
    standing, hanging = lift.object.X_WB, lift.X_WO_hanging
    sunk = (standing[:3, :3] @ mean + standing[:3, 3] - hanging[:3, :3] @ mean - hanging[:3, 3])[2]
    assert found.drop == pytest.approx(sunk, abs=1e-6)
    assert found.drop > 0.001


def test_the_planned_height_is_enough_for_what_hangs_lower(plan, scene):
    lift, place = plan.stages[1:]
    options = place.task.options
    thing = next(o for o in scene.objects if o.name == name_of(scene))
    sway = loose.sway_of(lift, SimpleNamespace(thing=thing))
    assert options.height == pytest.approx(max(0.06, sway.sunk + 0.02))
    assert options.max_tilt == loose.LEVEL


def change(path, by):
    """Adds to a number of the plan's document."""

    def changed(document):
        at = document
        for key in path[:-1]:
            at = at[key]
        at[path[-1]] += by

    return changed


def shorten(document):
    retreat = document["stages"][-1]["segments"][-1]
    for field in ("positions", "object_poses"):
        retreat[field] = retreat[field][:3]


@pytest.mark.parametrize(
    ("mutant", "words"),
    [
        (
            change(["stages", 2, "task", "hanging", "position", 2], 0.01),
            "hanging.position is not what",
        ),
        (
            change(["stages", 1, "task", "hanging", "position", 2], 0.01),
            "hanging.position is not what",
        ),
        (change(["stages", 2, "task", "way_out", 0, 2], 0.01), "way_out is not what"),
        (change(["stages", 2, "task", "down", 0], 0.01), "down is not what"),
        (change(["stages", 2, "task", "open", -1], 0.01), "open is not what"),
        (change(["stages", 1, "segments", 0, "positions", 0, 1], 1e-4), "a joint starts"),
        (shorten, "the hand is not at the end of its way out"),
        (change(["stages", 2, "segments", 3, "object_poses", -1, 2], 1e-3), "not at its place"),
        (change(["stages", 2, "segments", 1, "object_poses", 2, 0], 1e-3), "relative to the hand"),
    ],
)
def test_the_check_finds(plan, mutant, words):
    faults = graspless.check(reloaded(plan, mutant))
    assert any(words in fault for fault in faults), faults


def test_the_check_sees_what_the_hanging_object_touches(plan):
    """A post that the bag misses as it is held, and hits as it hangs."""
    transfer = plan.stages[-1].segments[0]
    place = plan.stages[-1].task.problem
    X_FO = np.linalg.inv(place.object.X_WB) @ place.X_WO_hanging
    rows = np.asarray(transfer.object_poses)
    row = len(rows) - 1  # where it begins to be lowered
    corners = np.concatenate(
        [
            frames.transform(part.X_BG, np.asarray(part.shape.vertices))
            for part in place.object.shapes
        ]
    )
    held, hung = (
        np.concatenate([corners @ X[:3, :3].T + X[:3, 3] for X in poses])
        for poses in (rows, [rows[row] @ X_FO])
    )
    low = hung[np.argmin(hung[:, 2])]
    assert low[2] < held[:, 2].min() - 0.002
    top = (low[2] + held[:, 2].min()) / 2
    post = {
        "name": "post",
        "box": [0.004, 0.004, 0.02],
        "pose": {"position": [float(low[0]), float(low[1]), float(top - 0.01)]},
    }

    def with_post(document):
        for task in (document["task"]["stages"][-1], document["stages"][-1]["task"]):
            task["obstacles"].append(post)

    faults = graspless.check(reloaded(plan, with_post))
    assert any("hanging" in fault and "post" in fault for fault in faults), faults


def test_a_region(scene):
    region = {"rectangle": {"center": [0.6, -0.15], "size": [0.45, 0.35]}}
    found = picked(scene, {"region": region})
    assert found, found.reason
    assert graspless.check(found.plan) == []


@pytest.mark.parametrize(
    ("place", "words"),
    [
        ({"pose": {"x": 0.6, "y": -0.25}}, "the place is taken: 'object_"),
        ({"pose": {"x": 2.0, "y": 0.0}}, "cm beyond the edge of support_"),
    ],
)
def test_places_that_lengths_refuse(place, words):
    found = picked(seen(body([0.1, 0.1, 0.1], 0.6, -0.25, 0.05)), place)
    assert not found
    assert found.attempts[0].status == "refused"
    assert words in found.attempts[0].reason


def test_a_place_out_of_the_arms_reach(scene):
    found = picked(scene, {"pose": {"x": 0.97, "y": -0.3}})
    assert not found
    assert found.attempts[0].status == "refused"
    assert found.attempts[0].reason.startswith("picked up, but not put down: ")


def test_other_strategies_without_a_hand_do_not_hide_the_reason(scene):
    found = picked(scene, {"pose": {"x": 0.97, "y": -0.3}}, strategies=["pinch", "clasp"])
    assert [attempt.is_mistake for attempt in found.attempts] == [True, False]
    assert "picked up, but not put down" in found.reason


def test_unknown_names(scene):
    with pytest.raises(TaskError, match=r"on: trunk: the scene has no 'trunk' \(one of: support_0"):
        picked(scene, {"on": "trunk"})
    with pytest.raises(TaskError, match="name: bag: the scene has no 'bag'"):
        graspless.pick(scene, "bag", ROBOT, place={"on": "support_0"})


def test_what_hangs_askew_would_fall_over():
    """A cube of 8 cm stands up if it is put down less than 45 degrees askew."""
    points = np.array(list(itertools.product((-0.04, 0.04), (-0.04, 0.04), (0.0, 0.08))))
    ring = 0.04 * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    thing = SimpleNamespace(points=points, outline=ring)
    wish = SimpleNamespace(thing=thing, outline=geometry.Polygon(ring))

    def said(degrees):
        surface = SimpleNamespace(shape=SimpleNamespace(vertices=points))
        problem = SimpleNamespace(
            object=SimpleNamespace(X_WB=np.eye(4), shapes=[surface]),
            X_WO_hanging=frames.from_rpy([np.radians(degrees), 0, 0.3]),
        )
        held = SimpleNamespace(task=SimpleNamespace(problem=problem))
        return loose.refusal(loose.sway_of(held, wish), held, wish)

    assert said(40) == ""
    assert "it would hang 50 deg askew in the closed hand, and from 45 deg on" in said(50)


def test_it_stands_there_in_the_simulation(plan):
    pytest.importorskip("mujoco")
    trial = graspless.simulate(plan, record=True).trials[0]
    assert trial.failures == ()
    assert trial.measures["kept"] == 1
    assert trial.measures["raised"] > 0.02
    assert trial.measures["place_error"] < 0.035
    names = list(dict.fromkeys(trial.recording.names))
    assert names[-6:] == ["transfer", "hold", "lower", "open", "retreat", "rest"]


def test_the_simulation_notices_another_place(plan):
    pytest.importorskip("mujoco")
    bad = reloaded(plan)
    stage = bad.stages[-1]
    away = frames.translation([0.08, 0.0, 0.0])
    stage.segments = [
        type(segment)(segment.name, segment.positions, [away @ X for X in segment.object_poses])
        for segment in stage.segments
    ]
    assert "not_placed" in graspless.simulate(bad).trials[0].failures


def test_the_simulation_notices_a_hand_that_opens_on_the_way(plan):
    pytest.importorskip("mujoco")
    bad = reloaded(plan)
    stage = bad.stages[-1]
    fingers = bad.stages[0].task.problem.robot.group("hand")
    opened = np.asarray(stage.segments[-1].positions[-1])[fingers]
    changed = []
    for segment in stage.segments:
        positions = np.array(segment.positions)
        if segment.name == "transfer":
            t = np.linspace(0, 1, len(positions))[:, None]
            positions[:, fingers] += t * (opened - 0.8 - positions[:, fingers])
        changed.append(type(segment)(segment.name, positions, segment.object_poses))
    stage.segments = changed
    assert "dropped" in graspless.simulate(bad).trials[0].failures
