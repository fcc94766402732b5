# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gymnasium's checker passes; the planner's actions hold, and others do not."""

import dataclasses
import os
import re
import sys

import numpy as np
import pytest

import graspless
from graspless import TaskError, frames

pytest.importorskip("gymnasium", reason="gymnasium is not installed (extra gym)")

if not os.environ.get("DISPLAY"):
    os.environ.setdefault("MUJOCO_GL", "egl")  # before MuJoCo is imported

import gymnasium
from gymnasium.utils.env_checker import check_env

import graspless.environments
from graspless.environments.draws import DRAWS, PHASES
from graspless.errors import shown

NAMES = ["SlideToEdge", "Tumble", "Clasp", "Pick"]


def made(name, **given):
    return gymnasium.make(f"graspless/{name}-v0", **given).unwrapped


def episode(env, seed, act):
    """Runs an episode; returns the observations, the last reward and the last info."""
    seen, ended = [env.reset(seed=seed)[0]], False
    while not ended:
        observation, reward, ended, truncated, info = env.step(act(env))
        assert not truncated
        assert ended or (reward == 0 and "is_success" not in info)
        seen.append(observation)
    return np.array(seen), reward, info


SOME = [pytest.param(name, marks=pytest.mark.long) for name in ("SlideToEdge", "Tumble", "Clasp")]


@pytest.mark.parametrize("name", ["Pick", *SOME])
def test_gymnasium_s_checker_passes(name):
    check_env(made(name), skip_render_check=True)  # a warning would be an error


def test_pictures_show_the_arm_as_it_moves():
    env, pictures = made("Pick", render_mode="rgb_array"), []
    env.reset(seed=2)
    try:
        env.render()
    except TaskError as error:
        pytest.skip(str(error))
    for _ in range(2):
        pictures.append(env.render().astype(int))
        for _ in range(50):
            env.step(env.expert())
    assert env.render().shape == (192, 256, 3)
    moved = np.abs(pictures[1] - pictures[0]).max(axis=2) > 50
    assert 0.001 < moved.mean() < 0.5  # not the whole picture
    check_env(env)
    env.close()


@pytest.mark.parametrize("name", NAMES)
def test_the_expert_holds_and_is_within_the_actions(name):
    env = made(name)
    actions = []

    def act(env):
        actions.append(env.expert())
        return actions[-1]

    seen, reward, info = episode(env, 2, act)
    assert (reward, info["is_success"], info["failures"]) == (1.0, True, ())
    assert np.abs(actions).max() < 1  # none was cut off
    assert seen.shape[1] == len(env.names) == env.observation_space.shape[0]
    assert graspless.check(env.plan) == []
    column = {name: seen[:, i] for i, name in enumerate(env.names)}
    dof = len(env.joint_names)
    np.testing.assert_allclose(seen[0, :dof], graspless.time(env.plan).positions[0], atol=0.02)
    phases = np.array([column[f"phase_{phase}"] for phase in PHASES[name]])
    np.testing.assert_array_equal(phases.sum(axis=0), 1)  # one at a time, and no unknown one
    assert (np.diff(column["time"]) > 0).all()
    goal = frames.from_row(
        [column[f"goal_{x}"][0] for x in ("x", "y", "z", "qw", "qx", "qy", "qz")]
    )
    np.testing.assert_allclose(goal, graspless.time(env.plan).object_poses[-1], atol=1e-6)


def test_the_expert_does_in_an_environment_what_simulate_does():
    env = made("Pick")
    seen, _, info = episode(env, 2, lambda env: env.expert())
    simulated = graspless.simulate(env.plan).trials[0]
    assert bool(simulated) is info["is_success"]
    for measure in ("carried", "position_error"):
        assert info["measures"][measure] == pytest.approx(simulated.measures[measure], abs=1e-3)
    assert len(seen) > 100


def test_velocities_are_those_of_the_positions():
    env = made("Pick")
    seen, *_ = episode(env, 2, lambda env: env.expert())
    dof = len(env.unwrapped.joint_names)
    time = np.array([observation[-1] for observation in seen])
    moved = np.diff([observation[:dof] for observation in seen], axis=0) / np.diff(time)[:, None]
    found = np.array([observation[dof : 2 * dof] for observation in seen])
    assert not found[0].any()
    assert np.abs(found).max() > 0.5
    np.testing.assert_allclose(found[1:], moved, atol=1e-3)  # of single precision


