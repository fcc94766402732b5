# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Followers of slides in a world without physics: arrivals, bounds, waiting, bad input."""

from __future__ import annotations

import copy
import dataclasses
import math
import re
from types import SimpleNamespace

import numpy as np
import pytest
import yaml

import graspless
from following_common import CAMERA, CARD, PATIENT, World, phases
from graspless import _data, frames, slide
from graspless.errors import TaskError
from graspless.following import Follower, Noise, Settings
from graspless.following.camera import Camera
from graspless.following.estimate import Estimate
from graspless.following.hand import Hand
from graspless.timing.settings import ACCELERATION, JERK


@pytest.fixture(scope="module")
def plan():
    return graspless.plan(CARD)


def test_a_world_as_planned_is_followed_to_the_end(plan):
    world = World(plan)
    assert world.run().status == "done"
    assert phases(world) == [segment.name for segment in plan.segments]
    np.testing.assert_allclose(world.q, plan.segments[-1].positions[-1], atol=2e-4)
    assert world.error()[0] < 5e-4
    assert world.error()[1] < 2e-3
    assert world.step().status == "done"
    np.testing.assert_array_equal(world.targets[-1].position, world.targets[-2].position)


def test_what_comes_after_the_end_does_not_undo_it(plan):
    world = World(plan, camera=0)
    assert world.run().status == "done"
    for _ in range(300):  # the clock stands still, and the arm is moved by hand
        target = world.follower.update(world.t, world.q + 0.5)
        assert (target.status, target.reason) == ("done", "")


def test_without_any_pose_the_plan_is_followed_blindly(plan):
    world = World(plan, camera=0)
    assert world.run().status == "done"
    np.testing.assert_allclose(world.q, plan.segments[-1].positions[-1], atol=1e-4)
    waited = [target.status for target in world.targets].count("looking") / world.rate
    assert waited == pytest.approx(Settings().look_seconds, abs=0.05)


def test_the_hand_keeps_away_while_it_reaches_and_not_where_it_grasps():
    plan = graspless.plan(CARD, seed=5)  # faster reaches end before the correction is complete
    world, back = World(plan, camera=0), -plan.X_WH_grasp[:3, 2]
    robot, frame = world.robot, world.hand.grasp_frame
    world.run(lambda target: target.phase == "grasp")
    reach = plan.segments[4]
    assert reach.name == "reach"
    off = robot.pose(frame, world.q)[:3, 3] - robot.pose(frame, reach.positions[-1])[:3, 3]
    assert off == pytest.approx(Settings().stand_off * back, abs=3e-4)
    world.run(lambda target: target.phase == "close")
    off = robot.pose(frame, world.q)[:3, 3] - plan.X_WH_grasp[:3, 3]
    assert np.linalg.norm(off) < 1e-4


def derivatives(world):
    """Velocity, acceleration and jerk [N - 3, dof] of the targets by differences, and phases."""
    positions = np.array([target.position for target in world.targets])
    steps = [np.diff(positions, k, axis=0) * world.rate**k for k in (1, 2, 3)]
    names = np.array([target.phase for target in world.targets])
    return [step[3 - k :] for k, step in enumerate(steps, 1)], names[3:]


def nothing(world):
    pass


def kick(world):
    world.run(lambda target: target.phase == "slide" and world.t > 8)
    world.kick(0.01, 0.0, 0.17)


def dark(world):
    world.run(lambda target: target.phase == "slide")
    world.camera = 0
    world.run(lambda target: target.status == "waiting")
    world.camera = 3


def out_of_touch(world):
    world.run(lambda target: target.phase == "slide" and world.t > 8)
    world.kick(0, 0.12, 0)
    world.run(lambda target: target.phase == "retreat")
    world.contact = None


@pytest.mark.parametrize("happens", [nothing, kick, dark, out_of_touch])
def test_targets_have_bounded_speed_acceleration_and_jerk(plan, happens):
    world = World(plan, x=0.004, yaw=0.05, rate=100.0, camera=3, **CAMERA)
    happens(world)
    assert world.run().status == "done"
    for k in (1, -1):
        given = world.targets[k].position - world.targets[k - 1].position
        np.testing.assert_allclose(given * world.rate, world.targets[k].velocity, atol=1e-9)
    (velocity, acceleration, jerk), _ = derivatives(world)
    assert (np.abs(velocity) / np.array(plan.task.problem.robot.max_velocity)).max() < 1
    bends = 1.5  # corrections near a singularity of the arm
    assert np.abs(acceleration).max() < bends * ACCELERATION[0]
    assert np.abs(jerk).max() < bends * JERK * ACCELERATION[0]


