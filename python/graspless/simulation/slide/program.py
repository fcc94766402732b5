# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Commands of the servos, step by step: the timed plan with the additions of the executor.

It adds pauses, the squeeze, a straight lift by the arm's own inverse kinematics, and a hold.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ... import frames, robot

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ...frames import Matrix
    from ...slide import Plan
    from ...timing import Trajectory
    from ..settings import Slide

SQUEEZE, RAISE, HOLD = "squeeze", "raise", "hold"
_WAYPOINTS = 21  # of the straight lift
_JUMP = 0.3  # a joint that moves by more between them has left its branch [rad or m]
_TURNS = (0.0, 0.05, -0.05, 0.1, -0.1)  # of the hand between them, tried in turn [rad]


@dataclass(frozen=True)
class Program:
    """Commands at each step of the physics engine.

    Attributes
    ----------
    positions : array [N, dof]
        [rad or m].
    velocities : array [N, dof]
        [rad/s or m/s].
    phase : array [N]
        Which of `names`.
    names : list of str
        The plan's segments, then squeeze, raise and hold.
    raised : float
        How high the arm can lift straight up [m].
    """

    positions: Matrix
    velocities: Matrix
    phase: NDArray[np.int64]
    names: list[str]
    raised: float

    def last(self, name: str) -> int:
        """Returns the last step of a phase."""
        return int(np.flatnonzero(self.phase == self.names.index(name))[-1])


def make_program(plan: Plan, trajectory: Trajectory, timestep: float, settings: Slide) -> Program:
    """Returns the whole execution of a plan at even steps [s]."""
    names = [segment.name for segment in trajectory.segments]
    rows, phases = [], []

    def append(values: Matrix, name: str) -> None:
        if name not in names:
            names.append(name)
        rows.append(values)
        phases.append(np.full(len(values), names.index(name)))

    still = max(1, round(settings.pause / timestep))
    for i, name in enumerate(list(names)):
        values = stretch(trajectory, i, timestep)
        append(values, name)
        if name in ("press", "slide"):
            append(np.repeat(values[-1:], still, axis=0), name)
    q = trajectory.positions[-1]
    count = max(1, round(settings.squeeze_seconds / timestep))
    squeeze = _squeeze(plan, settings.squeeze)
    squeezed = q + np.minimum(1.5 * np.linspace(0, 1, count), 1)[:, None] * squeeze
    append(squeezed, SQUEEZE)
    path, raised = straight_lift(plan, q, settings.lift_height)
    path = path + squeeze
    t = np.linspace(0, 1, max(2, round(settings.lift_seconds / timestep)))
    append(_along(path, (1 - np.cos(np.pi * t)) / 2), RAISE)
    append(np.repeat(path[-1:], max(1, round(settings.hold_seconds / timestep)), axis=0), HOLD)
    positions = np.concatenate(rows)
    velocities = np.gradient(positions, timestep, axis=0)
    return Program(positions, velocities, np.concatenate(phases), names, raised)


def stretch(trajectory: Trajectory, index: int, timestep: float) -> Matrix:
    """[N, dof] a segment's positions at even times."""
    own = trajectory.segment_index == index
    times, positions = trajectory.times[own], trajectory.positions[own]
    asked = np.arange(times[0], times[-1] + timestep, timestep)
    columns = [np.interp(asked, times, column) for column in positions.T]
    return np.stack(columns, axis=1)


def _along(path: Matrix, t: Matrix) -> Matrix:
    """[N, dof] a path of even waypoints at t, from 0 to 1."""
    s = np.linspace(0, 1, len(path))
    return np.stack([np.interp(t, s, column) for column in path.T], axis=1)


def _squeeze(plan: Plan, travel: float) -> Matrix:
    """Returns how far each joint closes beyond contact [dof].

    The largest Robot.step() is `travel`.
    """
    problem = plan.task.problem
    hand, arm = problem.hand, problem.robot
    way = np.array(arm.state(hand.closed)) - np.array(arm.state(hand.open))
    way[arm.group(hand.arm)] = 0.0
    largest = np.abs(way * arm.step_weights).max()
    beyond: Matrix = way / largest * travel if largest > 0 else way
    return beyond


def straight_lift(plan: Plan, q: Matrix, height: float) -> tuple[Matrix, float]:
    """Returns the path [N, dof] that lifts the hand straight up from q, and the height reached [m].

    The hand turns about the vertical only if it cannot rise otherwise.
    """
    problem = plan.task.problem
    hand = problem.hand
    ik = robot.Ik(problem.robot, hand.grasp_frame, hand.arm)
    X_WH = np.array(problem.robot.pose(hand.grasp_frame, q))
    steps = np.linspace(0, height, _WAYPOINTS)
    path, yaw = [q], 0.0
    for up in steps[1:]:
        for turn in _TURNS:
            found = ik.solve_near(_raised(X_WH, up, yaw + turn), path[-1])
            if found is not None and np.abs(found - path[-1]).max() < _JUMP:
                path.append(np.array(found))
                yaw += turn
                break
        else:
            break
    raised = float(steps[len(path) - 1])
    return np.array(path if len(path) > 1 else [q, q]), raised


def _raised(X_WH: Matrix, up: float, yaw: float) -> Matrix:
    """Returns a pose of the hand, lifted [m] and turned about its vertical axis [rad]."""
    X_WR = frames.planar(0.0, 0.0, yaw) @ X_WH
    X_WR[:3, 3] = X_WH[:3, 3] + [0.0, 0.0, up]
    return X_WR
