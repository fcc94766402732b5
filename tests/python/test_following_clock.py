# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clocks of loops: steps, jumps and faults, and followers whose time is a fault."""

from __future__ import annotations

import copy
import math
import pickle
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import graspless
from following_common import World
from graspless import _data
from graspless.following import Follower, Settings
from graspless.following.clock import JUMP, LEAST, Clock, number


@pytest.fixture(scope="module")
def plan():
    return graspless.plan(_data.directory("examples") / "01_slide_card.yaml")


@pytest.fixture
def sliding(plan):
    world = World(plan)
    world.run(lambda target: target.phase == "slide")
    for _ in range(20):
        world.step()
    return world


def started(period=0.01, t=5.0):
    clock = Clock(0.2)
    for k in range(100):
        clock.step(t + k * period)
    return clock, t + 99 * period


@pytest.mark.parametrize(
    "given", [3, 3.0, np.float32(3), np.int64(3), np.array(3.0), np.array(3), Fraction(3)]
)
def test_numbers_of_all_kinds_are_times(given):
    assert number(given) == (3.0, "")


@pytest.mark.parametrize(
    ("given", "fault"),
    [
        ("3", "str: should be a number"),
        (None, "NoneType: should be a number"),
        (True, "bool: should be a number"),
        (np.True_, "bool: should be a number"),
        (np.array(True), "bool: should be a number"),
        (3j, "complex: should be a number"),
        (Decimal("3.0"), "Decimal: should be a number"),
        (np.array([3.0]), r"array (1,): should be a number"),
        (10**400, "int too large for a float"),
        (np.nan, "nan: should be finite"),
        (-math.inf, "-inf: should be finite"),
    ],
)
def test_what_is_no_time_is_named(given, fault):
    found, said = number(given)
    assert math.isnan(found)
    assert fault in said


def test_steps_add_up_and_small_ones_are_gathered():
    clock = Clock(0.2)
    random = np.random.default_rng(0)
    times = 1e6 + np.cumsum(10 ** random.uniform(-9, -0.1, 500))
    steps = [clock.step(t) for t in times]
    assert all(not fault and (since == 0 or since >= LEAST) for since, fault in steps)
    assert sum(since for since, _ in steps) == pytest.approx(times[-1] - times[0], abs=LEAST)
    assert clock.now == times[-1]


@pytest.mark.parametrize("off", [1e9, 1e300, -1.0, -1e9, JUMP + 0.1])
def test_a_single_outlier_is_refused_and_forgotten(off):
    clock, t = started()
    since, fault = clock.step(t + off)
    assert since == 0
    assert fault.startswith("t: ")
    assert clock.step(t + 0.02) == (pytest.approx(0.02), "")
    assert clock.now == t + 0.02
    assert clock.step(t + off + 0.02)[1]  # the outlier is no clock any more


@pytest.mark.parametrize("off", [3.0, 1e9, -1.0, -1e6])
def test_a_clock_that_was_set_goes_on_without_the_jump(off):
    clock, t = started()
    assert clock.step(t + off)[1]
    for k in range(1, 40):
        since, fault = clock.step(t + off + 0.01 * k)
        assert not fault
        assert since == pytest.approx(0.01, rel=1e-4)
    assert clock.now == pytest.approx(t + 0.39, abs=1e-6)
    assert not clock.is_lost


@pytest.mark.parametrize("loop", [0.001, 0.01, 0.1])
@pytest.mark.parametrize(
    "wrong", [lambda t, k: t, lambda t, k: math.nan, lambda t, k: t - 1e-3 * k]
)
def test_a_clock_that_does_not_go_on_is_lost_after_the_patience(loop, wrong):
    clock, t = started(loop)
    lost = []
    for k in range(1, 400):
        assert clock.step(wrong(t, k))[1]
        lost.append(clock.is_lost)
    assert (lost.index(True) + 1) * loop == pytest.approx(0.2, abs=1.5 * loop)


