# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picks that put the object down: where it ends, reasons, bad input, and the simulation."""

import json

import numpy as np
import pytest

import graspless
from graspless import frames, perception
from graspless.cli import main
from graspless.errors import TaskError
from graspless.picking.place import Target
from graspless.picking.place_fields import place_of
from graspless.plan_files import plan_of
from graspless.plan_files.text import document_of
from pick_common import BAR, BLOCK, CARD, seen


@pytest.fixture(scope="module")
def scene():
    return seen()


@pytest.fixture(scope="module")
def names(scene):
    low, middle, high = sorted((thing.thickness, thing.name) for thing in scene.objects)
    return {"card": low[1], "bar": middle[1], "block": high[1]}


@pytest.fixture(scope="module")
def placed(scene, names):
    """A bar that is pinched and put down on the other side of the table."""
    place = {"pose": {"x": 0.5, "y": 0.0, "yaw": 1.2}}
    found = graspless.pick(scene, names["bar"], "wam_t42", place=place)
    assert found, found.reason
    return found


def end_of(found):
    return found.plan.stages[-1].segments[-1].object_poses[-1]


def reloaded(plan, change=lambda document: None):
    """The plan, read from a file that was changed."""
    document = document_of(plan)
    change(document)
    return plan_of(json.loads(json.dumps(document)), "plan")


def yaw_of(X):
    return np.arctan2(X[1, 0], X[0, 0])


def table_of(scene):
    on = min(scene.objects, key=lambda thing: thing.X_WO[2, 3]).support
    return next(support for support in scene.supports if support.name == on)


def test_a_bar_stands_where_it_was_asked_for(placed):
    assert placed.plan.names == ["pinch", "lift", "place"]
    assert graspless.check(placed.plan) == []
    X_WO = end_of(placed)
    assert X_WO[:2, 3] == pytest.approx([0.5, 0.0], abs=1e-3)
    assert yaw_of(X_WO) == pytest.approx(1.2, abs=1e-3)
    assert X_WO[2, 3] == pytest.approx(0.0, abs=2e-3)
    stage = placed.plan.stages[-1]
    assert [segment.name for segment in stage.segments] == ["transfer", "lower", "open", "retreat"]


def test_the_hand_opens_as_it_was_before_it_closed(placed):
    pinch, _, place = placed.plan.stages
    robot = pinch.task.problem.robot
    hand = [robot.joint_names.index(name) for name in robot.joint_names if "finger" in name]
    before = next(s for s in pinch.segments if s.name == "close").positions[0]
    assert place.segments[-1].positions[-1][hand] == pytest.approx(before[hand])


def test_it_stands_there_in_the_simulation(placed):
    trial = graspless.simulate(placed.plan, record=True).trials[0]
    assert trial.failures == ()
    assert trial.measures["place_error"] < 0.01
    assert trial.measures["place_angle"] < 0.1
    recording = trial.recording
    assert list(dict.fromkeys(recording.names))[-5:] == ["raise", "hold", "open", "retreat", "rest"]
    off = np.linalg.norm((recording.object_poses - recording.planned_poses)[:, :3, 3], axis=1)
    assert off.max() < 0.01


def test_the_simulation_notices_a_hand_that_does_not_let_go(placed):
    plan = reloaded(placed.plan)
    stage = plan.stages[-1]
    closed = stage.segments[1].positions[-1]
    robot = stage.task.problem.robot
    fingers = [i for i, name in enumerate(robot.joint_names) if "finger" in name]
    changed = []
    for segment in stage.segments:
        positions = np.array(segment.positions)
        positions[:, fingers] = closed[fingers] + 0.15  # the squeeze stays
        if segment.name == "open":
            positions[-1, 0] += 1e-3  # a segment that moves
        changed.append(type(segment)(segment.name, positions, segment.object_poses))
    stage.segments = changed
    assert "not_placed" in graspless.simulate(plan).trials[0].failures


