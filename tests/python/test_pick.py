# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picks: the strategy that works, reasons for the others, bad input, and the command."""

import dataclasses
import itertools
import json
import math
import pathlib
import threading
import time
import warnings
from types import SimpleNamespace

import numpy as np
import pytest

import graspless
import inspect_common as small
from graspless import check, frames, geometry, perception, picking, robot
from graspless.cli import main
from graspless.errors import TaskError
from graspless.picking import strategies, trying
from graspless.picking.measured import doubt, top_share, unseen_share
from graspless.picking.strategies import chain_of, ways_of
from graspless.picking.wish import simplified, wish_of
from graspless.proving.proof import digest_of
from graspless.tasks.scenes import outline_of
from pick_common import body, seen


@pytest.fixture(scope="module")
def scene():
    """A card, a bar that stands, and a block that is too large for all."""
    return seen()


@pytest.fixture(scope="module")
def names(scene):
    """Names of the card, the bar and the block."""
    x = {thing.thickness: thing.name for thing in scene.objects}
    low, middle, high = sorted(x)
    return {"card": x[low], "bar": x[middle], "block": x[high]}


def table_of(scene, name):
    thing = next(item for item in scene.objects if item.name == name)
    return next(support for support in scene.supports if support.name == thing.support)


def test_a_bar_is_pinched_where_it_stands(scene, names):
    found = graspless.pick(scene, names["bar"], "wam_t42")
    assert found, found.reason
    assert found.strategy == "pinch"
    assert found.plan.kind == "chain"
    assert [stage.kind for stage in found.plan.stages] == ["pinch", "carry"]
    assert graspless.check(found.plan) == []
    assert [attempt.status for attempt in found.attempts] == ["solved", *5 * ["not_tried"]]
    first, last = (found.plan.stages[k].segments[-1].object_poses[-1] for k in (0, 1))
    assert last[2, 3] - first[2, 3] == pytest.approx(0.1, abs=1e-3)


def test_a_card_is_slid_to_a_real_edge(scene, names):
    found = graspless.pick(scene, names["card"], "wam_t42")
    assert found, found.reason
    assert found.strategy == "slide"
    assert graspless.check(found.plan) == []
    assert found.attempts[0].status == "too_wide"
    assert "wide where it is narrowest" in found.attempts[0].reason
    support = found.plan.stages[0].task.problem.support
    edges = table_of(scene, names["card"]).edges
    assert all(str(edges[i]) == "real" for i in support.usable_edges)


def test_a_block_has_a_reason_for_each_strategy(scene, names):
    found = graspless.pick(scene, names["block"], "wam_t42", seconds=20)
    assert not found
    reasons = {attempt.strategy: attempt.reason for attempt in found.attempts}
    assert "wide where it is narrowest, the hand opens 54 mm" in reasons["pinch"]
    assert "201 mm high, the hand opens 54 mm" in reasons["slide"]
    assert "unseen" in reasons["clasp"]
    assert all(f"{name}: " in found.reason for name in reasons)


def test_a_bag_is_clasped_by_its_handle():
    yaw, X_WO = 0.8, np.eye(4)
    X_WO[:2, :2] = [[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]]
    X_WO[:3, 3] = 0.62, 0, 0
    parts = [
        ([0.2, 0.07, 0.15], [0, 0, 0.075]),
        ([0.02, 0.02, 0.12], [-0.07, 0, 0.21]),
        ([0.02, 0.02, 0.12], [0.07, 0, 0.21]),
        ([0.16, 0.02, 0.02], [0, 0, 0.28]),
    ]
    shapes = [
        geometry.PlacedShape(geometry.Box(size), frames.translation(place)) for size, place in parts
    ]
    bodies = [
        body([0.7, 0.7, 0.04], 0.65, 0.0, -0.02),
        body([6, 6, 0.02], 0.65, 0.0, -0.75),
        perception.Body(shapes, X_WO),
    ]
    frame = perception.render(bodies, perception.look_at([-0.05, 0.0, 0.6], [0.65, 0.0, 0.1]))
    looked = graspless.perceive(frame.depth, frame.K, frame.X_WC)
    found = graspless.pick(looked, looked.objects[0].name, "kr5_sdh", seconds=30)
    assert found, found.reason
    assert found.strategy == "clasp"
    assert all("it needs two fingers" in found.attempts[k].reason for k in (0, 1))
    assert "lower than three quarters of its width" in found.attempts[2].reason
    assert graspless.check(found.plan) == []
    clasp = found.plan.stages[0]
    loop = clasp.task.problem.object.loops.found[clasp.loop]
    assert np.max(loop.points[:, 2]) > 0.25  # it runs along the handle
    assert loop.seen_through > 1e-3


def test_the_same_seed_gives_the_same_plan(scene, names):
    a, b = (graspless.pick(scene, names["card"], "wam_t42", seed=4).plan for _ in range(2))
    assert a.to_json().split('"stats"')[0] == b.to_json().split('"stats"')[0]
    for one, other in zip(a.segments, b.segments, strict=True):
        assert np.array_equal(one.positions, other.positions)


def test_the_best_of_some_is_the_shortest(scene, names):
    from graspless.picking import duration

    single = graspless.pick(scene, names["card"], "wam_t42", strategies=["slide"])
    best = graspless.pick(scene, names["card"], "wam_t42", strategies=["slide"], best_of=4)
    assert duration(best.plan) <= duration(single.plan)


def test_a_plan_that_fails_its_check_is_not_given(scene, names, monkeypatch):
    fault = "contact 0: the face leans"
    monkeypatch.setattr(
        trying, "check", lambda plan: [fault] if plan.names[0] == "pinch" else check(plan)
    )
    found = graspless.pick(scene, names["card"], "wam_t42")
    assert found.strategy != "pinch"
    found = graspless.pick(scene, names["bar"], "wam_t42", strategies=["pinch"])
    assert not found
    assert (found.attempts[0].status, found.attempts[0].reason) == ("faulty", fault)
    assert found.reason == f"pinch: {fault}"


