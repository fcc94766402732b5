# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The squeeze: plans end where the fingers touch, and a controller has to close beyond that."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import TaskError
from ..kinds import stages_of

if TYPE_CHECKING:
    from ..frames import Matrix
    from .trajectory import Trajectory

SECONDS = 0.5  # in which the hand closes on
_RATE = 100.0  # samples per second
_KINDS = ("slide", "pinch")  # of plans that end with a hand that touches


def beyond(plan: Any, travel: float) -> Matrix:
    """Returns how far each joint closes beyond contact [dof].

    Parameters
    ----------
    plan : Plan
        Slide or pinch, or a chain with one that ends with closing fingers.
    travel : float
        Largest of the motions of the joints, each weighted by its `Robot.step_weights` [rad; of
        sliding joints 1/10 m].

    Raises
    ------
    TaskError
        The plan is neither, and none of its stages ends so.
    """
    grasps = [plan] if plan.kind in _KINDS else _grasps(plan)
    if not grasps:
        raise TaskError(f"plan: {plan.kind}: no slide or pinch of it ends with closing fingers")
    problem = grasps[-1].task.problem
    hand, arm = problem.hand, problem.robot
    way = np.array(arm.state(hand.closed)) - np.array(arm.state(hand.open))
    way[arm.group(hand.arm)] = 0.0
    largest = np.abs(way * arm.step_weights).max()
    closing: Matrix = way / largest * travel if largest > 0 else way
    return closing


def squeezed(trajectory: Trajectory, travel: float) -> Trajectory:
    """Returns a trajectory whose hand closes beyond contact, and holds on until it opens.

    Only slides and pinches, alone or as a stage of a chain, end with a hand that touches; other
    trajectories are returned as they are. No joint passes its limit.

    Parameters
    ----------
    trajectory : Trajectory
    travel : float
        As of `beyond`; 0 changes nothing.
    """
    k, close = _contact(trajectory, travel)
    if not close.any():
        return trajectory
    t = np.linspace(0.0, 1.0, max(2, round(SECONDS * _RATE)) + 1)[1:]
    share, rate, bend = _smooth(t, SECONDS)
    left = _left(trajectory, k)[:, k + 1 :]

    def spliced(values: Matrix, added: Matrix) -> Matrix:
        return np.concatenate([values[: k + 1], added, values[k + 1 :]])

    def changed(values: Matrix, added: Matrix, after: Matrix) -> Matrix:
        found = spliced(values, added[:, None] * close)
        found[k + 1 + len(t) :] += after[:, None] * close
        return found

    def repeated(values: Any) -> Any:
        return spliced(values, np.repeat(values[k : k + 1], len(t), axis=0))

    positions = repeated(trajectory.positions)
    positions[k + 1 : k + 1 + len(t)] += share[:, None] * close
    positions[k + 1 + len(t) :] += left[0][:, None] * close
    times = spliced(trajectory.times, trajectory.times[k] + SECONDS * t)
    times[k + 1 + len(t) :] += SECONDS
    return dataclasses.replace(
        trajectory,
        times=times,
        segment_index=repeated(trajectory.segment_index),
        rows=repeated(trajectory.rows),
        positions=positions,
        velocities=changed(trajectory.velocities, rate, left[1]),
        accelerations=changed(trajectory.accelerations, bend, left[2]),
        object_poses=repeated(trajectory.object_poses),
    )


def targets(trajectory: Trajectory, travel: float) -> Matrix:
    """Returns targets of servos [N, dof]: positions, with the squeeze until the hand opens.

    Parameters
    ----------
    trajectory : Trajectory
    travel : float
        As of `squeezed`.
    """
    k, close = _contact(trajectory, travel)
    found: Matrix = trajectory.positions.copy()
    found[k:] += _left(trajectory, k)[0][k:, None] * close
    return found


def _grasps(plan: Any) -> list[Any]:
    """Returns the slides and pinches of a plan that end with closing fingers."""
    touching = [stage for stage in stages_of(plan) if stage.kind in _KINDS]
    return [s for s in touching if s.segments and s.segments[-1].name == "close"]


def _contact(trajectory: Trajectory, travel: float) -> tuple[int, Matrix]:
    """Returns the sample at which the hand touches, and how far it closes on [dof]; or zeros.

    A part of a trajectory may lack the segment in which the hand closes.
    """
    grasps = _grasps(trajectory.plan)
    close = max((i for i, s in enumerate(trajectory.segments) if s.name == "close"), default=0)
    if travel <= 0 or not grasps or trajectory.segment_index[-1] < close:
        return 0, np.zeros(trajectory.positions.shape[1])
    plan = grasps[-1]
    k = max(0, int(np.count_nonzero(trajectory.segment_index <= close)) - 1)
    q, robot = trajectory.positions[k], plan.task.problem.robot
    return k, np.clip(q + beyond(plan, travel), robot.lower, robot.upper) - q


def _smooth(t: Matrix, seconds: float) -> tuple[Matrix, Matrix, Matrix]:
    """Returns a smooth step from 0 to 1 at t in [0, 1], and its derivatives by time."""
    return t**2 * (3 - 2 * t), 6 * t * (1 - t) / seconds, (6 - 12 * t) / seconds**2


def _left(trajectory: Trajectory, k: int) -> Matrix:
    """Returns the share of the squeeze at each sample and its first two derivatives by time [3, N].

    It is 1 until the hand opens after sample k, and falls to 0 while it does.
    """
    left = np.stack([np.ones(len(trajectory.times)), *2 * [np.zeros(len(trajectory.times))]])
    opens = np.flatnonzero(np.array(trajectory.names) == "open")
    opens = opens[opens > k]
    if len(opens):
        first, last = opens[0] - 1, opens[-1]
        seconds = float(trajectory.times[last] - trajectory.times[first])
        t = (trajectory.times[first : last + 1] - trajectory.times[first]) / seconds
        share, rate, bend = _smooth(t, seconds)
        left[:, first : last + 1] = 1 - share, -rate, -bend
        left[:, last + 1 :] = 0
    return left