def test_a_card_is_put_down_over_an_edge(scene, names):
    found = graspless.pick(
        scene, names["card"], "wam_t42", place={"on": table_of(scene).name}, seconds=20
    )
    assert found, found.reason
    assert found.plan.names == ["slide", "lift", "place"]
    assert graspless.check(found.plan) == []
    table = table_of(scene)
    X_SO = np.linalg.inv(table.X_WS) @ end_of(found)
    polygon = graspless.geometry.Polygon(table.polygon)
    assert polygon.depth(X_SO[:2, 3]) >= 0.01
    ring = np.asarray(next(t for t in scene.objects if t.name == names["card"]).outline)
    corners = ring @ X_SO[:2, :2].T + X_SO[:2, 3]
    assert min(polygon.depth(p) for p in corners) < 0  # it lies over the edge
    assert graspless.simulate(found.plan).trials[0].failures == ()


@pytest.fixture(scope="module")
def shelf():
    """A scene with a shelf 10 cm above the table."""
    found = seen(BAR)
    X_WS = np.eye(4)
    X_WS[:3, 3] = 0.62, 0.25, 0.1
    corners = np.array([[-0.15, -0.1], [0.15, -0.1], [0.15, 0.1], [-0.15, 0.1]])
    added = perception.Support(
        name="shelf", polygon=corners, edges=4 * [perception.EdgeLabel.real], X_WS=X_WS
    )
    return perception.Scene(
        status=found.status,
        reason="",
        supports=[*found.supports, added],
        objects=list(found.objects),
        unseen=[],
        warnings=[],
    )


def test_another_support_of_the_scene(shelf):
    name, place = shelf.objects[0].name, {"on": "shelf"}
    found = graspless.pick(shelf, name, "wam_t42", place=place, seconds=20)
    assert found, found.reason
    assert graspless.check(found.plan) == []
    assert end_of(found)[2, 3] == pytest.approx(0.1, abs=1e-3)
    assert found.plan.stages[-1].task.problem.places.on == "scene shelf"
    trial = graspless.simulate(found.plan).trials[0]
    assert trial.failures == ()


def test_a_region_of_a_support_that_leans_is_straight_above_what_was_asked_for():
    X_WS = frames.from_rpy([0.2, -0.3, 0.5])
    X_WS[:3, 3] = 0.6, -0.1, 0.4
    square = np.array([[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]])
    leaning = perception.Support(
        name="ramp", polygon=square, edges=4 * [perception.EdgeLabel.real], X_WS=X_WS
    )
    corners = [[0.7, 0.0], [0.9, 0.0], [0.9, 0.2], [0.7, 0.2]]
    target = Target(None, place_of({"region": {"polygon": corners}}), leaning)
    there = frames.transform(X_WS, np.column_stack([target.region.vertices, np.zeros(4)]))
    assert there[:, :2] == pytest.approx(np.array(corners), abs=1e-12)


def test_a_region(scene, names):
    region = {"rectangle": {"center": [0.5, 0.0], "size": [0.2, 0.2]}}
    found = graspless.pick(scene, names["bar"], "wam_t42", place={"region": region})
    assert found, found.reason
    ring = np.asarray(next(t for t in scene.objects if t.name == names["bar"]).outline)
    X_WO = end_of(found)
    corners = ring @ X_WO[:2, :2].T + X_WO[:2, 3]
    assert (np.abs(corners - [0.5, 0.0]) < 0.1 + 2e-3).all()