def test_other_objects_are_obstacles(scene, names):
    found = graspless.pick(scene, names["bar"], "wam_t42")
    obstacles = {body.name for body in found.plan.stages[0].task.problem.obstacles}
    assert obstacles == {f"scene {names['card']}", f"scene {names['block']}"}  # not the floor
    assert all(body.padding == 0 for body in found.plan.stages[0].task.problem.obstacles)
    apart = graspless.pick(scene, names["bar"], "wam_t42", padding=0.02)
    assert graspless.check(apart.plan) == []
    for stage in apart.plan.stages:
        bodies = [body for body in stage.task.problem.obstacles if "support" not in body.name]
        assert [body.padding for body in bodies] == [0.02, 0.02]
    alone = graspless.pick(scene, names["bar"], "wam_t42", respect="nothing")
    assert not alone.plan.stages[0].task.problem.obstacles


def test_given_obstacles_are_kept_clear_of(scene, names):
    X_WO = next(thing.X_WO for thing in scene.objects if thing.name == names["bar"])
    x, y = map(float, X_WO[:2, 3])
    ceiling = {"name": "ceiling", "box": [0.3, 0.3, 0.02], "pose": {"position": [x, y, 2.0]}}
    lamp = {"name": "lamp", "sphere": {"radius": 0.05}, "pose": {"position": [x, y, 1.5]}}
    found = graspless.pick(scene, names["bar"], "wam_t42", obstacles=[ceiling], respect="nothing")
    assert found, found.reason
    kept = [{body.name for body in stage.task.problem.obstacles} for stage in found.plan.stages]
    assert kept == [{"ceiling"}, {"ceiling", "support"}]
    lid = [ceiling | {"pose": {"position": [x, y, 0.12]}}]
    under = graspless.pick(
        scene, names["bar"], "wam_t42", obstacles=lid, strategies=["pinch"], seconds=1.0
    )
    assert under.reason.endswith("collision of hand_base with ceiling")
    both = graspless.pick(scene, names["bar"], "wam_t42", obstacles=(ceiling, lamp))
    all_of_them = {"ceiling", "lamp", f"scene {names['card']}", f"scene {names['block']}"}
    kept = [{body.name for body in stage.task.problem.obstacles} for stage in both.plan.stages]
    assert kept == [all_of_them, all_of_them | {"support"}]


def test_what_lies_on_something_is_refused(scene, names):
    under = next(thing for thing in scene.objects if thing.name == names["block"])
    lying = perception.Object(
        name="lid", support=under.support, outline=0.5 * under.outline, X_WO=under.X_WO,
        thickness=0.3, thickness_error=0.001, is_flat=True, position_error=0.001, yaw_error=0.01,
        points=under.points, touches_border=False, warnings=[],
    )  # fmt: skip
    stacked = perception.Scene(
        status=scene.status, reason="", supports=list(scene.supports), objects=[under, lying],
        unseen=[], warnings=[],
    )  # fmt: skip
    found = graspless.pick(stacked, "lid", "wam_t42")
    assert not found
    assert {attempt.status for attempt in found.attempts} == {"refused"}
    assert all(f"'{under.name}' overlaps it" in attempt.reason for attempt in found.attempts)


def test_an_outline_that_is_a_sliver_of_what_was_seen_is_refused(scene, names):
    bar = next(thing for thing in scene.objects if thing.name == names["bar"])
    ring = np.asarray(bar.outline)
    middle, low = ring.mean(axis=0), ring.min(axis=0)
    corner = low + 0.1 * (ring - low) + [0, 2 * (middle - low)[1]]  # at the object's far side
    partial = _alone(scene, bar, outline=corner)
    found = graspless.pick(partial, bar.name, "wam_t42", strategies=["pinch", "rim", "slide"])
    assert not found
    assert [attempt.status for attempt in found.attempts] == 3 * ["refused"]
    assert all("com" not in attempt.reason for attempt in found.attempts)
    assert all("only a sliver of what was seen" in found.attempts[k].reason for k in (0, 1))


def _alone(scene, thing, outline=None, warnings=()):
    """The scene with one object, of another outline or with warnings."""
    other = perception.Object(
        name=thing.name, support=thing.support, X_WO=thing.X_WO,
        outline=thing.outline if outline is None else outline,
        thickness=thing.thickness, thickness_error=0.001, is_flat=True, position_error=0.001,
        yaw_error=0.01, points=thing.points, rays=list(thing.rays), touches_border=False,
        warnings=list(warnings),
    )  # fmt: skip
    return perception.Scene(
        status=scene.status, reason="", supports=list(scene.supports), objects=[other], unseen=[],
        warnings=[],
    )  # fmt: skip


def test_warnings_of_the_object_are_given_again(scene, names, tmp_path, capsys, monkeypatch):
    bar = next(thing for thing in scene.objects if thing.name == names["bar"])
    told = ["something nearer may hide part of it", "it may be several objects"]
    doubtful = _alone(scene, bar, warnings=told)
    with pytest.warns(UserWarning, match=bar.name) as caught:
        assert graspless.pick(doubtful, bar.name, "wam_t42", strategies=["pinch"])
    assert [str(each.message) for each in caught] == [f"scene: {bar.name}: {text}" for text in told]
    monkeypatch.chdir(tmp_path)
    perception.save_scene(doubtful, "scene.yaml")
    assert main(["pick", "scene.yaml", bar.name, *ROBOT, "--strategies", "pinch"]) == 0
    errors = capsys.readouterr().err.splitlines()
    assert errors == [f"warning: scene.yaml: {bar.name}: {text}" for text in told]


