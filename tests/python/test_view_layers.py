# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replays of every kind: what can be hidden, how fast they run, and what became of a plan."""

import re

import numpy as np
import pytest

import graspless
from clasp_common import PURSE
from fingertip_common import PUSH
from graspless import TaskError, frames, view
from graspless._data import directory
from graspless.kinds import part
from graspless.simulation.results import Recording
from graspless.tasks import read_task
from tasks_common import GOOD, last_positions, pixels, read_png, recording

pytest.importorskip("viser")

from graspless.view import bodies, clock, film, film_stage, replay  # noqa: E402
from graspless.view import server as servers  # noqa: E402

EXAMPLES = directory("examples")
BY_AN_ARM = (EXAMPLES / "12_t42_tumble.yaml").read_text()
TASKS = {"slide": GOOD, "fingertip": PUSH, "clasp": PURSE}
LAYERS = {
    "slide": {"robot", "object", "table", "goal", "trail", "contact", "caption"},
    "fingertip": {"object", "goal", "contacts", "fingers", "forces", "floor", "caption"},
    "clasp": {
        "robot", "object", "cloud", "loops", "target", "tree", "path", "curves", "chords", "caption"
    },
}  # fmt: skip

LEGENDS = {
    "slide": ["goal of the slide", "path of the fingertip", "contact of the fingertip"],
    "fingertip": ["goal", "contacts with floor and walls", "in force control", "contact force"],
    "clasp": ["clasped loop", "target", "point cloud", "search tree", "finger curves", "chords"],
}


@pytest.fixture(scope="module", params=TASKS)
def plan(request):
    plan = graspless.plan(read_task(TASKS[request.param], "task.yaml"))
    assert plan, plan.reason
    return plan


def replayed(plan, tmp_path, happened=None):
    """What is in the file of a replay, and its size."""
    view.write_html(plan, tmp_path / "a.html", happened)
    text = (tmp_path / "a.html").read_text()
    return recording(text), len(text)


def told(messages):
    """All that the caption says, in order."""
    first = [
        m["props"]["text"] for _, m in messages if m.get("name") == "/caption/text" and "props" in m
    ]
    return first[:1] + [m["updates"]["text"] for _, m in messages if "text" in m.get("updates", {})]


def test_every_layer_is_first_in_the_scene_tree(plan, tmp_path):
    found, size = replayed(plan, tmp_path)
    assert size < 2_000_000
    named = {m["name"] for _, m in found["messages"] if "name" in m}
    top = {name.split("/")[1] for name in named if name.startswith("/")}
    assert top - {"WorldAxes"} == LAYERS[plan.kind]


def test_legend_explains_the_colours(plan, tmp_path):
    view.write_html(plan, tmp_path / "a.html")
    _, _, legend = (tmp_path / "a.html").read_text().rpartition('<div id="legend"')
    for meaning in [plan.task.problem.object.name, *LEGENDS[plan.kind]]:
        assert meaning in legend


