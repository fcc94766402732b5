# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slides in closed loop in MuJoCo: the camera's laws, and trials that open loop does not hold."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import graspless
from graspless import _data, frames
from graspless.errors import TaskError
from graspless.simulation.settings import Slide
from graspless.simulation.slide import FOLLOWED_MEASURES, MEASURES
from graspless.simulation.slide.closed_loop import Camera, CameraModel, FollowedExecution
from graspless.simulation.variation import Variation

EXAMPLES = _data.directory("examples")


@pytest.fixture(scope="module")
def plan():
    return graspless.plan(EXAMPLES / "01_slide_card.yaml")


class Moving:
    """An object that moves along x at 0.1 m/s."""

    t = 0.0

    def object_pose(self):
        return frames.translation([0.1 * self.t, 0.2, 0.3])


def watch(model, seconds=20.0, seed=(1, 2)):
    """Times of delivery, ages and poses of a camera that is asked 100 times a second."""
    camera, world, seen = Camera(model, seed), Moving(), []
    for k in range(round(100 * seconds)):
        world.t = k / 100
        found = camera.look(world.t, world)
        if found is not None:
            seen.append((world.t, found[1], found[0]))
    return camera, seen


EXACT = CameraModel(position=0, angle=0, bias=0, lost=0, burst=0)


def test_an_exact_camera_is_late_and_no_more():
    _, seen = watch(EXACT)
    assert len(seen) == pytest.approx(30 * (20 - 0.1), abs=2)
    for t, age, pose in seen:
        assert 0.1 - 1e-9 <= age < 0.1 + 0.01 + 1e-9
        np.testing.assert_allclose(
            pose, frames.translation([0.1 * (t - age), 0.2, 0.3]), atol=1e-12
        )


def test_noise_and_bias_are_as_large_as_the_model_says():
    model = dataclasses.replace(CameraModel(), lost=0, burst=0)
    camera, seen = watch(model, 60)
    assert np.linalg.norm(camera.bias) == pytest.approx(0.0015)
    errors = np.array([pose[:3, 3] - [0.1 * (t - age), 0.2, 0.3] for t, age, pose in seen])
    assert errors.mean(axis=0) == pytest.approx(camera.bias, abs=3e-4)
    assert errors.std(axis=0) == pytest.approx(np.full(3, 0.002), rel=0.1)
    turns = np.degrees([frames.to_rpy(pose) for *_, pose in seen])
    assert turns.std(axis=0) == pytest.approx(np.ones(3), rel=0.1)
    biases = [Camera(model, [seed]).bias for seed in range(200)]
    assert np.abs(np.mean(biases, axis=0)).max() < 3e-4  # of all directions


def test_poses_are_lost_one_by_one_and_in_bursts():
    _, single = watch(dataclasses.replace(EXACT, lost=0.1), 100)
    assert len(single) == pytest.approx(0.9 * 3000, rel=0.03)
    _, bursts = watch(dataclasses.replace(EXACT, burst=0.02), 100)
    gaps = np.diff([t for t, *_ in bursts])
    assert gaps.max() > 0.3
    assert 0.3 < len(bursts) / 3000 < 0.95


def test_a_camera_repeats_itself_by_its_seed():
    _, first = watch(CameraModel(), 3)
    _, again = watch(CameraModel(), 3)
    _, other = watch(CameraModel(), 3, (1, 3))
    assert all((a[2] == b[2]).all() for a, b in zip(first, again, strict=True))
    assert not all((a[2] == b[2]).all() for a, b in zip(first, other, strict=False))


@pytest.mark.slow
def test_a_start_elsewhere_matters_in_open_loop_alone(plan):
    opened = graspless.simulate(plan, seed=3, condition="start").trials[0]
    closed = graspless.simulate(plan, seed=3, condition="start", closed_loop=True).trials[0]
    assert opened.measures["position_error"] > 0.008
    assert opened.measures["angle_error"] > np.radians(8)
    assert closed.failures == ()
    assert closed.variation == opened.variation
    assert closed.measures["position_error"] < 0.004
    assert closed.measures["angle_error"] < np.radians(2.5)
    searched = set(closed.measures) & {"resume_seconds", "anew_seconds"}
    assert searched  # a kind of search that was not needed has no time
    assert set(closed.measures) | {"resume_seconds"} == set(MEASURES) | set(FOLLOWED_MEASURES)