def test_no_real_edge_is_a_reason(scene, names):
    table = table_of(scene, names["card"])
    hidden = perception.Support(
        name=table.name, polygon=table.polygon, edges=[perception.EdgeLabel.occluded] * len(table.edges),
        X_WS=table.X_WS, height_error=0.0, angle_error=0.0, noise=0.001, least_thickness=0.003,
    )  # fmt: skip
    blind = perception.Scene(
        status=scene.status, reason="", supports=[hidden], objects=list(scene.objects), unseen=[],
        warnings=[],
    )  # fmt: skip
    found = graspless.pick(blind, names["card"], "wam_t42", strategies=["slide"])
    assert "no real edge" in found.attempts[0].reason
    assert f"{len(table.edges)} occluded" in found.attempts[0].reason


def test_an_edge_out_of_reach_is_a_reason(scene, names):
    robot = {"urdf": "wam_t42", "pose": {"position": [-3.0, 0, 0]}}
    found = graspless.pick(scene, names["card"], robot, strategies=["slide"])
    assert "no edge within reach: the nearest is" in found.attempts[0].reason


def test_the_share_of_the_side_that_is_unseen(scene, names):
    wish = wish_of(
        scene, "scene", names["block"], "wam_t42", lift=0.1, respect="objects", mass=None
    )
    assert 0.2 < unseen_share(wish) < 0.8  # a block seen from one side
    one = wish.thing.points[:1]
    assert unseen_share(_with_points(wish, one)) > 0.9


def test_the_share_of_a_hollow_object_that_is_as_high_as_its_top(scene, names):
    wish = wish_of(scene, "scene", names["card"], "wam_t42", lift=0.1, respect="objects", mass=None)
    assert top_share(wish) > 0.95
    ring = np.asarray(wish.thing.outline)
    rim = np.column_stack([ring, np.full(len(ring), wish.thing.thickness)])
    assert top_share(_with_points(wish, rim)) < 0.5


def _wish(scene, name):
    return wish_of(scene, "scene", name, "wam_t42", lift=0.1, respect="objects", mass=None)


def _seen_shapes(shapes):
    """The perceived scene of an object at x 0.6, y 0.05, yaw 0.4 on a table."""
    bodies = [
        body([0.7, 0.7, 0.04], 0.65, 0.0, -0.02),
        body([6, 6, 0.02], 0.65, 0.0, -0.75),
        perception.Body(shapes, frames.planar(0.6, 0.05, 0.4)),
    ]
    frame = perception.render(bodies, perception.look_at([-0.05, 0.0, 0.75], [0.65, 0.0, 0.0]))
    return graspless.perceive(frame.depth, frame.K, frame.X_WC)


def test_a_slide_needs_its_height_where_it_presses_and_grasps(scene, names):
    wish = _wish(scene, names["card"])
    plan = graspless.pick(scene, names["card"], "wam_t42").plan
    assert doubt(plan, wish) == ""
    stage = plan.stages[0]
    robot, hand = stage.task.problem.robot, stage.task.problem.hand
    slide = next(segment for segment in stage.segments if segment.name == "slide")
    for frame, segment, row, lower, what in (
        (hand.fingertip, slide, 0, 0.0045, "where the finger presses, it is 2 mm high, its top 6"),
        (hand.grasp_frame, stage.segments[-1], -1, 0.0065, "where the hand closes, it is -0 mm"),
    ):
        X_WF = robot.pose(robot.frame(frame), segment.positions[row])
        place = (np.linalg.inv(segment.object_poses[row]) @ X_WF)[:2, 3]
        points = np.array(wish.thing.points)
        points[:, 2] = wish.thing.thickness
        near = np.linalg.norm(points[:, :2] - place, axis=1) < 0.02
        points[near, 2] -= lower
        assert doubt(plan, _with_points(wish, points)).startswith(what)
        points[near, 2] += 0.002
        assert doubt(plan, _with_points(wish, points)) == ""
        unseen = doubt(plan, _with_points(wish, points[~near]))
        assert unseen == f"nobody saw the top {what.split(',')[0]}"


def test_a_pinch_without_time_says_nothing_of_the_hand(scene, names, monkeypatch):
    planned = trying._plan

    def hasty(strategy, *given):
        plan, *rest = planned(strategy, *given)
        if strategy == "pinch":  # as if its time had been over before the hand was measured
            plan.stages[0].opening = 0.0
        return plan, *rest

    monkeypatch.setattr(trying, "_plan", hasty)
    found = graspless.pick(scene, names["card"], "wam_t42", strategies=["pinch", "slide"])
    assert found.strategy == "slide", found.reason


def test_a_slide_needs_fingers_that_bear_the_object():
    scene = seen(([0.2, 0.09, 0.02], 0.6, 0.1, 0.01, 0.3))
    name = scene.objects[0].name

    def slid(mass):
        return graspless.pick(scene, name, "wam_t42", mass=mass, strategies=["slide"]).plan

    borne = slid(0.3).stages[0].max_mass
    plan = slid(1.05 * borne)
    assert plan.stages[0].max_mass >= 1.05 * borne
    assert not plan.stages[0].warnings
    wish = dataclasses.replace(_wish(scene, name), mass=1.05 * borne)
    document = plan.task.to_dict()
    told = []
    for seed in range(1, 9):  # these plans are not compared with what the camera saw
        found = graspless.plan({**document, "budget": {"seed": seed, "seconds": 60.0}})
        assert found, found.reason
        first = found.stages[0]
        heavy = first.max_mass < 1.05 * borne
        assert heavy == any("its fingers bear" in text for text in first.warnings)
        assert heavy == ("the fingers bear" in doubt(found, wish))
        assert "the fingers bear" not in doubt(found, _wish(scene, name))  # no mass was given
        told.append(heavy)
    assert any(told)
    assert not all(told)


