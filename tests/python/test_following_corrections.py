# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Followers of slides in a world without physics: corrections and new plans."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import pytest
import yaml

import graspless
from following_common import CAMERA, CARD, PATIENT, World, phases
from graspless import frames, slide
from graspless.following import Follower, Settings
from graspless.following.guard import Guard
from graspless.following.hand import Hand
from graspless.following.replan import Replanner


@pytest.fixture(scope="module")
def plan():
    return graspless.plan(CARD)


@pytest.fixture(scope="module")
def turning():
    """A plan whose card turns by 42 degrees."""
    document = yaml.safe_load(CARD.read_text())
    return graspless.plan(document | {"options": {"refuse_lag": False}})


@pytest.mark.parametrize("off", [(0.004, 0, 0.03), (-0.002, 0.003, -0.05), (0, 0, 0.08)])
def test_small_deviations_are_corrected_in_place(plan, off):
    world = World(plan, *off, **CAMERA)
    assert world.run().status == "done"
    assert (world.follower.resumes, world.follower.restarts) == (0, 0)
    assert world.follower.plan is plan
    position, angle = world.error()
    assert position < 0.003  # a bias of 1.5 mm, and noise
    assert angle < np.radians(1.5)


def test_deviations_are_those_of_the_centre_of_mass(plan):
    """An outline may be written far from the origin of O."""
    document, far = yaml.safe_load(CARD.read_text()), np.array([0.6, 0.0])
    corners = [[0.06, 0.04], [-0.06, 0.04], [-0.06, -0.04], [0.06, -0.04]]
    x, y, _ = (plan.X_WO_start @ [*-far, 0, 1])[:3]
    thing = {"name": "card", "thickness": 0.003, "pose": {"x": x, "y": y, "yaw": 0.4}}
    polygon = (corners + far).tolist()
    found = graspless.plan(document | {"object": thing | {"polygon": polygon}})
    X_OC, X_CO = frames.translation([*far, 0]), frames.translation([*-far, 0])
    world = World(found)
    world.X_WO = world.X_WO @ X_OC @ frames.planar(0.003, 0, 0.05) @ X_CO
    world.run(lambda target: target.phase == "slide" and world.follower._course.clock > 1)
    world.X_WO = world.X_WO @ X_OC @ frames.planar(0.003, 0, -0.08) @ X_CO
    assert world.run().status == "done"
    assert world.follower.plan is found
    goal = np.linalg.inv(found.X_WO_goal @ X_OC) @ world.X_WO @ X_OC
    assert np.linalg.norm(goal[:3, 3]) < 0.002
    assert abs(goal[1, 0]) < np.radians(1)


def with_post(plan, path, x, y):
    """The same rows with a post in the world."""
    document = json.loads(plan.to_json())
    post = {"name": "post", "box": [0.01, 0.01, 0.3], "pose": {"position": [x, y, 0.2]}}
    document["task"]["obstacles"] = [post]
    path.write_text(json.dumps(document))
    return graspless.load_plan(path)


def touched(world):
    """Pairs that touched at any target."""
    around = slide.Surroundings(world.problem, world.plan.task.options)
    return {
        pair
        for target, X_WO in zip(world.targets, world.places, strict=True)
        for pair in around.touching(target.phase, target.position, X_WO)
    }


POSTS = [((0.005, 0), (0.699, 0.096)), ((0, 0.005), (0.664, 0.151))]


@pytest.mark.parametrize(("off", "post"), POSTS)
def test_a_shifted_path_keeps_clear_of_obstacles(turning, tmp_path, monkeypatch, off, post):
    changed = with_post(turning, tmp_path / "plan.json", *post)
    as_planned = World(changed)
    assert as_planned.run().status == "done"
    assert touched(as_planned) == set()
    world = World(changed, *off)
    assert world.run().status == "done"
    assert touched(world) == set()
    assert world.follower.restarts == 1
    monkeypatch.setattr(Guard, "ahead", lambda *_: "")
    careless = World(changed, *off)
    careless.run()
    assert touched(careless) == {"right_finger - post"}


