# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Quick timing of a path from a velocity to rest: its limits, and how it compares with toppra."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from graspless.timing.clip import clip
from graspless.timing.limits import Limits, Zone
from graspless.timing.path import rounded
from graspless.timing.ramps import Ramped, ramps
from graspless.timing.rates import Rate


def walk(seed, rows=30, step=0.05):
    """Rows of a path that turns, as plans have."""
    random = np.random.default_rng(seed)
    directions = np.cumsum(random.normal(size=(rows, 3)) * 0.2, axis=0) + random.normal(size=3)
    legs = directions / np.linalg.norm(directions, axis=1)[:, None]
    return np.cumsum(legs * step * random.uniform(0.2, 1, rows)[:, None], axis=0)


LIMITS = Limits(np.array([1.0, 0.5, 2.0]), np.array([2.0, 1.0, 0.5]), np.full(3, np.inf))


def zones(points, limits=LIMITS):
    """All rows as one zone."""
    return [Zone(slice(0, len(points)), limits, np.full(3, 1e-3))]


def ramped(points, rate, velocity=None, limits=LIMITS):
    """Samples of the motion at a rate [1/s]."""
    motion = Ramped(points, zones(points, limits), velocity)
    return motion.at(Rate(rate).times(motion.duration))


def rounded_walk(seed):
    return rounded(walk(seed), np.full((30, 3), 1e-3))


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("speed", [0.0, 0.05, 5.0])
def test_limits_hold_and_the_end_is_reached_at_rest(seed, speed):
    points = walk(seed)
    found = ramped(points, 2000, speed * (points[1] - points[0]))
    assert found.coordinates[0] == pytest.approx(points[0])
    assert found.coordinates[-1] == pytest.approx(points[-1])
    assert np.abs(found.velocities[-1]).max() < 1e-6
    assert (np.abs(found.velocities) <= LIMITS.velocity * 1.001).all()
    assert (np.abs(found.accelerations) <= LIMITS.acceleration).all()
    dt = found.times[1]
    moved = np.diff(found.coordinates, axis=0) / dt
    mean = (found.velocities[1:] + found.velocities[:-1]) / 2
    assert np.abs(moved - mean).max() < 1e-3  # positions and velocities are of one motion


@pytest.mark.parametrize("seed", range(5))
def test_the_fastest_motion_is_not_much_faster(seed):
    points = walk(seed)
    quick = ramped(points, 100).times[-1]
    best = clip(points, zones(points), Rate(100)).times[-1]
    assert 0.99 * best < quick < 1.6 * best


def test_a_pace_holds_everywhere():
    limits = replace(LIMITS, paces=[lambda q, dq: 10 + 5 * np.sin(9 * q[:, 0])])
    found = ramped(walk(3), 1000, limits=limits)
    path = rounded_walk(3)
    speeds = np.linalg.norm(found.velocities, axis=1)
    assert (speeds * limits.paces[0](found.coordinates, None) <= 1).all()
    assert found.times[-1] > 5 * path.length


def test_a_start_is_kept_along_the_path_and_slowed_down_where_it_is_too_fast():
    straight = np.linspace(0, 1, 21)[:, None] * np.array([[0.6, 0.3, 0.2]])
    u = straight[-1] / np.linalg.norm(straight[-1])
    across = np.cross(u, [0, 0, 1])
    for speed, kept in ((0.3, 0.3), (-0.2, 0.0), (50.0, None)):
        first = ramped(straight, 100, speed * u + 0.4 * across)
        along = float(first.velocities[0] @ u)
        if kept is not None:
            assert along == pytest.approx(kept, abs=1e-9)
        else:
            share = np.abs(first.velocities[0]) / LIMITS.velocity
            assert 0.8 < share.max() <= 1
    near = ramped(straight[:2], 1000, 50.0 * u)
    length = np.linalg.norm(straight[1])
    gain = 0.97 * (LIMITS.acceleration / 2 / u).min()  # by half of the limits, from the end back
    assert float(near.velocities[0] @ u) == pytest.approx(np.sqrt(2 * gain * length), rel=1e-6)


def test_a_reversal_rests_and_equal_points_are_one_sample():
    there = np.linspace(0, 0.4, 9)[:, None] * np.array([[1.0, 0.5, 0.2]])
    both = np.concatenate([there, there[::-1]])
    found = ramped(both, 500)
    turn = int(np.argmax(found.coordinates[:, 0]))
    assert np.abs(found.velocities[turn]).max() < 0.02
    assert found.coordinates[-1] == pytest.approx(there[0])
    still = Ramped(np.ones((3, 3)), zones(np.ones((3, 3))))
    assert still.duration == 0
    np.testing.assert_array_equal(still.at(np.array([0.0, 0.1])).coordinates, np.ones((2, 3)))


def test_single_times_are_those_of_all_and_after_the_end_it_rests():
    there = walk(2)
    points = np.concatenate([there, there[::-1]])  # two motions with a rest between them
    motion = Ramped(points, zones(points))
    times = np.linspace(0, motion.duration + 0.5, 101)
    all_at_once = motion.at(times)
    for k, t in enumerate(times):
        row, coordinates = motion.now(t)
        assert row == all_at_once.rows[k]
        np.testing.assert_array_equal(coordinates, all_at_once.coordinates[k])
    ended = times >= motion.duration
    np.testing.assert_allclose(all_at_once.coordinates[ended], points[-1:].repeat(ended.sum(), 0))


def test_the_squared_speed_is_linear_between_points_of_the_grid():
    motion = ramps(rounded_walk(1), zones(walk(1)), 0.1)
    assert motion.speeds[0] == pytest.approx(0.1)
    t = np.linspace(0, motion.duration, 4001)
    s, ds, dds = motion.at(t)
    assert (np.diff(s) >= 0).all()
    assert s[-1] == pytest.approx(motion.path.length)
    assert np.abs(np.diff(s) / np.diff(t) - (ds[1:] + ds[:-1]) / 2).max() < 1e-3
    inside = np.searchsorted(motion.times, t)
    same = inside[1:] == inside[:-1]
    assert np.abs(np.diff(ds) / np.diff(t) - dds[:-1])[same].max() < 1e-6