def test_the_centre_of_mass_is_that_of_what_was_seen():
    """A thin bar with a thick end."""
    sizes = [([0.16, 0.03, 0.006], [0, 0, 0.003]), ([0.04, 0.04, 0.03], [0.1, 0, 0.015])]
    shapes = [geometry.PlacedShape(geometry.Box(s), frames.translation(p)) for s, p in sizes]
    found = _seen_shapes(shapes)
    wish = _wish(found, found.objects[0].name)
    volumes = [np.prod(s) for s, _ in sizes]
    com = np.average([p for _, p in sizes], axis=0, weights=volumes)
    true = frames.transform(np.linalg.inv(wish.thing.X_WO) @ frames.planar(0.6, 0.05, 0.4), [com])
    assert np.linalg.norm(np.subtract(wish.com, true[0])) < 0.012  # of its shadow
    assert np.linalg.norm(wish.outline.centroid - true[0, :2]) > 0.02
    for strategy in ("pinch", "rim", "slide"):
        for way in ways_of(strategy, wish, False):
            stage = chain_of(strategy, wish, 1, 1.0, way)["stages"][0]
            assert stage["object"]["com"] == wish.com


def test_a_pinch_needs_something_between_its_fingers(scene, names):
    wish = _wish(scene, names["bar"])
    plan = graspless.pick(scene, names["bar"], "wam_t42").plan
    assert doubt(plan, wish) == ""
    flat = np.array(wish.thing.points)
    flat[:, 2] = 0.005
    assert "over the support, where the object is 5 mm high" in doubt(
        plan, _with_points(wish, flat)
    )
    assert "nobody saw the top" in doubt(plan, _with_points(wish, flat[:2]))


@pytest.mark.filterwarnings("ignore:.*it has level faces at heights")
def test_a_spoon_is_not_pinched_above_its_handle():
    shapes = [
        geometry.PlacedShape(geometry.Box(size), frames.translation(place))
        for size, place in (([0.14, 0.02, 0.005], [0, 0, 0.0025]), ([0.06, 0.06, 0.022], [0.08, 0, 0.011]))
    ]  # fmt: skip
    looked = _seen_shapes(shapes)
    found = graspless.pick(looked, looked.objects[0].name, "wam_t42", strategies=["pinch"])
    assert not found
    assert found.attempts[0].status == "refused"
    assert "over the support, where the object is 5 mm high" in found.attempts[0].reason


def test_low_objects_are_pinched_with_the_ends_of_the_pads(scene, names):
    low, high = (_wish(scene, names[name]) for name in ("card", "bar"))
    last = ways_of("pinch", low, False)[-1]
    options = chain_of("pinch", low, 1, 2.0, last)["stages"][0]["options"]
    assert options == {"depth": 0.003, "patch": 0.003, "height": 0.0}
    for wish, ways in (
        (low, ways_of("pinch", low, False)[:-1]),
        (high, ways_of("pinch", high, False)),
    ):
        options = [chain_of("pinch", wish, 1, 2.0, way)["stages"][0]["options"] for way in ways]
        assert options == [{}] * len(ways)
    options = [
        chain_of("pinch", high, 1, 2.0, way, 0.054)["stages"][0]["options"].get("opening")
        for way in ways_of("pinch", high, False)
    ]
    assert options == [None, None, 0.027, 0.0135]


@pytest.fixture(scope="module")
def plates(tmp_path_factory):
    """An arm whose fingers are flat plates."""
    folder = tmp_path_factory.mktemp("plates")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of what the URDF does not say
        urdf = robot.Robot.from_urdf(small.gripper("plates", small.prismatic()))
        robot.inspect(urdf).write(folder)
    return str(folder / "plates.urdf")


@pytest.mark.parametrize(
    ("height", "knob", "level"),
    [
        (0.01, 0.01, 0.0045),  # 3 mm of the pads, 1.5 mm over the support
        (0.016, 0.016, 0.0135),  # 1 cm, and 2 mm more over the support
        (0.0105, 0.02, 0.0045),  # between the fingers, it is 3 mm too low for that
    ],
)
def test_flat_pads_take_bars_on_a_table(plates, height, knob, level):
    parts = [
        ([0.12, 0.022, height], [0, 0, height / 2]),
        ([0.02, 0.022, knob], [0.05, 0, knob / 2]),
    ]
    bar = perception.Body(
        [geometry.PlacedShape(geometry.Box(size), frames.translation(at)) for size, at in parts],
        frames.planar(0.5, 0.05, 0.4),
    )
    table, floor = body([0.7, 0.7, 0.04], 0.65, 0.0, -0.02), body([6, 6, 0.02], 0.65, 0.0, -0.75)
    eye = perception.look_at([-0.05, 0.0, 0.75], [0.65, 0.0, 0.0])
    frame = perception.render([table, floor, bar], eye)
    looked = graspless.perceive(frame.depth, frame.K, frame.X_WC)
    found = graspless.pick(looked, looked.objects[0].name, plates, strategies=["pinch"])
    assert found, found.reason
    assert found.plan.stages[0].contacts_O[0, 2] == pytest.approx(level, abs=1e-4)
    assert check(found.plan) == []


def _with_points(wish, points):
    import dataclasses

    old = wish.thing
    thing = perception.Object(
        name=old.name, support=old.support, outline=old.outline, X_WO=old.X_WO,
        thickness=old.thickness, thickness_error=0.0, is_flat=True, position_error=0.0,
        yaw_error=0.0, points=points, touches_border=False, warnings=[],
    )  # fmt: skip
    return dataclasses.replace(wish, thing=thing)