@pytest.mark.parametrize(
    ("place", "words"),
    [
        ({"pose": {"x": 0.75, "y": -0.22}}, "the place is taken: '"),
        ({"pose": {"x": 0.55, "y": 0.14}}, "the place is taken: '"),
        ({"pose": {"x": 2.0, "y": 0.0}}, "cm beyond the edge of support_"),
        ({"pose": {"x": 0.305, "y": 0.0}}, "cm from the edge of support_"),
        (
            {"region": {"rectangle": {"center": [0.5, 0.0], "size": [0.05, 0.05]}}},
            "the region has 50 x 50 mm, the object ",
        ),
        (
            {"region": {"rectangle": {"center": [3, 0], "size": [0.5, 0.5]}}},
            "cm beyond the edge of support_",
        ),
    ],
)
def test_places_that_cannot_be(scene, names, place, words):
    found = graspless.pick(scene, names["bar"], "wam_t42", place=place)
    assert not found
    assert [attempt.status for attempt in found.attempts] == ["refused", *6 * ["not_tried"]]
    assert found.attempts[0].strategy == "place"
    assert words in found.attempts[0].reason
    assert f"place: {found.attempts[0].reason}" in found.reason


@pytest.mark.parametrize(
    ("place", "words"),
    [
        ({"on": "shelf"}, r"on: shelf: the scene has no 'shelf' \(one of: support_0"),
        ({}, "exactly one of pose, region must be given, not none"),
        ({"pose": {"x": 0.5, "y": 0}, "region": {"polygon": [[0, 0], [1, 0], [0, 1]]}}, "not pose"),
        ({"pose": {"x": 0.5}}, "place: pose.y: missing"),
        ({"pose": {"x": float("nan"), "y": 0}}, "pose.x"),
        ({"region": {}}, "exactly one of rectangle, polygon"),
        ({"region": {"polygon": [[0, 0], [1, 1], [1, 0], [0, 1]]}}, "place: region"),
        ({"under": "support_0"}, "under: unknown field"),
        ("support_0", "place: 'support_0': should have one of the fields pose, region and on"),
    ],
)
def test_mistakes_are_named(scene, names, place, words):
    with pytest.raises(TaskError, match=words):
        graspless.pick(scene, names["bar"], "wam_t42", place=place)


@pytest.mark.parametrize(
    ("field", "what"),
    [("yaw", "yaw: 90: is more than a turn; angles"), ("x", "x: 500: is more than 100 m; lengths")],
)
def test_degrees_and_millimetres_are_warned_of(scene, names, tmp_path, capsys, field, what):
    text = str({"x": 0.5, "y": 0.2, "yaw": 0.0} | {field: {"yaw": 90, "x": 500}[field]})
    perception.save_scene(scene, tmp_path / "scene.yaml")
    task = tmp_path / "pick.yaml"
    task.write_text(
        f"kind: pick\nscene: scene.yaml\nname: {names['card']}\nrobot: {{urdf: wam_t42}}\n"
        f"strategies: [pinch]\nplace: {{pose: {text}}}\n"
    )
    main(["pick", str(task), "--seconds", "0.1"])
    said = capsys.readouterr().err
    assert said.count(what) == 1
    assert f"pick.yaml:6: place.pose.{what}" in said
    scene_file, robot = str(tmp_path / "scene.yaml"), ["--robot", "wam_t42", "--seconds", "0.1"]
    main(["pick", scene_file, names["card"], *robot, "--place", f"pose: {text}"])
    assert f"place: pose.{what}" in capsys.readouterr().err


def test_a_region_in_millimetres_is_warned_of(scene, names):
    place = {"region": {"rectangle": {"center": [0.5, 0.2], "size": [300, 200]}}}
    with pytest.warns(UserWarning, match=r"place: region.rectangle.size\[0\]: 300: is more than"):
        graspless.pick(
            scene, names["bar"], "wam_t42", strategies=["pinch"], place=place, seconds=0.1
        )


def test_the_same_seed_gives_the_same_plan(scene, names, placed):
    place = {"pose": {"x": 0.5, "y": 0.0, "yaw": 1.2}}
    again = graspless.pick(scene, names["bar"], "wam_t42", place=place)
    for one, other in zip(placed.plan.segments, again.plan.segments, strict=True):
        assert np.array_equal(one.positions, other.positions)