@pytest.mark.parametrize(("kick", "restarts"), [(0.004, 0), (0.011, 1)])
def test_a_shift_that_would_touch_is_taken_back_where_the_hand_grasps(
    plan, monkeypatch, kick, restarts
):
    """Farther away the hand goes back and begins anew: another plan may lead past the edge."""

    def ahead(_, deviation, correction, _seconds):
        is_shifted = np.hypot(*correction.motion[:2]) > 5e-4
        return "a - b" if deviation.course.name == "grasp" and is_shifted else ""

    monkeypatch.setattr(Guard, "ahead", ahead)
    world = World(plan)
    world.run(until=lambda target: target.phase == "reach")
    world.kick(kick, 0, 0)
    assert world.run().status == "done"
    assert world.follower.restarts == restarts
    if not restarts:
        np.testing.assert_allclose(world.q, plan.segments[-1].positions[-1], atol=1e-3)


def test_noise_alone_leads_to_no_new_plan(plan):
    for seed in range(4):
        world = World(plan, seed=seed, **CAMERA)
        world.run(lambda target: target.phase == "lift")
        assert (world.follower.resumes, world.follower.restarts) == (0, 0)
        assert world.follower.plan is plan


def test_an_object_that_turns_less_than_the_finger_is_turned_further(turning):
    blind, world = World(turning, grip=0.7, camera=0), World(turning, grip=0.7, **CAMERA)
    blind.run()
    assert world.run().status == "done"
    assert blind.error()[1] > np.radians(10)
    assert world.error()[1] < np.radians(2)
    assert world.error()[0] < 0.004
    assert world.follower.resumes == 0
    assert world.follower.restarts <= 1


def test_a_start_elsewhere_is_planned_anew_before_the_arm_moves(plan):
    world = World(plan, 0.007, -0.007, 0.17, **CAMERA)
    target = world.run(lambda target: target.phase == "press")
    assert "planned anew" in target.reason
    assert world.follower.plan is not plan
    assert world.run().status == "done"
    assert (world.follower.resumes, world.follower.restarts) == (0, 0)
    assert world.error()[0] < 0.003


def kicked(plan, kick, **camera):
    world = World(plan, **camera)
    world.run(lambda target: target.phase == "slide")
    for _ in range(150):
        world.step()
    world.kick(*kick)
    return world


@pytest.mark.parametrize(
    ("kick", "rests"), [((-0.007, 0.007, -0.17), False), ((0.01, 0.0, 0.17), True)]
)
def test_a_kick_leads_to_a_new_plan(plan, kick, rests):
    world = kicked(plan, kick, **CAMERA)
    assert world.run().status == "done"
    speeds = np.array([np.abs(target.velocity).max() for target in world.targets])
    first = next(k for k, target in enumerate(world.targets) if "the rest anew" in target.reason)
    # Only a new path that turns back is begun from rest.
    assert (speeds[first - 20 : first + 50].min() < 0.01) == rests
    assert world.follower.resumes > 0
    assert world.follower.restarts == 0
    assert "retreat" not in phases(world)
    assert world.error()[0] < 0.004
    assert world.error()[1] < np.radians(2)


@pytest.mark.parametrize(("phase", "restarts"), [("grasp", 1), ("close", 0)])
def test_an_object_that_is_kicked_before_the_hand_has_closed(plan, phase, restarts):
    world = World(plan, **CAMERA)
    world.run(lambda target: target.phase == phase)
    world.kick(0.015, 0.02, 0.0)
    target = world.run()
    assert (target.status, world.follower.restarts) == ("done", restarts)
    place = "the hand has closed; the object is 2[3-7] mm from its place in it"
    assert re.fullmatch(place if phase == "close" else "", target.reason)
    if phase == "grasp":
        assert world.error()[0] < 0.004


def test_a_hand_that_closes_on_nothing_says_so(plan):
    world = World(plan)
    world.run(lambda target: target.phase == "close")
    world.X_WO[2, 3] -= 0.5
    target = world.run()
    assert target.status == "done"
    assert target.reason == "the hand has closed; the object is off its support in 5 poses"


