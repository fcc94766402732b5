# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter of a follower: laws of a Kalman filter, delays, bias, and poses that jump."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from graspless import frames
from graspless.following import plane
from graspless.following.estimate import AGREEING, Estimate, Noise

PLACE = np.array([0.6, 0.1, 0.4])
places = st.tuples(*[st.floats(-2, 2)] * 2, st.floats(-3, 3)).map(np.array)


@given(places, places)
def test_places_are_poses_in_the_plane(a, b):
    both = frames.planar(*plane.compose(a, b))
    np.testing.assert_allclose(both, frames.planar(*a) @ frames.planar(*b), atol=1e-12)
    np.testing.assert_allclose(plane.compose(a, plane.inverse(a)), np.zeros(3), atol=1e-12)


@given(places, places, places)
def test_a_turn_about_a_point_moves_that_point_by_its_step_alone(a, pivot, step):
    motion = plane.turned(np.zeros(3), pivot[:2], step)
    moved = plane.compose(motion, np.array([*pivot[:2], 0.0]))
    np.testing.assert_allclose(moved[:2], pivot[:2] + step[:2], atol=1e-11)
    np.testing.assert_allclose(
        frames.planar(*plane.turned(a, pivot[:2], step)),
        frames.planar(*motion) @ frames.planar(*a),
        atol=1e-11,
    )


def seen(place, height=0.0, bias=(0, 0, 0), noise=None, random=None):
    exact = np.array([place[0] + bias[0], place[1] + bias[1], place[2], height + bias[2]])
    return exact if noise is None else exact + random.normal(size=4) * noise


def test_exact_poses_are_believed_where_the_bias_is_none():
    estimate = Estimate(PLACE, Noise(bias=1e-9))
    true = PLACE + [0.003, -0.002, 0.03]
    for k in range(200):
        assert estimate.measure(k / 30, seen(true, 0.001)) == "used"
    np.testing.assert_allclose(estimate.place, true, atol=2e-5)
    assert estimate.height == pytest.approx(0.001, abs=2e-5)


def test_errors_are_as_large_as_the_filter_says():
    """The normalised squared error of 4 numbers is 4 on average, over worlds drawn as assumed."""
    noise, squares = Noise(), []
    R = np.array([noise.position, noise.position, noise.angle, noise.position])
    for seed in range(300):
        random = np.random.default_rng(seed)
        spread = [noise.start, noise.start, noise.start_angle, noise.height]
        off = random.normal(size=4) * spread
        true, height = PLACE + off[:3], off[3]
        bias = random.normal(size=3) * noise.bias
        estimate = Estimate(PLACE, noise)
        tip, way = np.array([0.5, 0.0, 0.3]), 0.0
        for k in range(40):
            after = plane.turned(tip, tip[:2], np.array([0.002, 0.001, 0.01]))
            estimate.carry(k / 30, tip, after)
            step = plane.difference(tip, after)
            way = np.hypot(*step[:2]) + 0.05 * abs(step[2])
            slip = random.normal(size=3) * [noise.slip, noise.slip, noise.slip_angle]
            true = plane.compose(plane.compose(after, plane.inverse(tip)), true)
            true = true + slip * np.sqrt(way / 0.1)  # of the object, as in the frame of K
            tip = after
            estimate.measure(k / 30, seen(true, height, bias, R, random))
        error = np.append(plane.difference(estimate.place, true), height - estimate.height)
        # The covariance of K in the frame of the place: turned, as isotropic in x and y.
        c, s = np.cos(estimate._moved[2]), np.sin(estimate._moved[2])
        error[:2] = np.array([[c, s], [-s, c]]) @ error[:2]
        squares.append(error @ np.linalg.solve(estimate.covariance[:4, :4], error))
    assert np.mean(squares) == pytest.approx(4, rel=0.15)


def test_no_number_of_poses_beats_the_bias():
    noise = Noise()
    estimate = Estimate(PLACE, noise)
    for k in range(3000):
        estimate.measure(k / 30, seen(PLACE, bias=(0.0015, 0, 0)))
    # A prior of variance P and a bias of variance B: P B / (P + B), and the gain P / (P + B).
    P, B = noise.start**2, noise.bias**2
    assert estimate.spread[0] == pytest.approx(np.sqrt(P * B / (P + B)), rel=0.01)
    assert estimate.place[0] - PLACE[0] == pytest.approx(0.0015 * P / (P + B), rel=0.01)


def test_a_late_pose_is_compared_with_its_own_time():
    """An object that moves as predicted: exact poses 0.2 s late change nothing."""
    early, late = Estimate(PLACE, Noise()), Estimate(PLACE, Noise())
    tip, true = np.array([0.5, 0.0, 0.3]), [PLACE]
    for k in range(1, 61):
        after = plane.turned(tip, tip[:2], np.array([0.002, 0.001, 0.02]))
        true.append(plane.compose(plane.compose(after, plane.inverse(tip)), true[-1]))
        for estimate in (early, late):
            estimate.carry(k / 30, tip, after)
        tip = after
        early.measure(k / 30, seen(true[k]))
        if k > 6:
            assert late.measure((k - 6) / 30, seen(true[k - 6])) == "used"
    np.testing.assert_allclose(early.place, true[-1], atol=1e-12)
    np.testing.assert_allclose(late.place, true[-1], atol=1e-12)


def test_one_pose_that_jumps_is_not_used_and_several_that_agree_are():
    estimate = Estimate(PLACE, Noise())
    for k in range(30):
        estimate.measure(k / 30, seen(PLACE))
    before = estimate.place
    assert estimate.measure(1.0, seen(PLACE + [0.05, 0, 0])) == "jumped"
    np.testing.assert_array_equal(estimate.place, before)
    assert estimate.measure(1.03, seen(PLACE)) == "used"
    there = PLACE + [0.01, -0.003, 0.3]
    verdicts = [estimate.measure(1.1 + k / 30, seen(there)) for k in range(AGREEING)]
    assert verdicts == ["jumped"] * (AGREEING - 1) + ["moved"]
    np.testing.assert_allclose(estimate.place, there, atol=2e-3)
    assert estimate.measure(1.3, seen(there)) == "used"


def test_jumps_that_do_not_agree_are_never_used():
    estimate, random = Estimate(PLACE, Noise()), np.random.default_rng(3)
    for k in range(200):
        wild = PLACE + random.uniform(-0.5, 0.5, 3)
        if np.abs(wild - PLACE)[:2].max() > 0.05:
            assert estimate.measure(k / 30, seen(wild)) == "jumped"
    np.testing.assert_allclose(estimate.place, PLACE, atol=1e-12)


def test_a_covariance_weighs_a_pose():
    for factor in (0.1, 10.0):
        estimate = Estimate(PLACE, Noise(bias=1e-9))
        R = np.diag([factor * Noise().start ** 2] * 2 + [1e-4, 1e-6])
        estimate.measure(0.0, seen(PLACE + [0.004, 0, 0]), R)
        assert estimate.place[0] - PLACE[0] == pytest.approx(0.004 / (1 + factor), rel=1e-3)


def test_yaw_wraps():
    estimate = Estimate(np.array([0, 0, np.pi - 0.01]), Noise())
    for k in range(50):
        assert estimate.measure(k / 30, seen(np.array([0, 0, -np.pi + 0.01]))) == "used"
    assert abs(plane.wrapped(estimate.place[2] - (-np.pi + 0.01))) < 0.002