def test_an_arm_that_stands_still_gets_nothing():
    env = made("Pick")
    first = []

    def act(env):
        first[:] = first or [env.expert()]
        return first[0]

    _, reward, info = episode(env, 2, act)
    assert reward == 0
    assert info["failures"]


def test_the_same_seed_is_the_same_episode():
    one, other = made("Pick"), made("Pick")
    one.reset(seed=5)  # what came before does not matter
    first = episode(one, 2, lambda env: env.expert())
    again = episode(other, 2, lambda env: env.expert())
    np.testing.assert_array_equal(first[0], again[0])
    assert first[2]["measures"] == again[2]["measures"]


def test_tasks_differ_from_seed_to_seed():
    for draw in DRAWS.values():
        drawn = [draw(np.random.default_rng(seed)) for seed in (0, 0, 1)]
        assert drawn[0] == drawn[1] != drawn[2]


def test_a_varied_world_is_not_the_plan_s():
    env = made("Pick", varied=True)
    seen, _, _ = episode(env, 2, lambda env: env.expert())
    planned = graspless.time(env.plan).object_poses[0][:3, 3]
    place = seen[0][[env.names.index(f"object_{x}") for x in "xyz"]]
    assert 1e-5 < np.linalg.norm(place - planned) < 0.01


def test_bad_input_is_told(monkeypatch):
    with pytest.raises(TaskError, match="render_mode: human: should be None or rgb_array"):
        graspless.environments.PlanEnv("Pick", render_mode="human")
    with pytest.raises(TaskError, match="render: render_mode is None: should be rgb_array"):
        made("Pick").render()
    with pytest.raises(TaskError, match="name: Throw: should be one of SlideToEdge, Tumble"):
        graspless.environments.PlanEnv("Throw")
    with pytest.raises(TaskError, match="did you mean 'Tumble'"):
        graspless.environments.PlanEnv("tumbel")
    with pytest.raises(TaskError, match=r"name: \['Pick'\]: should be one of"):
        graspless.environments.PlanEnv(["Pick"])
    env = made("Pick")
    env.reset(seed=2)
    allowed = r"should be an array of shape \(8,\) of finite numbers in \[-1, 1\]$"
    for bad in ("x", None, [0.0, [1.0]], 8 * [10**400], np.full(8, np.nan), np.zeros(3)):
        with pytest.raises(TaskError, match=f"^action: {re.escape(shown(bad))}: {allowed}"):
            env.step(bad)
    episode(env, 2, lambda env: env.expert())
    with pytest.raises(TaskError, match="the episode has ended: should be reset first"):
        env.step(env.expert())
    task = DRAWS["Pick"](np.random.default_rng(0)) | {"budget": {"seconds": 1, "iterations": 0}}
    monkeypatch.setattr(env, "_draw", lambda _: task)
    with pytest.raises(TaskError, match="20 tasks in a row have no plan"):
        env.reset(seed=2)


def test_without_an_episode_a_reset_is_asked_for():
    env = made("Pick", render_mode="rgb_array")
    still = np.zeros(len(env.joint_names))
    for use in (lambda: env.step(still), env.expert, env.render):
        with pytest.raises(TaskError, match="no episode is running: should be reset first"):
            use()
    env.reset(seed=2)

    def interrupted():
        raise KeyboardInterrupt
        yield

    env._episode = dataclasses.replace(env._episode, steps=interrupted())
    with pytest.raises(KeyboardInterrupt):
        env.step(still)
    with pytest.raises(TaskError, match="should be reset first"):
        env.step(still)


def test_without_gymnasium_its_extra_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "gymnasium", None)
    for module in [name for name in sys.modules if name.startswith("graspless.environments")]:
        monkeypatch.delitem(sys.modules, module)
    with pytest.raises(TaskError, match="needs gymnasium: "):
        import graspless.environments.env  # noqa: F401


def test_without_opengl_rendering_says_what_to_set(monkeypatch):
    import mujoco

    def refuse(*_):
        raise RuntimeError("no display")

    monkeypatch.setattr(mujoco, "Renderer", refuse)
    env = made("Pick", render_mode="rgb_array")
    env.reset(seed=2)
    with pytest.raises(TaskError, match=r"cannot render here \(.*no display\): MUJOCO_GL is"):
        env.render()
