# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rounded polylines and the fastest motion along them: laws, on any polyline."""

import numpy as np
import pytest
from hypothesis import Phase, example, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from toppra.algorithm import TOPPRA

from graspless.timing.clip import clip, split
from graspless.timing.fastest import fastest
from graspless.timing.limits import Limits, Zone
from graspless.timing.path import rounded, stretches
from graspless.timing.rates import Rate


@st.composite
def polylines(draw):
    shape = draw(st.integers(2, 8)), draw(st.integers(1, 4))
    steps = draw(arrays.arrays(float, shape, elements=st.floats(-0.5, 0.5, width=32)))
    return np.cumsum(np.round(steps, 3), axis=0)


@given(polylines(), st.sampled_from([1e-4, 1e-3, 1e-2]))
@settings(max_examples=60, deadline=None)
def test_a_path_keeps_to_its_polyline(points, tolerance):
    for rows in stretches(points):
        path = rounded(points[rows], np.full(points[rows].shape, tolerance))
        if path is None:
            continue
        s = np.linspace(0, path.length, 400)
        kept = points[rows][path.rows.astype(int)]
        straight = np.stack([np.interp(s, path.knots, column) for column in kept.T], axis=1)
        assert np.abs(path(s) - straight).max() <= tolerance + 1e-9
        np.testing.assert_allclose(path(s[[0, -1]]), points[rows][[0, -1]], atol=1e-9)
        for order in (0, 1):  # twice continuously differentiable
            joints = path.curve.x[1:-1]
            left, right = (path(joints + side, order) for side in (-1e-9, 1e-9))
            np.testing.assert_allclose(left, right, atol=1e-4)
        rates = np.gradient(path(s), s, axis=0, edge_order=2)[1:-1]
        assert np.abs(rates - path(s, 1)[1:-1]).mean() < 0.05


def limits_of(n, velocity, acceleration, jerk=np.inf, paces=()):
    return Limits(np.full(n, velocity), np.full(n, acceleration), np.full(n, jerk), paces)


def whole(points, limits, tolerance=1e-3):
    """All rows as one zone."""
    return [Zone(slice(0, len(points)), limits, np.full(points.shape[1], tolerance))]


# Its jerk is large for 7 ms only, between two jumps.
STAIRS = [
    [0.0, 0.0, 0.0],
    [-0.459, -0.459, -0.459],
    [-0.459, -0.459, -0.606],
    [-0.918, -0.918, -1.065],
    [-0.93, -1.377, -1.212],
    [-1.389, -1.836, -1.671],
    [-1.848, -2.295, -2.13],
]


@example(np.array(STAIRS), 1.9830953528250688, 0.2, 5.0)
@given(polylines(), st.floats(0.1, 3), st.floats(0.2, 10), st.floats(5, 100) | st.just(np.inf))
@settings(max_examples=40, deadline=None, phases=[Phase.explicit, Phase.reuse, Phase.generate])
def test_the_fastest_motion_keeps_its_limits(points, velocity, acceleration, per_acceleration):
    jerk = acceleration * per_acceleration
    limits = limits_of(points.shape[1], velocity, acceleration, jerk)
    timed = clip(points, whole(points, limits), rate=Rate(500.0))
    assert np.abs(timed.velocities).max() <= velocity * (1 + 1e-6)
    assert np.abs(timed.accelerations).max() <= acceleration * (1 + 1e-6)
    steps = np.abs(np.diff(timed.accelerations, axis=0))
    assert (steps <= jerk * np.diff(timed.times)[:, None] * (1 + 1e-6) + 1e-9).all()
    np.testing.assert_allclose(timed.velocities[[0, -1]], 0, atol=1e-6)
    np.testing.assert_allclose(timed.coordinates[[0, -1]], points[[0, -1]], atol=1e-6)
    farthest = np.abs(points - points[0]).max()
    assert timed.times[-1] >= max(farthest / velocity, np.sqrt(2 * farthest / acceleration)) - 1e-9


@pytest.mark.parametrize("jerk", [20, np.inf])
@pytest.mark.parametrize(("distance", "velocity", "acceleration"), [(1, 1, 2), (0.1, 5, 1)])
def test_a_straight_line_takes_the_time_of_the_textbook(distance, velocity, acceleration, jerk):
    line = np.array([[0.0, 0.0], [distance, 0.0]])
    path = rounded(line, np.full((2, 2), 1e-3))
    limits = limits_of(2, velocity, acceleration, jerk)
    if velocity**2 / acceleration < distance:  # a trapezoid, else a triangle
        seconds = distance / velocity + velocity / acceleration
    else:
        seconds = 2 * np.sqrt(distance / acceleration)
    seconds += 2 * acceleration / jerk  # in which the acceleration changes its sign
    assert fastest(path, whole(line, limits)).duration == pytest.approx(seconds, rel=5e-3)


@pytest.mark.parametrize("least", [1e-5, 5e-4])
def test_a_grid_with_which_toppra_fails_loses_its_short_steps(monkeypatch, least):
    stairs, real = np.array(STAIRS), TOPPRA.compute_parameterization
    zones = whole(stairs, limits_of(3, 2.0, 0.2, 1.0))
    path = rounded(stairs, np.full(stairs.shape, 1e-3))
    usual = fastest(path, zones).duration
    failed = []

    def fails_for_short_steps(solver, *ends):
        failed.append(np.diff(solver.gridpoints).min() < least)
        return (None, None, None) if failed[-1] else real(solver, *ends)

    monkeypatch.setattr(TOPPRA, "compute_parameterization", fails_for_short_steps)
    motion = fastest(path, zones)
    assert any(failed)
    assert not all(failed)
    assert motion.duration == pytest.approx(usual, rel=0.05)
    _, v, a, j = motion.coordinates(np.linspace(0, motion.duration, 5000))
    for values, most in ((v, 2.0), (a, 0.2), (j, 1.0)):
        assert np.abs(values).max() <= most * (1 + 1e-6)