@pytest.mark.parametrize("yaw", [-0.06, 0.08])
def test_a_shifted_path_near_a_singularity_keeps_the_limits(yaw):
    plan = graspless.plan(_data.directory("examples") / "03_tilted_l_table.yaml")
    world = World(plan, rate=100.0, camera=3, yaw=yaw)
    world.run(lambda target: target.phase == "press")
    assert (world.follower.resumes, world.follower.restarts) == (0, 0)
    (velocity, acceleration, _), _ = derivatives(world)
    assert (np.abs(velocity) / np.array(world.robot.max_velocity)).max() < 0.9
    assert np.abs(acceleration).max() < 1.5 * ACCELERATION[0]


@pytest.mark.parametrize("gap", [0.05, 0.5, 30.0])
def test_after_a_pause_targets_go_on_smoothly(plan, gap):
    world = World(plan, rate=100.0, camera=0)
    world.run(lambda target: np.abs(target.velocity).max() > 1.2)
    before, period = world.q, 1 / world.rate
    world.t += gap - period
    positions = [before, *(world.step().position for _ in range(50))]
    speeds = np.abs(np.diff(positions, axis=0)).max(axis=1) * world.rate
    assert np.abs(positions[1] - before).max() < 3 * period * 1.3
    if gap > 0.1:  # the robot stands by then
        assert speeds[0] < 0.2
        assert np.abs(np.diff(speeds)).max() * world.rate < 2 * ACCELERATION[0]
        assert speeds[-1] > 0.5


@pytest.mark.parametrize("max_jerk", [JERK * ACCELERATION[0], 1e5])
def test_targets_of_a_fast_loop_are_as_smooth(plan, max_jerk):
    """Between samples of the motion they would go straight on, and then turn at once."""
    world = World(plan, rate=1000.0, camera=0)
    world.follower = Follower(plan, Settings(look_seconds=0.0), max_jerk=max_jerk)
    world.run(lambda target: target.phase == "slide")
    (_, acceleration, jerk), _ = derivatives(world)
    assert np.abs(acceleration).max() < ACCELERATION[0]
    assert np.abs(jerk).max() < max_jerk


def test_motions_that_take_hours_are_refused(plan):
    with pytest.raises(TaskError, match="approach: takes .* max_acceleration .* should be more"):
        Follower(plan, max_velocity=1e-5)


def test_targets_in_contact_accelerate_less(plan):
    world = World(plan, x=0.004, yaw=0.05, **CAMERA)
    world.run()
    (_, acceleration, _), names = derivatives(world)
    assert np.abs(acceleration[names == "slide"]).max() < 3  # limits of contact, and of corrections


def test_a_bound_on_the_jerk_makes_targets_smoother(plan):
    world = World(plan, rate=100.0, **CAMERA)
    world.follower = Follower(plan, PATIENT, max_jerk=50.0)
    assert world.run().status == "done"
    (_, _, jerk), _ = derivatives(world)
    bends = 1.5  # corrections near a singularity of the arm
    assert np.abs(jerk).max() < bends * 50


def test_a_slide_waits_without_poses_and_goes_on_with_them(plan):
    world = World(plan, **CAMERA)
    world.run(lambda target: target.phase == "slide")
    world.camera = 0
    target = world.run(lambda target: target.status == "waiting")
    assert target.reason.startswith("no usable pose for 0.7")
    for _ in range(50):
        still = world.step()
    assert np.abs(still.velocity).max() == 0
    world.camera = 2
    assert world.run().status == "done"
    assert world.error()[0] < 0.003


def test_a_slide_that_stays_blind_is_given_up(plan):
    world = World(plan, **CAMERA)
    world.run(lambda target: target.phase == "slide")
    world.camera = 0
    target = world.run()
    assert target.status == "stopped"
    assert target.reason.startswith("no usable pose for 5.0")
    for _ in range(100):
        held = world.step()
    np.testing.assert_array_equal(held.position, world.targets[-2].position)
    assert held.status == "stopped"