def test_the_check_knows_the_places_that_were_asked_for(placed):
    def moved(document):
        document["task"]["stages"][-1]["place"]["poses"][0]["position"][0] += 0.01

    faults = graspless.check(reloaded(placed.plan, moved))
    assert any("place.poses is not what the chain's task says" in fault for fault in faults)


def test_nothing_follows_a_place(placed):
    document = placed.plan.task.to_dict()
    lift = {"name": "up", "kind": "carry", "line": {"direction": [0, 0, 1], "distance": 0.1}}
    document["stages"].append(lift)
    with pytest.raises(TaskError, match="'place' puts the object down: only a slide"):
        graspless.tasks.task_from_dict(document, "chain")


def test_the_trajectory_lets_the_squeeze_go(placed):
    from graspless.timing.squeeze import squeezed

    timed = graspless.time(placed.plan)
    held = squeezed(timed, 0.2)
    assert held.positions[-1] == pytest.approx(timed.positions[-1])
    closing = held.positions[:, -1] - np.interp(held.times, held.times, held.positions[:, -1])
    assert np.abs(closing).max() == 0
    steps = np.diff(held.times)
    assert (steps > 0).all()
    moved = np.diff(held.positions, axis=0)
    between = (held.velocities[1:] + held.velocities[:-1]) / 2 * steps[:, None]
    assert np.abs(moved - between).max() < 2e-3  # velocities are those of the positions


def test_the_command(scene, names, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    perception.save_scene(scene, "scene.yaml")
    robot = ("--robot", "wam_t42")
    bar = ["pick", "scene.yaml", names["bar"], *robot]
    assert main([*bar, "--place", "pose: {x: 0.5, y: 0.0}", "--png", "p.png"]) == 0
    said = capsys.readouterr().out
    assert "with wam_t42: pinch, then lift, then place" in said
    assert main(["check", "plan.json"]) == 0
    assert main(["check", "plan.json", "--certify"]) == 0
    capsys.readouterr()
    assert main([*bar, "--place", "pose: {x: 2, y: 0}"]) == 1
    assert "place  refused: its middle would be" in capsys.readouterr().out
    assert main([*bar, "--place", "on: shelf"]) == 2
    assert "the scene has no 'shelf'" in capsys.readouterr().err
    assert main([*bar, "--place", "[1"]) == 2
    assert "--place" in capsys.readouterr().err


def test_a_task_file_with_a_place(scene, names, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    perception.save_scene(scene, "scene.yaml")
    task = tmp_path / "pick.yaml"
    task.write_text(
        f"kind: pick\nscene: scene.yaml\nname: {names['bar']}\nrobot: {{urdf: wam_t42}}\n"
        "place: {pose: {x: 0.5, y: 0.0, yaw: 0.0}}\n"
    )
    assert main(["pick", "pick.yaml"]) == 0
    assert "then place" in capsys.readouterr().out
    task.write_text(task.read_text().replace("yaw", "jaw"))
    assert main(["pick", "pick.yaml"]) == 2
    assert "pick.yaml:5: place.pose.jaw: unknown field" in capsys.readouterr().err


def test_what_of_a_card_is_on_the_table_lies_in_the_region():
    scene = seen(CARD, BLOCK)
    card = min(scene.objects, key=lambda thing: thing.thickness)
    region = {"rectangle": {"center": [0.4, 0.2], "size": [0.3, 0.35]}}
    found = graspless.pick(scene, card.name, "wam_t42", place={"region": region}, seconds=20)
    assert found, found.reason
    ring = np.asarray(card.outline)
    X_WO = end_of(found)
    corners = ring @ X_WO[:2, :2].T + X_WO[:2, 3]
    over = corners[corners[:, 0] > 0.305]  # those on the table
    assert (np.abs(over - [0.4, 0.2]) < [0.15 + 2e-3, 0.175 + 2e-3]).all()
