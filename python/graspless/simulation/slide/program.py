# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Commands of the servos, step by step: a controller that does not look, and what all add.

A fixed program is the timed plan with pauses. The executor's additions are the squeeze, a straight
lift by the arm's own inverse kinematics, and a hold.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from ...timing.squeeze import beyond
from .lift import straight_lift

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ...frames import Matrix
    from ...slide import Plan
    from ...timing import Trajectory
    from ..settings import Slide

SQUEEZE, RAISE, HOLD, REST = "squeeze", "raise", "hold", "rest"


@dataclass(frozen=True)
class Command:
    """Command of the servos at one step.

    Attributes
    ----------
    position, velocity : array [dof]
        [rad or m, rad/s or m/s].
    phase : str
        Name of the part of the motion.
    """

    position: Matrix
    velocity: Matrix
    phase: str


class Senses(Protocol):
    """Measurements that a controller may ask for."""

    def positions(self) -> Matrix:
        """Returns the actual joint positions [dof]."""

    def object_pose(self) -> Matrix:
        """Returns X_WO [4, 4], which a camera sees."""


class Controller(Protocol):
    """Source of the commands that the executor gives."""

    @property
    def raised(self) -> float:
        """How high the arm can lift straight up [m]."""

    @property
    def start(self) -> Matrix:
        """Configuration [dof] in which the robot waits."""

    @property
    def X_WO_goal(self) -> Matrix:
        """Pose that the object is to have after the slide."""

    def command(self, step: int, senses: Senses) -> Command | None:
        """Returns the command of a step; None after the last."""


@dataclass(frozen=True)
class Program:
    """Commands at each step of the physics engine, whatever happens: open loop.

    Attributes
    ----------
    positions : array [N, dof]
        [rad or m].
    velocities : array [N, dof]
        [rad/s or m/s].
    phase : array [N]
        Which of `names`.
    names : list of str
        The plan's segments, then squeeze, raise and hold; or rest, if the object is left.
    raised : float
        How high the arm can lift straight up [m].
    X_WO_goal : array [4, 4]
        Pose that the object is to have after the slide.
    """

    positions: Matrix
    velocities: Matrix
    phase: NDArray[np.int64]
    names: list[str]
    raised: float
    X_WO_goal: Matrix

    @property
    def start(self) -> Matrix:
        """Configuration [dof] in which the robot waits."""
        first: Matrix = self.positions[0]
        return first

    def command(self, step: int, senses: Senses | None = None) -> Command | None:
        """Returns the command of a step; None after the last."""
        if step >= len(self.phase):
            return None
        name = self.names[self.phase[step]]
        return Command(self.positions[step], self.velocities[step], name)

    def last(self, name: str) -> int:
        """Returns the last step of a phase."""
        return int(np.flatnonzero(self.phase == self.names.index(name))[-1])


def make_program(plan: Plan, trajectory: Trajectory, timestep: float, settings: Slide) -> Program:
    """Returns the whole execution of a plan at even steps [s]."""
    parts = motions(trajectory, timestep, settings)
    if parts[-1][0] == "lift":  # the object is left where it is
        return _program(
            [*parts, rest(parts[-1][1], timestep, settings)], 0.0, plan.X_WO_goal, timestep
        )
    added, raised = additions(plan, trajectory.positions[-1], timestep, settings)
    return _program([*parts, *added], raised, plan.X_WO_goal, timestep)


def rest(after: Matrix, timestep: float, settings: Slide) -> tuple[str, Matrix]:
    """Returns rows that stay where others end, with the name of their phase."""
    still = max(1, round(settings.hold_seconds / timestep))
    return REST, np.repeat(after[-1:], still, axis=0)


def motions(trajectory: Trajectory, timestep: float, settings: Slide) -> list[tuple[str, Matrix]]:
    """Returns the segments of a plan as rows by name, with the pauses of the executor."""
    parts: list[tuple[str, Matrix]] = []
    still = max(1, round(settings.pause / timestep))
    for i, segment in enumerate(trajectory.segments):
        values = stretch(trajectory, i, timestep)
        if segment.name in ("press", "slide"):
            values = np.concatenate([values, np.repeat(values[-1:], still, axis=0)])
        parts.append((segment.name, values))
    return parts


def make_end(plan: Plan, q: Matrix, timestep: float, settings: Slide) -> Program:
    """Returns the executor's additions alone, after a motion that ended at q [dof]."""
    added, raised = additions(plan, q, timestep, settings)
    return _program(added, raised, plan.X_WO_goal, timestep)


def additions(
    plan: Plan, q: Matrix, timestep: float, settings: Slide
) -> tuple[list[tuple[str, Matrix]], float]:
    """Returns squeeze, raise and hold from q [dof] as rows by name, and the height reached [m]."""
    count = max(1, round(settings.squeeze_seconds / timestep))
    squeeze = beyond(plan, settings.squeeze)
    squeezed = q + np.minimum(1.5 * np.linspace(0, 1, count), 1)[:, None] * squeeze
    path, raised = straight_lift(plan, q, settings.lift_height)
    path = path + squeeze
    t = np.linspace(0, 1, max(2, round(settings.lift_seconds / timestep)))
    lifted = _along(path, (1 - np.cos(np.pi * t)) / 2)
    held = np.repeat(path[-1:], max(1, round(settings.hold_seconds / timestep)), axis=0)
    return [(SQUEEZE, squeezed), (RAISE, lifted), (HOLD, held)], raised


def _program(
    parts: list[tuple[str, Matrix]], raised: float, X_WO_goal: Matrix, timestep: float
) -> Program:
    positions = np.concatenate([values for _, values in parts])
    return Program(
        positions,
        np.gradient(positions, timestep, axis=0),
        np.repeat(np.arange(len(parts)), [len(values) for _, values in parts]),
        [name for name, _ in parts],
        raised,
        X_WO_goal,
    )


def stretch(trajectory: Trajectory, index: int, timestep: float) -> Matrix:
    """[N, dof] a segment's positions at even times."""
    own = np.flatnonzero(trajectory.segment_index == index)
    own = np.append(max(own[0] - 1, 0), own)  # from the end of the segment before
    times, positions = trajectory.times[own], trajectory.positions[own]
    asked = np.arange(times[0], times[-1] + timestep, timestep)
    columns = [np.interp(asked, times, column) for column in positions.T]
    return np.stack(columns, axis=1)


def _along(path: Matrix, t: Matrix) -> Matrix:
    """[N, dof] a path of even waypoints at t, from 0 to 1."""
    s = np.linspace(0, 1, len(path))
    return np.stack([np.interp(t, s, column) for column in path.T], axis=1)