@pytest.mark.parametrize("strategy", ["pinch", "rim", "slide", "clasp"])
def test_the_task_of_a_strategy_is_a_task_file(scene, names, strategy):
    name = names["card" if strategy == "slide" else "bar"]
    wish = wish_of(scene, "scene", name, "wam_t42", lift=0.1, respect="unseen", mass=0.3)
    task = graspless.tasks.task_from_dict(chain_of(strategy, wish, 1, 5.0), "chain", resolve=True)
    kind = "pinch" if strategy == "rim" else strategy
    assert [stage.kind for stage in task.problem.stages] == [kind, "carry"]


TALL = {"name": "wall", "box": np.array([0.1, 1.0, 1.0]), "pose": {"position": (0.0, -1.0, 0.5)}}


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"name": "spoon"}, r"name: spoon: the scene has no 'spoon' \(one of: object_0"),
        ({"robot": "no_such"}, "no such file, nor a robot that comes with graspless"),
        (
            {"robot": ["wam_t42", "wam_t4"]},  # even where the first one has a plan
            r"robot\[1\].urdf: wam_t4: no such file, .*did you mean 'wam_t42'\? \(one of: kr5",
        ),
        (
            {"robot": ["wam_t42", {"arm": "kr5_sdh", "gripper": {"file": "hand.urdf"}}]},
            r"robot\[1\].gripper.file: hand.urdf: no such file",
        ),
        (
            {"strategies": ["throw"]},
            "strategies: throw: should be one of pinch, rim, slide, clasp, tumble, push",
        ),
        ({"strategies": ["pinhc"]}, "pinhc: should be one of .*; did you mean 'pinch'"),
        ({"respect": "objcets"}, "objcets: should be one of .*; did you mean 'objects'"),
        ({"strategies": []}, "strategies: none"),
        ({"lift": -0.1}, "lift: -0.1"),
        ({"lift": float("nan")}, "lift: nan"),
        ({"padding": -0.1}, "padding: -0.1"),
        ({"padding": float("nan")}, "padding: nan"),
        ({"mass": 0.0}, "mass: 0.0"),
        ({"grip_force": -5.0}, "grip_force: -5.0"),
        ({"best_of": 0}, "best_of"),
        ({"seconds": -1.0}, "seconds"),
        ({"respect": "all"}, "respect: all: should be one of"),
        ({"obstacles": [{"name": "wall"}]}, r"pick: obstacles\[0\]: exactly one of box, "),
        ({"obstacles": 3}, "pick: obstacles: 3: should be a"),
        ({"obstacles": [TALL | {"name": "support"}]}, r"obstacles\[0\].name: support: is the name"),
        (
            {"obstacles": [TALL | {"name": "scene object_0"}]},
            r"obstacles\[0\].name: scene object_0",
        ),
        ({"obstacles": {"name": "wall"}}, r"pick: obstacles: \{.*: should be a valid list"),
        (
            {"obstacles": [{"name": "wall", "mesh": {"file": "none.stl"}}]},
            r"pick: obstacles\[0\].mesh.file: none.stl: no such file",
        ),
    ],
)
def test_mistakes_are_named(scene, names, given, words):
    asked = {"name": names["bar"], "robot": "wam_t42"} | given
    with pytest.raises(ValueError, match=words):
        graspless.pick(scene, **asked)


def test_what_the_image_cuts_off_is_warned_of_and_not_pinched(tmp_path, capsys, monkeypatch):
    table, floor = (body([0.7, 1.4, 0.04], 0.65, 0.3, -0.02), body([6, 6, 0.02], 0.65, 0, -0.75))
    beam = body([0.08, 0.3, 0.06], 0.55, 0.54, 0.03)  # 4 cm of its length are in the image
    eye = perception.look_at([0.6, 0, 0.8], [0.601, 0, 0])
    frame = perception.render([table, floor, beam], eye)
    looked = graspless.perceive(frame.depth, frame.K, frame.X_WC)
    name = looked.objects[0].name
    with pytest.warns(UserWarning, match=f"scene: {name}: the image cuts it off: a finger"):
        found = graspless.pick(looked, name, ["wam_t42", "kr5_t42"], strategies=["pinch", "tumble"])
    assert not found
    assert {attempt.status for attempt in found.attempts} == {"refused"}
    assert all("the image cuts it off" in attempt.reason for attempt in found.attempts)
    monkeypatch.chdir(tmp_path)
    perception.save_scene(looked, "scene.yaml")
    asked = ["pick", "scene.yaml", name, "--robot", "wam_t42", "--strategies", "pinch"]
    assert main(asked) == 1
    assert capsys.readouterr().err.count(f"scene.yaml: {name}: the image cuts it off") == 1


def test_a_scene_of_nothing_is_refused(scene):
    empty = perception.Scene(
        status=scene.status, reason="one table", supports=list(scene.supports), objects=[],
        unseen=[], warnings=[],
    )  # fmt: skip
    with pytest.raises(TaskError, match="no object was found in this scene: one table"):
        graspless.pick(empty, "cup", "wam_t42")
    with pytest.raises(TaskError, match="no such file"):
        graspless.pick("none.yaml", "cup", "wam_t42")
    with pytest.raises(TaskError, match="scene"):
        graspless.pick(3, "cup", "wam_t42")


def test_a_robot_without_a_hand_is_refused(scene, names, tmp_path):
    urdf = tmp_path / "arm.urdf"
    links = "".join(f'<link name="l{i}"/>' for i in range(3))
    joints = "".join(
        f'<joint name="j{i}" type="revolute"><parent link="l{i}"/><child link="l{i + 1}"/>'
        '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
        for i in range(2)
    )
    urdf.write_text(f'<robot name="arm">{links}{joints}</robot>')
    with pytest.raises(TaskError, match="^pick: robot: no link has a collision shape"):
        graspless.pick(scene, names["bar"], str(urdf))