def test_a_clock_that_creeps_is_lost_too():
    clock, t = started()
    faults = [clock.step(t + 1e-12 * k)[1] for k in range(1, 40)]
    assert not faults[0]
    assert faults[-1].endswith("stands still")
    assert clock.is_lost


def test_a_clock_that_ticks_less_often_than_the_loop_calls_is_not_lost():
    clock = Clock(0.2)
    for k in range(3000):
        clock.step(0.05 * (k // 50))  # 20 ticks and 1000 calls a second
        assert not clock.is_lost


@pytest.mark.parametrize("wrong", [lambda t: t, lambda t: np.nan, lambda t: "now"])
def test_a_follower_waits_for_its_clock_and_gives_up(sliding, wrong):
    t = wrong(sliding.t)
    before = sliding.targets[-1].position
    target = sliding.step(t=t, pose=sliding.X_WO)
    assert (target.status, target.pose) == ("waiting", "bad_time")
    calls = 1
    while target.status == "waiting":
        target = sliding.step(t=t)
        calls += 1
    assert calls / sliding.rate == pytest.approx(Settings().joint_seconds, abs=0.05)
    assert target.status == "stopped"
    assert target.reason.startswith("t: ")
    for _ in range(10):  # also where the clock goes on again
        target = sliding.step()
        assert target.status == "stopped"
        np.testing.assert_array_equal(target.position, before)
        assert np.abs(target.velocity).max() == 0


def test_a_fault_of_the_clock_is_forgotten_when_it_goes_on(sliding):
    for t in (np.nan, 1e9, None, -5.0):
        before = sliding.step()
        faulty = sliding.step(t=t)
        assert faulty.status == "waiting"
        assert faulty.reason.startswith("t: ")
        np.testing.assert_array_equal(faulty.position, before.position)
        after = sliding.step()
        assert (after.status, after.reason) == ("moving", "")
    assert sliding.run().status == "done"


@pytest.mark.parametrize("given", [None, np.nan])
def test_a_single_fault_of_the_clock_does_not_slow_the_motion_down(plan, given):
    """A clock of milliseconds gives a faster loop each time twice."""
    ends = []
    for is_faulty in (False, True):
        world = World(plan, rate=100.0, camera=0)
        world.follower = Follower(plan, Settings(look_seconds=0.0))
        while world.targets[-1:] == [] or world.targets[-1].phase == "approach":
            world.step()
            if is_faulty:
                world.follower.update(world.t if given is None else given, world.q)
        ends.append(world.t)
    assert ends[1] == pytest.approx(ends[0], abs=0.03)


def test_joints_are_checked_also_without_a_time(sliding):
    wrong = np.full(8, np.nan)
    for _ in range(9):
        assert sliding.step(q=wrong).status == "waiting"
    for _ in range(2):
        target = sliding.step(t=np.nan, q=wrong)
    assert (target.status, target.reason) == ("stopped", "q: should be finite")


def test_a_clock_that_was_set_does_not_end_the_motion(sliding):
    shift = 1e5
    assert sliding.step(t=sliding.t + shift).status == "waiting"
    sliding.t += shift
    assert sliding.run(seconds=shift + 90).status == "done"
    assert sliding.error()[0] < 5e-4


def test_times_that_differ_by_noise_keep_the_velocity(sliding):
    for _ in range(50):
        before = sliding.step()
        target = sliding.follower.update(np.nextafter(sliding.t, np.inf), sliding.q)
        assert (target.status, target.reason) == ("moving", "")
        np.testing.assert_array_equal(target.velocity, before.velocity)
        np.testing.assert_array_equal(target.position, before.position)
        short = sliding.follower.update(sliding.t + 2 * LEAST, sliding.q)
        np.testing.assert_allclose(short.velocity, before.velocity, atol=0.05)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, pickle.dumps])
def test_a_motion_in_progress_cannot_be_copied(plan, copied):
    with pytest.raises(TypeError, match="a Follower cannot be copied or pickled"):
        copied(Follower(plan))


def test_text_is_one_short_line(plan):
    assert repr(Follower(plan)) == "<Follower of 'card', approach>"