def test_layer_hides_what_is_in_it(plan):
    with servers.open_server(servers.free_port()) as server:
        stage = replay._stage(server, plan, None)
        assert set(stage.layers.handles) == LAYERS[plan.kind]
        for name, handle in stage.layers.handles.items():
            assert handle.name == f"/{name}"
            assert handle.visible
            handle.visible = False
        for row in (0, stage.rows // 2, stage.rows - 1):  # what moves stays hidden
            stage.show(row)
            assert not any(handle.visible for handle in stage.layers.handles.values())


def test_replay_takes_as_long_as_the_robot(plan, tmp_path):
    pytest.importorskip("toppra")
    found, _ = replayed(plan, tmp_path)
    robot = graspless.time(plan).duration
    assert robot < clock.LONGEST
    assert found["durationSeconds"] == pytest.approx(robot + replay.HOLD, abs=2 / replay.RATE)
    assert not [text for text in told(found["messages"]) if "as fast" in text]


def test_long_motion_is_shortened_and_says_so(plan, tmp_path, monkeypatch):
    pytest.importorskip("toppra")
    monkeypatch.setattr(clock, "LONGEST", 1.0)
    found, _ = replayed(plan, tmp_path)
    assert found["durationSeconds"] == pytest.approx(1.0 + replay.HOLD, abs=2 / replay.RATE)
    pace = graspless.time(plan).duration
    assert all(text.endswith(f"  ({pace:.1f} x robot speed)") for text in told(found["messages"]))


def test_without_toppra_the_pace_is_for_watching(plan, tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, f"graspless.timing.{plan.kind}", None)
    assert clock.clock_of(plan) is None
    found, _ = replayed(plan, tmp_path)
    assert found["durationSeconds"] > replay.HOLD


def simulated(plan, off):
    """A recording in which the object, and what holds it, ends up elsewhere than planned."""
    segments = getattr(plan, "joint_segments", None) or plan.segments
    moving = [segment for segment in segments if len(segment)]
    planned = np.concatenate([segment.object_poses for segment in moving])
    count = len(planned)
    dof = 0 if plan.kind == "fingertip" else len(plan.joint_names)
    positions = np.concatenate([s.positions for s in moving]) if dof else np.empty((count, 0))
    share = np.linspace(0, 1, count)[:, None]
    real = planned.copy()
    real[:, :3, 3] += share * off
    fingers = np.repeat(real[:, None, :3, 3], 2, axis=1) if not dof else np.empty((count, 0, 3))
    names = [segment.name for segment in moving for _ in range(len(segment))]
    return Recording(np.linspace(0, 4, count), positions, real, fingers, names, planned)


def test_recording_is_shown_beside_the_plan(plan, tmp_path):
    off = np.array([0.003, 0.0, 0.004])
    happened = simulated(plan, off)
    assert repr(happened) == f"<Recording of {len(happened.times)} moments, 4.00 s>"
    found, size = replayed(plan, tmp_path, happened)
    assert size < 2_000_000
    messages = found["messages"]
    assert found["durationSeconds"] == pytest.approx(4 + replay.HOLD, abs=2 / replay.RATE)
    last = last_positions(messages)
    np.testing.assert_allclose(last["/object"], happened.object_poses[-1, :3, 3], atol=2e-6)
    apart = np.subtract(last["/object"], last["/planned"])
    np.testing.assert_allclose(apart, off, atol=4e-6)
    assert told(messages)[0].endswith(": 0.0 mm, 0.0° from the plan")
    assert told(messages)[-1].endswith(": 5.0 mm, 0.0° from the plan")


@pytest.mark.parametrize("plan", ["slide", "clasp"], indirect=True)  # fingertips record them
def test_recording_without_the_plans_poses_is_told_of_by_segment(plan, tmp_path):
    pytest.importorskip("toppra")
    timed = graspless.time(plan)
    after = timed.times[-1] + np.array([0.1, 0.2])
    poses = np.concatenate([timed.object_poses, timed.object_poses[-1:].repeat(2, axis=0)])
    poses[-2:, 2, 3] += 0.1  # lifted, which no segment does
    positions = np.concatenate([timed.positions, timed.positions[-1:].repeat(2, axis=0)])
    times = np.concatenate([timed.times, after])
    names = [*timed.names, "raise", "raise"]
    happened = Recording(times, positions, poses, np.empty((len(times), 0, 3)), names)
    shown = film.recorded(plan, happened)
    np.testing.assert_allclose(shown.planned_poses[:-2], poses[:-2], atol=2e-4)
    np.testing.assert_allclose(shown.planned_poses[-1], poses[-3], atol=1e-9)
    texts = told(replayed(plan, tmp_path, happened)[0]["messages"])
    assert texts[-1] == "raise"
    assert "from the plan" in texts[-2]


@pytest.mark.parametrize(
    ("example", "name", "verb"),
    [
        ("01_slide_card", "card", "slides"),
        ("06_push_block", "block", "Sliding"),
        ("13_clasp_purse", "purse", "clasps"),
        ("24_carry_bar", "bar", "carries"),
        ("25_pinch_box", "box", "pinches"),
    ],
)
def test_title_has_an_article_before_a_word_alone(example, name, verb):
    task = (EXAMPLES / f"{example}.yaml").read_text()
    for given, shown in ((name, f"the {name}"), ("Mug 2", "Mug 2")):
        plan = graspless.plan(read_task(task.replace(f"name: {name}", f"name: {given}", 1), "task"))
        title = part("view", plan.kind, "picture").headline(plan)
        assert re.search(rf"\b{verb} {shown}\b", title), title


@pytest.mark.parametrize("text", [GOOD, BY_AN_ARM], ids=["slide", "fingertip by an arm"])
def test_a_plan_of_a_problem_that_no_file_can_express_is_drawn(text, tmp_path, monkeypatch):
    plan = graspless.plan(read_task(text, "task.yaml"))
    assert plan, plan.reason

    def refuse(task):
        raise TaskError("no task file can express it")

    monkeypatch.setattr(graspless.Task, "fields", property(refuse))
    with servers.open_server(servers.free_port()) as server:
        assert "robot" in replay._stage(server, plan, None).layers.handles
    view.write_png(plan, tmp_path / "a.png")
    assert len(pixels(read_png(tmp_path / "a.png"), bodies.OBJECT)) > 300


def test_distance_from_the_plan_is_that_of_the_center():
    center = np.array([0.1, 0.0, 0.0])
    turned = frames.translation([0.0, 0.0, 0.001]) @ frames.from_rpy([0, 0, np.pi / 2])
    assert film_stage.apart(np.eye(4), np.eye(4), center) == "0.0 mm, 0.0° from the plan"
    assert film_stage.apart(np.eye(4), turned, 0 * center) == "1.0 mm, 90.0° from the plan"
    far = 1000 * np.hypot(0.1 * np.sqrt(2), 0.001)
    assert film_stage.apart(np.eye(4), turned, center) == f"{far:.1f} mm, 90.0° from the plan"
