# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Moving averages of targets, against integrals, and corrections that start and stop."""

from __future__ import annotations

import numpy as np
import pytest

from graspless.following import Settings
from graspless.following.average import Average
from graspless.following.correction import Correction


def test_the_mean_is_that_of_the_polyline_over_the_window():
    random = np.random.default_rng(1)
    window, average = 0.04, Average(0.04, np.zeros(3))
    times, rows = [-1.0, 0.0], [np.zeros(3), np.zeros(3)]
    for seconds in random.uniform(1e-4, 0.1, 60):
        times.append(times[-1] + seconds)
        rows.append(random.normal(size=3))
        mean = average.add(seconds, rows[-1])
        fine = times[-1] - window * (np.arange(20000) + 0.5) / 20000
        oracle = [np.interp(fine, times, np.array(rows)[:, k]).mean() for k in range(3)]
        np.testing.assert_allclose(mean, oracle, atol=1e-5)


@pytest.mark.parametrize("rate", [50, 200, 1000])
def test_jumps_of_the_acceleration_become_ramps(rate):
    a, window = 5.0, 0.04
    average, means, q, v = Average(window, np.zeros(1)), [], 0.0, 0.0
    for k in range(rate):
        push = a if k < rate / 2 else -a
        q, v = q + v / rate + push / rate**2 / 2, v + push / rate
        means.append(average.add(1 / rate, np.array([q]))[0])
    steps = [np.abs(np.diff(means, n)).max() * rate**n for n in (2, 3)]
    assert steps[0] < a * (1 + 1e-6)
    assert steps[1] < 2 * a / window * (1 + 1e-6)


def test_a_motion_at_rest_is_its_own_mean_to_the_last_bit():
    q = np.array([0.1, -0.7, 1 / 3])
    average = Average(0.04, np.zeros(3))
    for _ in range(30):
        mean = average.add(0.007, q)
    np.testing.assert_array_equal(mean, q)


def test_corrections_start_and_stop_within_their_accelerations():
    settings, seconds = Settings(), 0.005
    correction = Correction(settings)
    moved = [np.append(correction.motion, correction.height)]
    for k in range(400):
        step, rise = (np.array([0.01, -0.02, 0.3]), 0.005) if k < 100 else (np.zeros(3), 0.0)
        correction.move(seconds, np.zeros(2), step, rise)
        moved.append(np.append(correction.motion, correction.height))
    assert correction.rests
    speeds = np.diff(moved, axis=0) / seconds
    accelerations = np.abs(np.diff(speeds, axis=0)) / seconds
    assert np.hypot(*speeds[99, :2]) == pytest.approx(settings.speed, rel=0.02)
    assert accelerations[:, 2].max() < settings.turn_acceleration + 1e-9
    assert accelerations[:, 3].max() < settings.acceleration + 1e-9
    np.testing.assert_array_equal(moved[-1], moved[-50])
