# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picks of thin objects that are put down over an edge, and slid in from there."""

import json

import numpy as np
import pytest

import graspless
from graspless import perception, picking
from graspless.cli import main
from graspless.errors import TaskError
from graspless.plan_files import plan_of
from graspless.plan_files.text import document_of
from pick_common import BLOCK, CARD, seen

PLACE = {"pose": {"x": 0.55, "y": -0.1, "yaw": 0.2}}
PLATE = ([0.15, 0.15, 0.014], 0.6, 0.15, 0.007, 0.2)


@pytest.fixture(scope="module")
def scene():
    return seen(CARD, BLOCK)


@pytest.fixture(scope="module")
def slid(scene):
    """A card that is put down over an edge, and slid into the middle of the table."""
    found = graspless.pick(scene, card_of(scene), "wam_t42", place=PLACE, seconds=20)
    assert found, found.reason
    return found


def card_of(scene):
    return min(scene.objects, key=lambda thing: thing.thickness).name


def end_of(found):
    return found.plan.stages[-1].segments[-1].object_poses[-1]


def reloaded(plan, change):
    document = document_of(plan)
    change(document)
    return plan_of(json.loads(json.dumps(document)), "plan")


def test_a_card_lies_where_it_was_asked_for(slid):
    assert slid.plan.names == ["slide", "lift", "place", "slide_in"]
    X_WO = end_of(slid)
    assert X_WO[:2, 3] == pytest.approx([0.55, -0.1], abs=2e-4)
    yaw = np.arctan2(X_WO[1, 0], X_WO[0, 0]) % np.pi  # half a turn changes nothing
    assert yaw == pytest.approx(0.2, abs=1e-3)
    assert graspless.check(slid.plan) == []


def test_it_is_put_down_over_an_edge_first(slid):
    problem = slid.plan.stages[-1].task.problem
    X_SO = np.linalg.inv(problem.support.X_WS) @ problem.X_WO_start
    ring = np.asarray(problem.object.outline.vertices) @ X_SO[:2, :2].T + X_SO[:2, 3]
    assert min(problem.support.polygon.depth(p) for p in ring) < -0.02
    assert problem.support.polygon.depth(X_SO[:2, 3]) > 0.01


@pytest.mark.slow
def test_it_is_executed():
    """Without the block: a card creeps in compliant fingers, and ways keep no gap to obstacles."""
    scene = seen(CARD)
    found = graspless.pick(scene, card_of(scene), "wam_t42", place=PLACE, seconds=20)
    assert found.plan.names == ["slide", "lift", "place", "slide_in"]
    done = graspless.simulate(found.plan, trials=3)
    assert done, [trial.failures for trial in done.trials]
    for trial in done.trials:
        assert trial.measures["kept"] == 1
        assert trial.measures["place_error"] < 0.015


@pytest.mark.slow
def test_the_simulation_notices_a_slide_that_stops_early(slid):
    def stopped(document):
        segments = document["stages"][-1]["segments"]
        slide = next(segment for segment in segments if segment["name"] == "slide")
        half = len(slide["positions"]) // 2
        stop = slide["positions"][half]
        for segment in segments[segments.index(slide) :]:
            rows = segment["positions"]
            first = half if segment is slide else 0
            rows[first:] = [stop] * (len(rows) - first)

    trial = graspless.simulate(reloaded(slid.plan, stopped)).trials[0]
    assert "not_placed" in trial.failures
    assert trial.measures["place_error"] > 0.02


def test_a_recording_has_the_plan_to_its_end(slid):
    done = graspless.simulate(slid.plan, record=True)
    film = done.trials[0].recording
    assert film.planned_poses[-1] == pytest.approx(end_of(slid), abs=1e-6)
    off = np.linalg.norm((film.planned_poses - film.object_poses)[-1, :3, 3])
    assert off < 0.015


def test_check_finds_a_slide_that_ends_elsewhere(slid):
    def elsewhere(document):
        document["stages"][-1]["task"]["end"]["y"] += 0.01

    faults = graspless.check(reloaded(slid.plan, elsewhere))
    assert any("the object is not at its end" in fault for fault in faults)
    assert any("end.y is not what the chain's task says" in fault for fault in faults)


def test_check_finds_a_slide_that_begins_elsewhere(slid):
    def begun(document):
        for part in (document["stages"][-1]["task"], document["task"]["stages"][-1]):
            part["object"]["pose"] = {"x": 0.1, "y": 0.1, "yaw": 0.0}

    faults = graspless.check(reloaded(slid.plan, begun))
    assert any("the object is not at its start" in fault for fault in faults)