def test_reasons_and_warnings_name_no_strategy(scene, names, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    perception.save_scene(scene, "scene.yaml")
    (tmp_path / "mine.urdf").write_text(small.gripper())
    asked = [
        "pick",
        "scene.yaml",
        names["block"],
        "--json",
        "--strategies",
        "pinch,rim,clasp,tumble",
    ]
    assert main([*asked, "--robot", "mine.urdf"]) == 1
    warned = capsys.readouterr().err.splitlines()
    assert len(warned) == len(set(warned)) == 2  # proposals for a pinch, and for a clasp
    assert all(line.startswith("warning: pick: robot: no SRDF") for line in warned)
    assert main([*asked, "--robot", "kr5_sdh"]) == 1
    result = json.loads(capsys.readouterr().out)
    reasons = {attempt["strategy"]: attempt["reason"] for attempt in result["attempts"]}
    assert reasons["pinch"] == reasons["rim"] == reasons["tumble"]
    assert reasons["pinch"].startswith("robot: no hand for this task was found")


@pytest.mark.parametrize(
    ("looks", "tried", "words"),
    [
        (1, 0, "was over when robot and scene had been read; give"),
        (2, 1, "was over after 'pinch';"),
    ],
)
def test_a_time_limit_that_is_too_short_is_told(scene, names, monkeypatch, looks, tried, words):
    clock = iter([0.0] * looks)
    monkeypatch.setattr(picking, "time", SimpleNamespace(monotonic=lambda: next(clock, 9.0)))
    found = graspless.pick(scene, names["block"], "wam_t42", seconds=5)
    untried = found.attempts[tried:]
    assert [attempt.status for attempt in untried] == (6 - tried) * ["not_tried"]
    assert f"the time limit of 5 s {words}" in untried[0].reason
    assert {attempt.reason for attempt in untried[1:]} == {"no time was left"}


def test_a_pick_is_stopped_from_outside(scene, names, monkeypatch):
    """A plan that was found before counts."""
    search = strategies.plan_since

    def picked(stop_in, **changes):
        budget = graspless.planning.Budget(seconds=60, seed=2)
        searches = itertools.count()

        def stopping(*given):  # what another thread does in the middle of a search
            if next(searches) == stop_in:
                budget.stop()
            return search(*given)

        monkeypatch.setattr(strategies, "plan_since", stopping)
        return graspless.pick(scene, names["bar"], "wam_t42", budget=budget, **changes)

    found = picked(0)
    assert not found
    assert [attempt.status for attempt in found.attempts] == ["interrupted", *5 * ["not_tried"]]
    assert found.reason.startswith("pinch: none of 0 hand poses works; the budget ran out before")
    assert "; rim: the pick was stopped; slide: the pick was stopped;" in found.reason
    whole = picked(-1)
    best = picked(1, best_of=9)
    assert [attempt.status for attempt in best.attempts[:2]] == ["solved", "interrupted"]
    assert digest_of(best.plan) == digest_of(whole.plan)
    alone = graspless.pick(scene, names["bar"], "wam_t42", seconds=60, seed=2)
    assert digest_of(alone.plan) == digest_of(whole.plan)
    second = picked(2, best_of=3, strategies=["pinch", "rim"])  # in the second round
    assert second.strategy == "pinch"
    assert second.attempts[0].status == "solved"


def test_a_thread_stops_a_pick(scene, names):
    budget = graspless.planning.Budget(seconds=60)
    threading.Timer(0.3, budget.stop).start()
    began = time.monotonic()
    found = graspless.pick(scene, names["block"], "wam_t42", budget=budget, best_of=10**6)
    assert time.monotonic() - began < 10
    assert not found
    assert {"refused", "too_wide"} <= {attempt.status for attempt in found.attempts}


def test_a_pick_that_was_stopped_before_it_began_tries_nothing(scene, names):
    budget = graspless.planning.Budget()
    budget.stop()
    found = graspless.pick(scene, names["bar"], "wam_t42", budget=budget)
    assert {attempt.status for attempt in found.attempts} == {"not_tried"}
    assert {attempt.reason for attempt in found.attempts} == {"the pick was stopped"}


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"budget": {}, "seed": 1}, "budget: seconds and seed must not be given beside it"),
        (
            {"budget": {"iterations": 5}},
            "budget.iterations: 5: should be None: a pick runs several",
        ),
        ({"budget": {"seconds": math.inf}}, "budget: seconds is inf; should be finite"),
        ({"seconds": math.inf}, "^seconds: inf: should be finite"),
        ({"budget": 5}, r"budget: 5: should be a graspless.planning.Budget"),
        ({"seconds": 0}, "seconds: 0: should be above 0"),
        ({"seed": -1}, "seed: -1: should not be negative"),
    ],
)
def test_budgets_that_are_refused(scene, names, changes, words):
    if isinstance(changes.get("budget"), dict):
        changes = changes | {"budget": graspless.planning.Budget(**changes["budget"])}
    with pytest.raises(TaskError, match=words):
        graspless.pick(scene, names["bar"], "wam_t42", **changes)


ROBOT = ("--robot", "wam_t42")


