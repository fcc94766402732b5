# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Behaviour cloning: a policy for tumbling blocks is learned from demonstrations of the planner.

    graspless demonstrate Tumble -o tumbles --episodes 300
    python clone_planner.py tumbles 50

It prints how many of 50 new tasks the policy and the planner do.

The planner's commands depend on the task and the time alone. So the policy is a regression for each
moment of each phase: quadratic in the place of the block and in its two heights, which are in the
first observation. An arm of seven joints has many ways to a pose. Averages of two ways are none, so
the few episodes that take another way than most are left out.
"""

import sys
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq

from graspless.environments import PlanEnv

RATE = 50  # frames a second
FIRST = 10**6  # seed of the first new task
FEATURES = ("object_x", "object_y", "object_z", "goal_z")


class Policy:
    """Regressions of actions on tasks, for each moment of each phase."""

    def __init__(self, names: list[str], folder: Path) -> None:
        self._features = [names.index(name) for name in FEATURES]
        self._clock = names.index("phase_time")
        found = pq.read_table(folder / "data/chunk-000/file-000.parquet")
        cuts = np.flatnonzero(np.diff(found["episode_index"].to_numpy())) + 1
        states, actions = (
            np.split(
                found[name].combine_chunks().flatten().to_numpy().reshape(len(found), -1), cuts
            )
            for name in ("observation.state", "action")
        )
        tasks = np.array([state[0, self._features] for state in states])
        self._mean, self._std = tasks.mean(axis=0), tasks.std(axis=0)
        phases = [self._phases(*episode) for episode in zip(states, actions, strict=True)]
        places = np.array([episode[1][0] for episode in phases])  # of the arm before the contact
        usual = np.abs(places - np.median(places, axis=0)).max(axis=1) < 0.1
        self.episodes = int(usual.sum())
        X = np.array([self._terms(task) for task in tasks])[usual]
        kept = [episode for episode, is_usual in zip(phases, usual, strict=True) if is_usual]
        self._weights = [fit(X, rows) for rows in zip(*kept, strict=True)]

    def _phases(self, states: np.ndarray, actions: np.ndarray) -> list[np.ndarray]:
        return np.split(actions, np.flatnonzero(np.diff(states[:, self._clock]) < 0) + 1)

    def _terms(self, task: np.ndarray) -> np.ndarray:
        z = np.append(1.0, (task - self._mean) / self._std)
        terms: np.ndarray = np.outer(z, z)[np.triu_indices(len(z))]
        return terms

    def start(self, observation: np.ndarray) -> None:
        """Begins an episode."""
        self._x = self._terms(observation[self._features])
        self._phase, self._last = 0, 0.0

    def __call__(self, observation: np.ndarray) -> np.ndarray:
        """Returns the action."""
        t = float(observation[self._clock])
        self._phase += t < self._last  # the next one has begun
        self._last = t
        weights = self._weights[min(self._phase, len(self._weights) - 1)]
        action: np.ndarray = self._x @ weights[min(round(t * RATE), len(weights) - 1)]
        return action.clip(-1, 1)


def fit(X: np.ndarray, rows: tuple[np.ndarray, ...]) -> np.ndarray:
    """Returns the weights of each moment [N, terms, dof]. Those that end earlier wait."""
    n = max(map(len, rows))
    Y = np.array([np.concatenate([row, np.repeat(row[-1:], n - len(row), axis=0)]) for row in rows])
    weights: np.ndarray = np.linalg.lstsq(X, Y.reshape(len(Y), -1), rcond=None)[0]
    found: np.ndarray = weights.reshape(X.shape[1], n, -1).transpose(1, 0, 2)
    return found


def holds(env: PlanEnv, seed: int, policy: Policy | None) -> bool:
    """Runs an episode with a policy, or with the planner."""
    observation, info = env.reset(seed=seed)
    if policy is not None:
        policy.start(observation)
    ended = False
    while not ended:
        action = env.expert() if policy is None else policy(observation)
        observation, _, ended, _, info = env.step(action)
    return bool(info["is_success"])


if len(sys.argv) != 3:
    sys.exit(__doc__)
env = PlanEnv("Tumble")
policy = Policy(env.names, Path(sys.argv[1]))
seeds = range(FIRST, FIRST + int(sys.argv[2]))
cloned, planned = (sum(holds(env, seed, who) for seed in seeds) for who in (policy, None))
print(f"learned from {policy.episodes} episodes; of {len(seeds)} new tasks,", end=" ")
print(f"the policy does {cloned}, the planner {planned}")