def test_a_region_in_the_middle(scene):
    region = {"rectangle": {"center": [0.6, -0.05], "size": [0.2, 0.2]}}
    found = graspless.pick(scene, card_of(scene), "wam_t42", place={"region": region}, seconds=20)
    assert found, found.reason
    assert found.plan.names[-1] == "slide_in"
    thing = next(thing for thing in scene.objects if thing.name == card_of(scene))
    X_WO = end_of(found)
    corners = np.asarray(thing.outline) @ X_WO[:2, :2].T + X_WO[:2, 3]
    assert (np.abs(corners - [0.6, -0.05]) < 0.1 + 2e-3).all()


@pytest.mark.slow
def test_another_support():
    found = seen(CARD)
    X_WS = np.eye(4)
    X_WS[:3, 3] = 0.6, -0.15, 0.15
    corners = np.array([[-0.18, -0.12], [0.18, -0.12], [0.18, 0.12], [-0.18, 0.12]])
    shelf = perception.Support(
        name="shelf", polygon=corners, edges=4 * [perception.EdgeLabel.real], X_WS=X_WS
    )
    scene = perception.Scene(
        status=found.status,
        reason="",
        supports=[*found.supports, shelf],
        objects=list(found.objects),
        unseen=[],
        warnings=[],
    )
    place = {"on": "shelf", "pose": {"x": 0.6, "y": -0.15}}
    picked = graspless.pick(scene, card_of(scene), "wam_t42", place=place, seconds=20)
    assert picked, picked.reason
    assert end_of(picked)[:3, 3] == pytest.approx([0.6, -0.15, 0.15], abs=2e-4)
    assert graspless.check(picked.plan) == []
    done = graspless.simulate(picked.plan)
    assert done, done.trials[0].failures


def test_a_plate():
    scene = seen(PLATE)
    place = {"pose": {"x": 0.6, "y": -0.1}}
    found = graspless.pick(
        scene, scene.objects[0].name, "wam_t42", place=place, strategies=["slide"], seconds=20
    )
    assert found, found.reason
    assert found.plan.names == ["slide", "lift", "place", "slide_in"]
    assert end_of(found)[:2, 3] == pytest.approx([0.6, -0.1], abs=2e-4)


def test_a_turn_that_friction_may_undo_is_a_reason(scene, monkeypatch):
    monkeypatch.setattr(picking.place, "EVEN", 0.0)  # the other way round is another pose
    thing = next(thing for thing in scene.objects if thing.name == card_of(scene))
    yaw = float(np.arctan2(thing.X_WO[1, 0], thing.X_WO[0, 0])) + np.pi
    place = {"pose": {"x": 0.55, "y": -0.1, "yaw": yaw}}
    found = graspless.pick(scene, card_of(scene), "wam_t42", place=place, strategies=["slide"])
    assert not found
    assert "picked up, but not put down: slide_in: " in found.reason
    assert "friction may leave the object turned by more than 5 deg" in found.reason


def test_only_a_slide_to_an_end_follows_a_place(slid):
    document = slid.plan.task.to_dict()
    del document["stages"][-1]["end"]
    with pytest.raises(TaskError, match="'place' puts the object down: only a slide with an `end`"):
        graspless.tasks.task_from_dict(document, "chain")


def test_the_command(scene, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    perception.save_scene(scene, "scene.yaml")
    pick = ["pick", "scene.yaml", card_of(scene), "--robot", "wam_t42"]
    assert main([*pick, "--place", json.dumps(PLACE), "--time", "20", "--png", "p.png"]) == 0
    assert "slide, then lift, then place, then slide_in" in capsys.readouterr().out
    assert main(["check", "plan.json"]) == 0
    assert main(["check", "plan.json", "--certify"]) == 0


def test_the_edge_over_which_it_was_grasped_is_tried_too(scene):
    """It is the last but one of those that are near the place; the arm reaches no other."""
    place = {"pose": {"x": 0.8, "y": 0.1}}
    found = graspless.pick(
        scene, card_of(scene), "wam_t42", place=place, strategies=["slide"], seconds=20
    )
    assert found, found.reason
    assert end_of(found)[:2, 3] == pytest.approx([0.8, 0.1], abs=2e-4)


def test_a_pose_over_an_edge_needs_no_slide(slid, scene):
    """The card stays where it is put down, if that is where it was asked for."""
    over = slid.plan.stages[2].segments[-1].object_poses[-1]
    yaw = float(np.arctan2(over[1, 0], over[0, 0]))
    place = {"pose": {"x": float(over[0, 3]), "y": float(over[1, 3]), "yaw": yaw}}
    found = graspless.pick(scene, card_of(scene), "wam_t42", place=place, seconds=20)
    assert found, found.reason
    assert found.plan.names == ["slide", "lift", "place"]