@pytest.mark.slow
def test_a_kick_is_answered_by_a_new_plan(plan):
    closed = graspless.simulate(plan, seed=2, condition="kick", closed_loop=True).trials[0]
    assert closed.failures == ()
    assert closed.measures["resumes"] + closed.measures["restarts"] >= 1
    assert closed.measures["position_error"] < 0.005
    assert closed.measures["angle_error"] < np.radians(3)


@pytest.mark.slow
def test_an_object_that_is_taken_away_is_found_again(plan):
    """Displaced by more than its width: the contact is lost, and the failure is made good."""
    away = Variation(kick_x=-0.02, kick_y=-0.1)
    execution = FollowedExecution(plan, away, Slide(), [5])
    execution.run()
    assert execution.measures["restarts"] >= 1
    assert execution.judge.failures == []
    assert execution.measures["lift_height"] > 0.09


def test_a_follower_that_gives_up_is_a_failure(plan, monkeypatch):
    blind = dataclasses.replace(CameraModel(), lost=1.0)
    monkeypatch.setattr("graspless.simulation.slide.closed_loop.CameraModel", lambda: blind)
    execution = FollowedExecution(plan, Variation(), Slide(), [1])
    update = execution.followed.follower.update

    def joints_fail(t, q, *given, **more):
        return update(t, q * np.nan if t > 2.5 else q, *given, **more)

    monkeypatch.setattr(execution.followed.follower, "update", joints_fail)
    execution.run()
    assert execution.judge.failures == ["stopped"]
    assert "position_error" not in execution.measures


def test_the_same_seed_gives_the_same_trial(plan):
    found = []
    for _ in range(2):
        execution = FollowedExecution(plan, Variation(), Slide(), [7])
        execution.run("press")
        found.append((execution.followed.follower.estimate.place, execution.positions()))
    for one, other in zip(*found, strict=True):
        np.testing.assert_array_equal(one, other)


def test_other_plans_are_not_followed():
    plan = graspless.plan(EXAMPLES / "06_push_block.yaml")
    with pytest.raises(TaskError, match="closed_loop: fingertip plans cannot be followed"):
        graspless.simulate(plan, closed_loop=True)
    with pytest.raises(TaskError, match="condition: fingertip plans have none"):
        graspless.simulate(plan, condition="kick")


def test_a_hand_that_begins_anew_after_the_lift_slides_again(plan):
    execution = FollowedExecution(plan, Variation(), Slide(), [5])
    model = execution.scene.model
    contacts = ("geom_contype", "geom_conaffinity", "pair_margin")
    slides = [getattr(model, name).copy() for name in contacts]
    execution._end_of("lift", "reach")
    grasps = [getattr(model, name).copy() for name in contacts]
    assert not np.array_equal(slides[0], grasps[0])
    assert not np.array_equal(slides[2], grasps[2])
    execution._end_of("reach", "retreat")
    for name, before in zip(contacts, slides, strict=True):
        np.testing.assert_array_equal(getattr(model, name), before)


def test_a_slide_that_is_repeated_is_judged_by_its_last_end(plan):
    execution = FollowedExecution(plan, Variation(), Slide(), [5])
    goal, at = plan.X_WO_goal, execution.data.body("object")
    for off, failures in ((0.02, ["off_target"]), (0.001, [])):
        at.xpos, at.xquat = goal[:3, 3] + [off, 0, 0], frames.to_quaternion(goal)
        execution._end_of("slide", "lift")
        assert execution.judge.failures == failures
        assert execution.measures["position_error"] == pytest.approx(off)
        execution._end_of("lift", "retreat")