def test_each_zone_has_its_own_limits_and_the_motion_does_not_rest_between_them():
    points = np.array([[0.0, 0.0], [0.5, 0.0], [1.0, 0.0], [1.0, 0.5]])
    fast, slow = limits_of(2, 1.0, 5.0, 100.0), limits_of(2, 0.2, 0.5, 10.0)
    tolerance = np.full(2, 1e-3)
    zones = [Zone(slice(0, 2), fast, tolerance), Zone(slice(1, 4), slow, tolerance)]
    timed = clip(points, zones, Rate(1000.0), marks=[1, 2])
    x, v, a = timed.coordinates[:, 0], timed.velocities, timed.accelerations
    assert np.abs(v[x > 0.5]).max() <= 0.2 * (1 + 1e-6)
    assert np.abs(a[x > 0.5]).max() <= 0.5 * (1 + 1e-6)
    assert v[x < 0.5, 0].max() > 0.9
    inside = (timed.rows > 0.1) & (timed.rows < 2.9)
    assert np.linalg.norm(v[inside], axis=1).min() > 0.01
    first, second, third = split(timed, [1, 2, 3])
    np.testing.assert_allclose(first.coordinates[-1], points[1], atol=1e-9)
    np.testing.assert_allclose(second.coordinates[-1], points[2], atol=2e-3)  # round a corner
    assert [part.rows[-1] for part in (first, second, third)] == [1, 1, 1]
    assert min(part.times[0] for part in (second, third)) > 0
    total = sum(part.times[-1] for part in (first, second, third))
    assert total == pytest.approx(timed.times[-1])


def test_a_pace_is_kept_along_the_way():
    line = np.array([[0.0], [1.0]])
    slow_end = limits_of(1, 1.0, 5.0, paces=[lambda q, dq: np.abs(dq[:, 0]) / 0.1 * q[:, 0]])
    timed = clip(line, whole(line, slow_end), rate=Rate(1000.0))
    q, v = timed.coordinates[:, 0], timed.velocities[:, 0]
    assert (v * q <= 0.1 * (1 + 1e-6)).all()
    assert v[q < 0.08].max() > 0.8


def test_turning_back_comes_to_rest():
    there_and_back = np.array([[0.0, 0.0], [0.5, 0.0], [0.0, 0.01]])
    assert [(s.start, s.stop) for s in stretches(there_and_back)] == [(0, 2), (1, 3)]
    zones = whole(there_and_back, limits_of(2, 1.0, 5.0))
    timed = clip(there_and_back, zones, rate=Rate(1000.0))
    at_turn = np.argmin(np.abs(timed.rows - 1))
    np.testing.assert_allclose(timed.velocities[at_turn], 0, atol=0.01)
    np.testing.assert_allclose(timed.coordinates[at_turn], [0.5, 0], atol=1e-4)


def test_rows_that_do_not_move_are_passed():
    points = np.array([[0.0], [0.0], [1.0], [1.0], [2.0], [2.0]])
    timed = clip(points, whole(points, limits_of(1, 1.0, 1.0)), rate=Rate(100.0))
    assert timed.rows[-1] == 5
    assert (np.diff(timed.rows) >= 0).all()
    halves = np.interp(timed.rows, np.arange(6), points[:, 0])
    np.testing.assert_allclose(halves, timed.coordinates[:, 0], atol=1e-9)
    for rows in (points[:2], points[:1]):
        still = clip(rows, whole(rows, limits_of(1, 1.0, 1.0)), rate=Rate(100.0))
        assert len(still.times) == 1
        np.testing.assert_array_equal(still.velocities, [[0.0]])


@pytest.mark.parametrize("doubled", [[2], [0], [1, 2], [2, 2], [3], [0, 1, 2, 3, 4]])
@pytest.mark.parametrize("way", ["corner", "ahead", "back"])
def test_a_part_ends_where_its_last_row_is_in_spite_of_equal_rows(doubled, way):
    onward = {"corner": [0.0, 1.0], "ahead": [1.0, 0.0], "back": [-1.0, 0.0]}[way]
    last = np.array([1.0, 0.0])
    once = np.array([[0.0, 0.0], [0.5, 0.0], last, last + 0.5 * np.array(onward), last + onward])
    numbers = np.sort([*range(5), *doubled])
    points = once[numbers]
    for mark in np.flatnonzero(numbers == 2).tolist():
        fast, slow = limits_of(2, 1.0, 5.0, 250.0), limits_of(2, 0.2, 5.0, 250.0)
        far, near = np.full(2, 1e-3), np.full(2, 1e-4)
        zones = [Zone(slice(0, mark + 1), fast, far), Zone(slice(mark, len(points)), slow, near)]
        marks = [mark, len(points) - 1]
        first, second = split(clip(points, zones, Rate(100.0), marks[:-1]), marks)
        assert [first.rows[-1], second.rows[-1]] == [mark, len(points) - 1 - mark]
        np.testing.assert_allclose(first.coordinates[-1], last, atol=1e-4)
        assert np.abs(first.velocities).max() > 0.9
        assert np.abs(second.velocities).max() <= 0.2 * (1 + 1e-6)