@pytest.mark.parametrize(("kick", "restarts"), [((-0.006, 0.005, 0.0), 0), ((-0.02, 0.02, 0.0), 1)])
def test_without_a_new_plan_only_large_deviations_are_begun_anew(plan, monkeypatch, kick, restarts):
    monkeypatch.setattr(Replanner, "resume", lambda *_: (None, "no plan"))
    world = kicked(plan, kick, **CAMERA)
    assert world.run().status == "done"
    assert world.follower.restarts == restarts
    assert world.error()[0] < 0.004


@pytest.mark.parametrize("turn", [0.0, 0.15])
def test_an_object_that_hardly_turns_with_the_finger_is_grasped_as_it_lies(plan, turn):
    """New plans would turn it in vain, too."""
    world = kicked(plan, (0.0, 0.0, turn), grip=0.3, **CAMERA)
    assert world.run().status == "done"
    assert world.follower.restarts <= 1
    assert world.error()[0] < 0.004
    assert world.error()[1] < Settings().grasp_correct_angle


@pytest.mark.parametrize(("beyond", "correct"), [(0.005, 0.006), (0.001, 0.2)])
def test_the_finger_stays_on_an_object_that_falls_without_it(plan, monkeypatch, beyond, correct):
    """To begin anew it would lift at once, else at the end of the slide."""
    monkeypatch.setattr(Replanner, "resume", lambda *_: (None, "no plan"))
    world = World(plan)
    world.follower = Follower(plan, replace(PATIENT, correct=correct, shift=0))
    world.run(lambda target: target.phase == "slide")
    world.run(lambda _: world.follower._course.left < 0.002)
    polygon, com = world.problem.support.polygon, world.X_WO[:2, 3]  # of a card at z = 0
    out = -polygon.nearest_edge(com).inward
    world.kick(*(polygon.depth(com) + beyond) * out, 0)
    target = world.run()
    assert (target.status, target.phase) == ("stopped", "slide")
    assert target.reason.startswith("the centre of mass is beyond the support's edge")
    assert target.reason.endswith("; no plan") == (correct < 0.2)
    assert world.follower.restarts == 0
    for _ in range(50):
        held = world.step()
    np.testing.assert_array_equal(held.velocity, np.zeros_like(held.velocity))


def test_the_centre_of_mass_is_compared_with_the_edge_along_gravity(plan):
    """On a slope it is beyond the lower edge before the object's origin is."""
    hand = Hand(plan.task.problem)
    hand.X_WS = hand.X_WS @ frames.from_rpy([0, 0.1, 0])  # down towards +x
    hand.X_SW = np.linalg.inv(hand.X_WS)
    guard = Guard(plan, hand)
    guard._com = np.array([0, 0, 0.1, 1])
    edge = max(x for x, _ in plan.task.problem.support.polygon.vertices)
    assert [guard.falls(np.array([edge - x, 0, 0])) for x in (0.009, 0.011)] == [True, False]


def test_an_object_out_of_touch_is_touched_anew(plan):
    world = kicked(plan, (0.0, 0.12, 0.0), **CAMERA)
    world.run(lambda target: target.phase == "retreat")
    world.contact = None
    assert world.run().status == "done"
    assert world.follower.restarts == 1
    heights = [
        world.robot.pose(world.hand.fingertip, target.position)[2, 3] for target in world.targets
    ]
    lifted = [
        h for h, target in zip(heights, world.targets, strict=True) if target.phase == "retreat"
    ]
    assert max(lifted) - min(lifted) == pytest.approx(Settings().lift, abs=1e-3)
    assert world.error()[0] < 0.004


def test_an_object_that_never_follows_is_given_up(plan):
    world = World(plan, **CAMERA)
    world.effective_tip = lambda q: np.eye(4)
    target = world.run(seconds=300)
    assert target.status == "stopped"
    assert f"began anew {Settings().restarts} times" in target.reason
    assert world.follower.restarts == Settings().restarts