def test_the_command(scene, names, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    perception.save_scene(scene, "scene.yaml")
    assert main(["pick", "scene.yaml", names["bar"], *ROBOT, "-o", "p.json"]) == 0
    said = capsys.readouterr().out
    assert "pinch  solved" in said
    assert "written: p.json" in said
    assert main(["check", "p.json"]) == 0
    capsys.readouterr()
    code = main(
        ["pick", "scene.yaml", names["block"], *ROBOT, "--json", "--strategies", "pinch,slide"]
    )
    assert code == 1
    result = json.loads(capsys.readouterr().out)
    assert [attempt["status"] for attempt in result["attempts"]] == ["too_wide", "refused"]
    assert main(["pick", "scene.yaml", "spoon", *ROBOT]) == 2
    assert "the scene has no 'spoon' (one of: " in capsys.readouterr().err


def test_packages_of_the_robots(scene, names, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    perception.save_scene(scene, "scene.yaml")
    arm, data = robot.builtin("wam_t42"), pathlib.Path(__file__).parents[1] / "data"
    for path in arm.parent.glob("wam_t42.*"):
        (tmp_path / path.name.replace("wam_t42", "mine")).write_text(path.read_text())
    mesh = '<mesh filename="package://far/tetrahedron.obj" scale="0.01 0.01 0.01"/>'
    link = '<link name="base_link">'
    more = f"{link}<collision><geometry>{mesh}</geometry></collision>"
    (tmp_path / "mine.urdf").write_text(arm.read_text().replace(link, more))
    asked = ["pick", "scene.yaml", names["bar"], "--robot", "mine.urdf", "--strategies", "pinch"]
    assert main(asked) == 2
    assert "package 'far'" in capsys.readouterr().err
    assert main([*asked, "--package", f"far={data}"]) == 0


def test_a_task_file_of_kind_pick(scene, names, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    perception.save_scene(scene, "scene.yaml")
    task = tmp_path / "pick.yaml"
    task.write_text(
        f"kind: pick\nscene: scene.yaml\nname: {names['bar']}\nrobot: {{urdf: wam_t42}}\n"
        "lift: 0.05\nbudget: {seed: 3}\n"
    )
    assert main(["pick", "pick.yaml"]) == 0
    assert "with wam_t42: pinch, then lift" in capsys.readouterr().out
    plan = graspless.load_plan("plan.json")
    first, last = (plan.stages[k].segments[-1].object_poses[-1] for k in (0, 1))
    assert last[2, 3] - first[2, 3] == pytest.approx(0.05, abs=1e-3)
    assert plan.seed == 3

    def refused(*arguments):
        assert main(list(arguments)) == 2
        return capsys.readouterr().err

    assert "NAME: cup: must not be given" in refused("pick", "pick.yaml", "cup")
    assert "NAME: missing" in refused("pick", "scene.yaml")
    assert "--robot: missing" in refused("pick", "scene.yaml", names["bar"])
    assert "is planned by `graspless pick`" in refused("plan", "pick.yaml")
    task.write_text(task.read_text() + "highest: 3\n")
    assert "pick.yaml:7: highest: unknown field" in refused("pick", "pick.yaml")


FAR = {"urdf": "wam_t42", "pose": {"position": [-3.0, 0.0, 0.0]}}


def test_the_robot_that_reaches_it_picks_it_up(scene, names):
    found = graspless.pick(scene, names["bar"], [FAR, "kr5_t42", "wam_t42"])
    assert found, found.reason
    assert found.robot == "kr5_t42"
    tried = [(a.strategy, a.robot, a.status) for a in found.attempts]
    assert tried[:3] == [
        ("pinch", "wam_t42", "not_reached"),
        ("pinch", "kr5_t42", "solved"),
        ("pinch", "wam_t42 (2)", "not_tried"),
    ]
    assert len(tried) == 18
    assert "kr5_t42 pinch  solved" in found.table()
    alone = graspless.pick(scene, names["bar"], "kr5_t42")
    for one, other in zip(found.plan.segments, alone.plan.segments, strict=True):
        assert np.array_equal(one.positions, other.positions)


def test_a_search_that_ran_out_of_its_share_goes_on_with_another_seed(scene, names, monkeypatch):
    """Others are not asked again, and nothing is tried after a plan."""
    asked = []

    def attempt_plan(attempt, wish, target, opening, budget):
        asked.append((attempt.strategy, budget.seed))
        attempt.status = "not_connected"
        attempt.seconds += budget.seconds if attempt.strategy == "slide" else 0.0
        return plan if len(asked) == 6 else None

    plan = graspless.pick(scene, names["card"], "wam_t42", strategies=["slide"]).plan
    monkeypatch.setattr(picking, "attempt_plan", attempt_plan)
    strategies = ["pinch", "slide", "clasp"]
    found = graspless.pick(scene, names["card"], "wam_t42", strategies=strategies, seed=4)
    assert found.plan is plan
    again = [("slide", seed) for seed in (5, 6, 7)]
    assert asked == [("pinch", 4), ("slide", 4), ("clasp", 4), *again]


def test_the_best_of_some_may_be_of_another_robot(scene, names):
    robots = ["wam_t42", "kr5_t42"]
    best = graspless.pick(scene, names["bar"], robots, strategies=["pinch"], best_of=2)
    alone = {
        robot: graspless.pick(scene, names["bar"], robot, strategies=["pinch"]).plan
        for robot in robots
    }
    assert best.robot == min(robots, key=lambda robot: picking.duration(alone[robot]))


def test_several_robots_each_have_a_reason(scene, names):
    found = graspless.pick(scene, names["bar"], [FAR, FAR], strategies=["pinch"])
    assert not found
    assert found.robot is None
    assert "wam_t42 pinch: the object is out of the arm's reach" in found.reason
    assert "wam_t42 (2) pinch: the object is out of the arm's reach" in found.reason
    with pytest.raises(TaskError, match="robot: none"):
        graspless.pick(scene, names["bar"], [])


def test_an_old_scene_is_refused(scene, names, tmp_path):
    fresh = perception.Scene(
        status=scene.status, reason="", supports=list(scene.supports),
        objects=list(scene.objects), unseen=[], warnings=[],
    )  # fmt: skip

    def asked(age, max_age=5.0):
        fresh.stamp = None if age is None else time.time() - age
        perception.save_scene(fresh, tmp_path / "scene.yaml")
        return graspless.pick(tmp_path / "scene.yaml", names["bar"], "wam_t42", max_age=max_age)

    assert asked(0, max_age=60.0)
    for age, words in (
        (600, "its images were taken 60"),
        (-60, "in the future: the clocks differ"),
        (None, "nobody noted when its images were taken"),
    ):
        found = asked(age)
        assert not found
        assert (found.attempts[0].strategy, found.attempts[0].status) == ("scene", "stale")
        assert words in found.attempts[0].reason
        assert [attempt.status for attempt in found.attempts[1:]] == 6 * ["not_tried"]
    assert asked(60, max_age=None)
    with pytest.raises(TaskError, match="max_age: 0"):
        asked(0, max_age=0.0)


def test_a_task_file_with_obstacles(scene, names, tmp_path, capsys, monkeypatch):
    perception.save_scene(scene, tmp_path / "scene.yaml")
    (tmp_path / "wall.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 0.1 0\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n"
    )
    task = tmp_path / "pick.yaml"
    wall = "obstacles:\n- {name: wall, mesh: {file: wall.obj}, pose: {position: [0, 1, 0]}}\n"
    head = f"kind: pick\nscene: scene.yaml\nname: {names['bar']}\nrobot: {{urdf: wam_t42}}\n"
    task.write_text(head + wall)
    monkeypatch.chdir(tmp_path.parent)  # paths of a task file are relative to it
    assert main(["pick", str(task), "-o", str(tmp_path / "plan.json")]) == 0
    plan = graspless.load_plan(tmp_path / "plan.json")
    assert "wall" in {body.name for body in plan.stages[0].task.problem.obstacles}
    capsys.readouterr()
    task.write_text(head + wall.replace("wall.obj", "walls.obj"))
    assert main(["pick", str(task)]) == 2
    assert "pick.yaml:6: obstacles[0].mesh.file: walls.obj: no such" in capsys.readouterr().err
    task.write_text(head + wall.replace("name: wall", f"name: {names['bar']}"))
    assert main(["pick", str(task)]) == 2
    assert f"pick.yaml:6: obstacles[0].name: {names['bar']}: is the name" in capsys.readouterr().err


def test_obstacles_may_be_of_numpy(scene, names):
    found = graspless.pick(scene, names["bar"], "wam_t42", obstacles=[TALL])
    assert found, found.reason


def test_a_task_file_with_several_robots(scene, names, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    perception.save_scene(scene, "scene.yaml")
    head = f"kind: pick\nscene: scene.yaml\nname: {names['bar']}\n"
    task = tmp_path / "pick.yaml"
    robots = "robots: [{urdf: wam_t42, pose: {position: [-3, 0, 0]}}, {urdf: kr5_t42}]\n"
    task.write_text(head + robots)
    assert main(["pick", "pick.yaml", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["robot"] == "kr5_t42"
    task.write_text(f"{head}{robots}budget: {{seconds: 5, iterations: 3}}\n")
    assert main(["pick", "pick.yaml"]) == 2
    told = "pick.yaml:5: budget.iterations: 3: not for a pick (one of: seconds, seed)"
    assert told in capsys.readouterr().err
    task.write_text(head)
    assert main(["pick", "pick.yaml"]) == 2
    assert "exactly one of robot, robots must be given, not none" in capsys.readouterr().err
    assert main(["pick", "scene.yaml", names["bar"], *ROBOT, "--max-age", "5"]) == 1
    assert "scene  stale: nobody noted when" in capsys.readouterr().out


def test_outlines_have_few_corners_near_the_others(scene):
    for thing in scene.objects:
        ring = np.asarray(thing.outline)
        kept = simplified(ring, 0.0015)
        assert len(kept) < 0.8 * len(ring)
        assert {tuple(p) for p in kept} <= {tuple(p) for p in ring}
        polygon = geometry.Polygon(kept)
        assert max(abs(polygon.depth(p)) for p in ring) <= 0.0015 + 1e-9
    square = np.array([[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]])
    assert {tuple(p) for p in simplified(square, 0.0015)} == {tuple(p) for p in square}


def test_an_obstacle_is_its_hull_unless_it_is_hollow(scene):
    for thing in scene.objects:
        hull = geometry.Polygon(outline_of(thing))
        assert hull.is_convex
        assert all(hull.depth(p) > -1e-6 for p in thing.outline)
    old = scene.objects[0]
    corner = [[0, 0], [0.1, 0], [0.1, 0.03], [0.03, 0.03], [0.03, 0.1], [0, 0.1]]
    hollow = perception.Object(
        name=old.name, support=old.support, outline=corner, X_WO=old.X_WO, thickness=0.05,
        thickness_error=0.0, is_flat=True, position_error=0.0, yaw_error=0.0, points=old.points,
        touches_border=False, warnings=[],
    )  # fmt: skip
    assert len(outline_of(hollow)) == 6


@pytest.mark.parametrize(("size", "least", "most"), [(0.12, 0.035, 0.09), (0.07, 0.02, 0.035)])
def test_a_slide_ends_with_a_deep_grasp_if_there_is_one(size, least, most):
    found = seen(([size, size, 0.006], 0.5, 0.2, 0.003, 0.3))
    plan = graspless.pick(found, found.objects[0].name, "wam_t42", strategies=["slide"]).plan
    slide = plan.stages[0]
    support = slide.task.problem.support
    X_SO = np.linalg.inv(support.X_WS) @ slide.segments[-1].object_poses[-1]
    corners = np.asarray(slide.task.problem.object.outline.vertices) @ X_SO[:2, :2].T + X_SO[:2, 3]
    overhang = max(-support.polygon.depth(corner) for corner in corners)
    assert least <= overhang <= most