def test_time_without_poses_before_the_slide_is_not_lost_time_of_the_slide(plan):
    """The arm hides the object while it comes, and the slide waits for the next pose."""
    world, lost = World(plan, **CAMERA), 2.0
    world.follower = Follower(plan, dataclasses.replace(PATIENT, lost_seconds=lost))
    world.run(lambda target: target.phase == "approach" and target.status == "moving")
    hidden, world.camera = world.t, 0
    world.run(lambda target: target.phase == "slide")
    assert world.t - hidden > lost
    assert world.step().status == "waiting"
    began = world.t
    assert world.run().status == "stopped"
    assert world.t - began == pytest.approx(lost, abs=0.05)


REFUSED = {
    "a list": (lambda X: {"pose": [*X[:3, 3], 0, 0, 0, 1]}, "not_a_pose"),
    "transposed": (lambda X: {"pose": X.T}, "not_a_pose"),
    "flat": (lambda X: {"pose": X, "covariance": np.eye(6).ravel()}, "not_a_covariance"),
    "of zeros": (lambda X: {"pose": X, "covariance": np.zeros((6, 6))}, "not_a_covariance"),
    "vague": (lambda X: {"pose": X, "covariance": np.eye(6)}, "vague"),
    "no age": (lambda X: {"pose": X, "age": None}, "bad_age"),
    "late": (lambda X: {"pose": X, "age": 1.5}, "late"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_a_camera_whose_poses_are_all_refused_is_not_followed_blindly(plan, name):
    given, verdict = REFUSED[name]
    world = World(plan, camera=0)
    start = world.q
    while world.step(**given(world.X_WO)).status != "stopped":
        assert world.t < 9
    statuses = [target.status for target in world.targets]
    assert list(dict.fromkeys(statuses)) == ["looking", "waiting", "stopped"]
    assert {target.pose for target in world.targets} == {verdict}
    looked = statuses.count("looking") / world.rate
    assert looked == pytest.approx(Settings().blind_seconds, abs=0.05)
    assert world.targets[-1].reason == f"no usable pose for 5.0 s; the last one was {verdict}"
    np.testing.assert_array_equal(world.q, start)


def test_a_camera_that_comes_to_its_senses_is_used(plan):
    world = World(plan, camera=0)
    for _ in range(150):
        target = world.step(pose=world.X_WO[:3])
    assert (target.status, target.phase) == ("waiting", "approach")
    world.camera = 2
    assert world.run().status == "done"


def test_a_slide_does_not_go_on_with_poses_that_are_refused_from_the_middle_on(plan):
    world = World(plan, camera=0)
    world.run(lambda target: target.phase == "press")  # blindly, as there was none
    while world.step(pose=world.X_WO.T).status != "stopped":
        assert world.t < 90
    assert world.targets[-1].phase == "slide"
    assert world.targets[-1].reason.endswith("; the last one was not_a_pose")


def test_an_object_that_falls_ends_the_motion(plan):
    world = World(plan, **CAMERA)
    world.run(lambda target: target.phase == "slide")
    world.X_WO[2, 3] -= 0.3
    target = world.run()
    assert (target.status, target.pose) == ("stopped", "off_support")
    assert "off its support" in target.reason


def test_an_object_that_stands_over_the_edge_ends_the_motion(plan):
    world = World(plan, x=0.29 - plan.task.problem.X_WO_start[0, 3])
    target = world.run()
    assert target.status == "stopped"
    assert target.reason.startswith("object 'card' is off the support")


def turned(X, rpy):
    return X @ frames.from_rpy(rpy)


POSES = {
    "nothing": (lambda X: {}, "none"),
    "a pose": (lambda X: {"pose": X}, "used"),
    "with a covariance": (lambda X: {"pose": X, "covariance": 1e-6 * np.eye(6)}, "used"),
    "text": (lambda X: {"pose": "here"}, "not_a_pose"),
    "too small": (lambda X: {"pose": X[:3]}, "not_a_pose"),
    "no number": (lambda X: {"pose": X * np.nan}, "not_a_pose"),
    "infinite": (lambda X: {"pose": X + np.inf}, "not_a_pose"),
    "scaled": (lambda X: {"pose": 2 * X}, "not_a_pose"),
    "mirrored": (lambda X: {"pose": X @ np.diag([1.0, 1, -1, 1])}, "not_a_pose"),
    "a row of a matrix": (lambda X: {"pose": [1, 2, 3, [4]]}, "not_a_pose"),
    "covariance of text": (lambda X: {"pose": X, "covariance": "small"}, "not_a_covariance"),
    "covariance of 3": (lambda X: {"pose": X, "covariance": np.eye(3)}, "not_a_covariance"),
    "indefinite": (
        lambda X: {"pose": X, "covariance": np.diag([1.0, 1, 1, 1, 1, -1])},
        "not_a_covariance",
    ),
    "not symmetric": (
        lambda X: {"pose": X, "covariance": np.eye(6) + np.triu(np.ones((6, 6)), 1)},
        "not_a_covariance",
    ),
    "covariance nan": (lambda X: {"pose": X, "covariance": np.nan * np.eye(6)}, "not_a_covariance"),
    "vague": (lambda X: {"pose": X, "covariance": 0.003 * np.eye(6)}, "vague"),
    "of a round object": (
        lambda X: {"pose": X, "covariance": np.diag([1e-5, 1e-5, 1e6, 1e6, 1e6, 1e6])},
        "used",
    ),
    "vague and off": (
        lambda X: {"pose": frames.translation([2, 0, 0]) @ X, "covariance": np.eye(6)},
        "vague",
    ),
    "asymmetric by rounding": (
        lambda X: {"pose": X, "covariance": 1e-4 * (np.eye(6) + np.triu(np.full((6, 6), 1e-4), 1))},
        "used",
    ),
    "age below 0": (lambda X: {"pose": X, "age": -0.1}, "bad_age"),
    "age of a clock ahead": (lambda X: {"pose": X, "age": -0.004}, "used"),
    "age of an array": (lambda X: {"pose": X, "age": np.array(0.0)}, "used"),
    "age true": (lambda X: {"pose": X, "age": True}, "bad_age"),
    "age nan": (lambda X: {"pose": X, "age": np.nan}, "bad_age"),
    "age of text": (lambda X: {"pose": X, "age": "old"}, "bad_age"),
    "late": (lambda X: {"pose": X, "age": 5.0}, "late"),
    "old": (lambda X: {"pose": X, "age": 0.5}, "out_of_order"),
    "far": (lambda X: {"pose": frames.translation([0.1, 0, 0]) @ X}, "jumped"),
    "turned": (lambda X: {"pose": turned(X, [0, 0, 1.0])}, "jumped"),
    "beside": (lambda X: {"pose": frames.translation([2, 0, 0]) @ X}, "off_support"),
    "below": (lambda X: {"pose": frames.translation([0, 0, -0.1]) @ X}, "off_support"),
    "tilted": (lambda X: {"pose": turned(X, [0.5, 0, 0])}, "tilted"),
    "upside down": (lambda X: {"pose": turned(X, [np.pi, 0, 0])}, "tilted"),
}


@pytest.fixture(scope="module", params=["approach", "slide"])
def moving(plan, request):
    world = World(plan)
    world.run(lambda target: target.phase == request.param and target.status == "moving")
    return world


@pytest.mark.parametrize("name", POSES)
def test_each_pose_has_a_verdict_and_bad_ones_move_nothing(moving, name):
    given, verdict = POSES[name]
    for _ in range(6):
        moving.step()
    target = moving.step(**({"pose": None} | given(moving.X_WO.copy())))
    assert target.pose == verdict
    assert target.status == "moving"
    off = moving.follower._hand.place(moving.X_WO) - moving.follower.estimate.place
    assert np.abs(off).max() < 3e-3  # the estimate is where it was, a lag before the object


def test_a_covariance_is_that_of_the_origin_of_the_object(plan):
    """Where the yaw is uncertain, so is the place of a centre of mass beside the origin."""
    given, com = plan.task.problem, np.array([0.03, 0.0, 0.0015])
    thing, X_WO = given.object.with_com(com), plan.X_WO_start
    problem = slide.Problem(given.robot, given.hand, thing, given.support, X_WO, given.q_home)
    hand = Hand(problem)
    estimate, camera = Estimate(hand.place(X_WO), Noise()), Camera(problem, hand)
    sure = np.diag([1e-12] * 3 + [1e-6, 1e-6, 1e6])
    for k in range(3):  # of the yaw the task alone knows anything
        off = frames.translation([0.001, 0.002, 0]) @ X_WO @ frames.planar(0, 0, 0.15)
        assert camera.see(k / 30, off, sure, 0.0, 0.0, estimate) == "used"
    at = hand.pose(estimate.place)[:2, 3] - X_WO[:2, 3]
    np.testing.assert_allclose(at, [0.001, 0.002], atol=5e-4)


@pytest.mark.parametrize(("off", "verdict"), [(0.05, "jumped"), (2.0, "off_support")])
def test_one_wrong_pose_that_is_given_again_and_again_is_still_one(plan, off, verdict):
    """A loop of 100 Hz reads the poses of a camera of 30 Hz, with their true ages."""
    world, verdicts = World(plan, rate=100.0, camera=0), []
    for k in range(60):
        age = 0.04 + k % 6 / 100
        wrong = frames.translation([off, 0, 0]) if 30 <= k < 36 else np.eye(4)
        verdicts.append(world.step(pose=wrong @ world.X_WO, age=age).pose)
    once = ["out_of_order"] * 5
    assert verdicts == 5 * ["used", *once] + [verdict, *once] + 4 * ["used", *once]
    assert world.targets[-1].status != "stopped"


JOINTS = {
    "text": ("here", "q: should be an array of numbers"),
    "none": (None, "q: shape"),
    "too few": (np.zeros(3), r"q: shape \(3,\): should be \(8,\)"),
    "nan": (np.full(8, np.nan), "q: should be finite"),
    "elsewhere": (np.full(8, 1.0), "q: .* from its target"),
}


@pytest.mark.parametrize("name", JOINTS)
def test_joints_that_do_not_match_stop_the_motion(plan, name):
    given, reason = JOINTS[name]
    world = World(plan)
    world.run(lambda target: target.phase == "slide")
    target = world.step(q=given)
    assert target.status == "waiting"
    assert re.match(reason, target.reason)
    assert world.step().status == "moving"  # one bad reading is no end
    for _ in range(30):
        target = world.step(q=given)
    assert target.status == "stopped"
    assert re.match(reason, target.reason)
    for _ in range(60):
        target = world.step(q=given)
    assert np.abs(target.velocity).max() == 0


@pytest.mark.parametrize("name", JOINTS)
def test_a_first_reading_may_be_missing_but_not_far(plan, name):
    """An arm that is elsewhere would jump to its target."""
    given, reason = JOINTS[name]
    world = World(plan)
    target = world.step(q=given)
    assert target.status == ("stopped" if name == "elsewhere" else "waiting")
    assert re.match(reason, target.reason)
    if name == "elsewhere":
        return
    assert world.step().status == "looking"
    late = World(plan)
    late.step(q=given)
    assert late.step(q=np.full(8, 1.0)).status == "stopped"
    while world.step(q=given).status == "waiting":
        assert world.t < 1
    assert world.targets[-1].status == "stopped"
    waited = [target.status for target in world.targets].count("waiting") / world.rate
    assert waited == pytest.approx(Settings().joint_seconds, abs=0.05)


def test_times_that_do_not_increase_move_nothing(plan):
    world = World(plan)
    world.run(lambda target: target.phase == "press")
    before = world.targets[-1].position
    for t in (None, "now", np.nan, np.inf, 0.0, -1.0):
        target = world.step(t=t)
        np.testing.assert_array_equal(target.position, before)
        assert target.reason.startswith("t: ")
        assert np.abs(target.velocity).max() == 0


def test_a_loop_that_was_late_goes_on_where_it_was(plan):
    world = World(plan, camera=0)
    world.run(lambda target: target.phase == "slide")
    before = world.q
    world.t += 3.0
    assert np.abs(world.step().position - before).max() < 0.02


def test_an_error_inside_is_a_status(plan, monkeypatch):
    world = World(plan)
    world.run(lambda target: target.phase == "slide")

    def broken(*_):
        raise RuntimeError("no such thing")

    monkeypatch.setattr(world.follower.estimate, "carry", broken)
    target = world.step()
    assert (target.status, target.reason) == ("stopped", "RuntimeError: no such thing")
    assert world.step().status == "stopped"


def test_no_garbage_makes_it_raise(plan):
    random = np.random.default_rng(5)
    junk = [None, "x", np.nan, -1, np.zeros(8), np.eye(4), np.full((4, 4), np.nan), [], {}, 1e300]
    world = World(plan)
    for _ in range(600):
        picked = [junk[i] for i in random.integers(len(junk), size=5)]
        target = world.follower.update(*picked)
        assert target.position.shape == (8,)
        assert np.isfinite(target.position).all()


def test_what_cannot_be_followed_is_refused(plan):
    failed = copy.copy(plan)
    failed.status = graspless.slide.Status.not_connected
    with pytest.raises(TaskError, match="status is not_connected, not solved: nothing to follow"):
        Follower(failed)
    with pytest.raises(TaskError, match="contact_speed: -1: should be positive"):
        Follower(plan, contact_speed=-1)
    with pytest.raises(TaskError, match="settings: 5: should be following.Settings"):
        Follower(plan, 5)
    other = graspless.plan(_data.directory("examples") / "06_push_block.yaml")
    with pytest.raises(TaskError, match="fingertip: only slide plans can be followed"):
        Follower(other)
    way = next(segment for segment in plan.segments if segment.name == "slide")
    anew = slide.restart(plan, way.positions[len(way) // 2], way.object_poses[len(way) // 2])
    assert anew, anew.reason
    with pytest.raises(TaskError, match="plan: a restart cannot be followed"):
        Follower(anew)


def test_the_rest_of_a_slide_is_followed_from_where_the_object_is(plan):
    way = next(segment for segment in plan.segments if segment.name == "slide")
    k = len(way) // 2
    rest = slide.resume(plan, way.positions[k], way.object_poses[k])
    assert rest, rest.reason
    follower = Follower(rest, PATIENT)
    expected = follower._hand.place(way.object_poses[k])
    np.testing.assert_allclose(follower.estimate.mean[:3], expected, atol=1e-6)


@pytest.mark.parametrize(("off", "counts"), [(0.008, (1, 0)), (0.12, (0, 1))])
def test_the_rest_of_a_slide_is_planned_anew_before_the_arm_moves(plan, off, counts):
    """Pressed, a finger has no start for a whole plan: it is lifted first where it lost touch."""
    way = next(segment for segment in plan.segments if segment.name == "slide")
    k = len(way) // 2
    world = World(slide.resume(plan, way.positions[k], way.object_poses[k]))
    world.X_WO = way.object_poses[k]
    world.kick(0, off, 0)
    target = world.run(lambda target: target.status == "moving")
    np.testing.assert_allclose(target.position, way.positions[k], atol=1e-4)
    assert (world.follower.resumes, world.follower.restarts) == counts
    assert world.run().status == "done"
    assert world.error()[0] < 0.003


def test_a_search_that_later_poses_make_needless_does_not_keep_it_waiting(plan):
    world = World(plan)
    world.run(until=lambda target: target.status == "looking")
    world.follower._replanner.is_searching = True  # for a pose that was farther away
    assert world.run().status == "done"


@pytest.mark.parametrize(
    ("fields", "what"),
    [
        ({"brake_seconds": math.nan}, r"brake_seconds: nan: should lie in \[0.02, 10\]"),
        ({"brake_seconds": 0}, r"brake_seconds: 0: should lie in"),
        ({"gain": 1e4}, r"gain: 10000.0: should lie in \[0.01, 20\]"),
        ({"settle_seconds": -1}, r"settle_seconds: -1: should lie in \[0, inf\]"),
        ({"gain": 10**400}, "gain: 10"),
        ({"look_poses": -1}, "look_poses: -1: should not be negative"),
        ({"look_poses": "x"}, "look_poses: 'x': should be a whole number"),
        ({"noise": None}, "noise: None: should be a following.Noise"),
    ],
)
def test_settings_that_no_robot_should_follow_are_refused(fields, what):
    with pytest.raises(TaskError, match=what):
        Settings(**fields)


def test_assumptions_of_the_filter_are_checked():
    with pytest.raises(TaskError, match=r"position: 0: should lie in"):
        Noise(position=0)
    with pytest.raises(TaskError, match=r"bias: inf: should lie in \[0, 1.6\]"):
        Noise(bias=math.inf)


def test_corrections_may_be_turned_off(plan):
    names = ("correct", "correct_angle", "grasp_correct", "grasp_correct_angle", "shift")
    names += ("shift_angle", "settled", "settled_angle", "settle_seconds", "settle_most")
    world = World(plan, camera=0)
    world.follower = Follower(plan, Settings(**dict.fromkeys(names, 0)))
    assert world.run().status == "done"


def test_a_search_is_spread_over_updates(plan):
    settings = Settings(search_seconds=1e-5, plan_seconds=0.5)
    world = World(plan, 0.007, -0.007, 0.17, **CAMERA)
    world.follower = Follower(plan, settings)
    searches, search = [], slide.plan
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(slide, "plan", lambda *given: searches.append(given[2]) or search(*given))
        world.run(lambda target: target.phase == "press")
    assert "planned anew" in world.targets[-1].reason
    assert len(searches) > 3
    np.testing.assert_allclose(
        [b.seconds for b in searches], 1e-5 * 2.0 ** np.arange(len(searches))
    )
    assert len({budget.seed for budget in searches}) == len(searches)
    looking = [target.velocity for target in world.targets if target.status == "looking"]
    assert np.abs(looking).max() == 0


def test_searches_double_as_the_page_says(plan, monkeypatch):
    """Of docs/howto/closed-loop.md: during the slide and at rest; also with the largest seed."""
    asked = []

    class Nothing:
        status, reason = "not_connected", ""

        def __init__(self, budget):
            asked.append(budget.seconds)
            self.statistics = SimpleNamespace(seconds=budget.seconds)

        def __bool__(self):
            return False

    monkeypatch.setattr(slide, "plan", lambda *given: Nothing(given[2]))
    monkeypatch.setattr(slide, "resume", lambda *_, budget, **__: Nothing(budget))
    replanner, q, place = Follower(plan)._replanner, plan.segments[0].positions[0], np.zeros(3)
    replanner._task = plan.task.with_changes(seed=2**64 - 1)
    for search, expected in (
        (lambda: replanner.resume(plan, q, place), [4] * 4 + [8] * 4 + [16] * 4 + [32, 6]),
        (lambda: replanner.anew(q, place), [4 * 2**k for k in range(8)] + [980]),
    ):
        asked.clear()
        search()
        while replanner.is_searching:
            search()
        np.testing.assert_allclose(asked, np.array(expected) / 1000)


def test_a_search_that_never_ends_is_given_up(plan):
    settings = Settings(search_seconds=1e-6, plan_seconds=1e-5)
    world = World(plan, 0.007, -0.007, 0.17, **CAMERA)
    world.follower = Follower(plan, settings)
    assert world.run().status == "stopped"
    assert world.targets[-1].reason


@pytest.fixture(scope="module")
def handle():
    """A plan for something as long and narrow as the handle of a knife."""
    document = yaml.safe_load(CARD.read_text())
    narrow = {"rectangle": {"size": [0.2, 0.03]}, "thickness": 0.012}
    thing = {key: value for key, value in document["object"].items() if key in ("name", "pose")}
    found = graspless.plan(document | {"object": thing | narrow})
    assert found, found.reason
    return found


@pytest.mark.parametrize(
    ("rpy", "verdict"),
    [((0.6, 0, 0), "used"), ((-0.6, 0, 0), "used"), ((0, 0.4, 0), "tilted"), ((2, 0, 0), "tilted")],
)
def test_a_handle_may_roll_under_the_finger_but_not_tip_over_the_edge(handle, rpy, verdict):
    world = World(handle)
    world.run(lambda target: target.phase == "slide")
    for _ in range(6):
        world.step()
    for _ in range(8):  # more than lead to the end of the motion
        target = world.step(pose=turned(world.X_WO, rpy))
    assert target.pose == verdict
    assert target.status == ("moving" if verdict == "used" else "stopped")


@pytest.mark.parametrize(("grip", "most", "off"), [(0.0, 0.1, 0.05), (0.5, 0.2, 0.02)])
def test_the_hand_stops_turning_at_the_goal_if_the_object_does_not_follow(handle, grip, most, off):
    """Its pad would roll the handle over."""
    world = World(handle, grip=grip)
    world.run(lambda target: target.phase == "slide")
    world.run(lambda target: world.follower._course.left < 0.005)
    before = world.follower._correction.motion[2]
    world.kick(0.0, 0.0, 0.08)
    world.run(lambda target: target.phase == "lift")
    assert 0.05 < abs(world.follower._correction.motion[2] - before) < most
    assert world.error()[1] < off
    assert world.run().status == "done"
