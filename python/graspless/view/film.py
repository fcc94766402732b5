# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot's motion over time: the pose of every body at each moment."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from . import bodies
from .clock import LONGEST, clock_of, pace_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from .._plan import Plan
    from ..frames import Matrix
    from ..simulation.results import Recording

SPEED = 0.9  # default speed for watching, not for driving a robot [rad/s]
PAUSE = 0.4  # pause between segments [s]


@dataclass
class Film:
    """Rows of a plan with a time for each.

    Attributes
    ----------
    times : array [N]
        Times, from 0 [s].
    positions : array [N, dof]
    object_poses : array [N, 4, 4]
        X_WO.
    names : list of str
        Segment of each row.
    planned_poses : array [N, 4, 4], optional
        Planned poses of the object, for the film of a recording.
    pace : float, optional
        Speed of the film over that of the robot; None if the motion has no times.
    compared : set of str
        Segments in which the object should follow `planned_poses`.
    """

    plan: Any
    times: Matrix
    positions: Matrix
    object_poses: Matrix
    names: list[str]
    planned_poses: Matrix | None = None
    pace: float | None = None
    compared: frozenset[str] = frozenset()

    @cached_property
    def link_poses(self) -> Matrix:
        """Poses of every frame of the robot in the world, [N, F, 4, 4]."""
        robot = self.plan.task.problem.robot
        return np.array([np.asarray(robot.forward(q)) for q in self.positions])

    @cached_property
    def robot(self) -> list[bodies.Body]:
        """Bodies of the robot, one for each frame."""
        return bodies.robot(self.plan.task)

    def frame(self, name: str) -> Matrix:
        """Returns the poses of one frame of the robot in the world, [N, 4, 4]."""
        index = list(self.plan.task.problem.robot.frame_names).index(name)
        poses: Matrix = self.link_poses[:, index]
        return poses

    def rows(self, name: str) -> NDArray[np.int64]:
        """Returns the rows of a segment."""
        return np.flatnonzero(np.array(self.names) == name)

    def resampled(self, rate: float) -> Film:
        """Returns the same film at equal time steps, with `rate` rows per second."""
        count = max(2, int(np.ceil(self.times[-1] * rate)) + 1)
        times = np.linspace(0.0, self.times[-1], count)
        after = np.clip(np.searchsorted(self.times, times), 1, max(1, len(self.times) - 1))
        if len(self.times) == 1:
            after = np.zeros(count, dtype=int)
        before = np.maximum(after - 1, 0)
        gap = self.times[after] - self.times[before]
        blend = np.clip((times - self.times[before]) / np.where(gap > 0, gap, 1), 0, 1)
        positions = self.positions[before] + blend[:, None] * (
            self.positions[after] - self.positions[before]
        )

        def mixed(poses: Matrix) -> Matrix:
            return frames.mixed(frames.places(poses), before, after, blend)

        return replace(
            self,
            times=times,
            positions=positions,
            object_poses=mixed(self.object_poses),
            names=[self.names[i] for i in after],
            planned_poses=None if self.planned_poses is None else mixed(self.planned_poses),
        )


def film(
    plan: Plan,
    recording: Recording | None,
    q: ArrayLike,
    X_WO: ArrayLike,
    speeds: dict[str, float],
) -> Film:
    """Returns a recording, or the plan's rows at a speed for watching (see `timed`).

    Parameters
    ----------
    plan : Plan
        Its segments must have positions and object_poses.
    recording : Recording or None
        Recording of a simulation of the plan.
    q, X_WO : array [dof], array [4, 4]
        Configuration and object pose shown for a plan without motion.
    speeds : dict
        Speeds of segments by name [rad/s].
    """
    if recording is not None:
        return recorded(plan, recording)
    segments = [segment for segment in plan.segments if len(segment)]
    if not segments:
        joints, pose = np.asarray(q, dtype=float), np.asarray(X_WO, dtype=float)
        return Film(plan, np.zeros(1), joints[None], pose[None], [str(plan.status)])
    times: list[float] = []
    now = 0.0
    for segment in segments:
        step = np.abs(np.diff(segment.positions, axis=0)).max(axis=1, initial=0.0)
        steps = step / speeds.get(segment.name, SPEED)
        times += (now + np.concatenate([[0.0], np.cumsum(steps)])).tolist()
        now = times[-1] + PAUSE
    scale = min(1.0, LONGEST / max(times[-1], 1e-9))
    names = [segment.name for segment in segments for _ in range(len(segment))]
    return Film(
        plan,
        np.array(times) * scale,
        np.concatenate([segment.positions for segment in segments]),
        np.concatenate([segment.object_poses for segment in segments]),
        names,
    )


def timed(shown: Film) -> Film:
    """Returns a plan's film at its robot's speed, if known; a recording keeps its own speed."""
    if shown.pace is not None:
        return shown
    clock = clock_of(shown.plan)
    if clock is None:
        return shown
    parts = [(k, s) for k, s in enumerate(shown.plan.segments) if len(s)]
    times = np.concatenate([clock.times(k, np.arange(len(s))) for k, s in parts])
    return replace(shown, times=times, pace=clock.pace)


def recorded(plan: Plan, recording: Recording) -> Film:
    """Returns the film of a simulation, at its own speed unless that is too slow to watch."""
    times = np.asarray(recording.times, dtype=float)
    pace = pace_of(float(times[-1]))
    given = recording.planned_poses is not None
    return Film(
        plan,
        times / pace,
        np.asarray(recording.positions, dtype=float),
        np.asarray(recording.object_poses, dtype=float),
        list(recording.names),
        planned_poses(plan, recording),
        pace,
        frozenset(recording.names if given else [segment.name for segment in plan.segments]),
    )


def planned_poses(plan: Plan, recording: Recording) -> Matrix:
    """Returns the planned pose of the object at each moment, [N, 4, 4].

    If the recording has none: from `Trajectory.followed`, or the end of each segment if the plan
    cannot be timed.
    """
    if recording.planned_poses is not None:
        return np.asarray(recording.planned_poses, dtype=float)
    clock = clock_of(plan)
    if clock is not None:
        return clock.trajectory.followed(recording.names, recording.times)
    names, moving = np.array(recording.names), [s for s in plan.segments if len(s)]
    found = np.repeat(moving[0].object_poses[:1], len(names), axis=0)
    for segment in moving:
        for row in np.flatnonzero(names == segment.name)[:1]:
            found[row:] = segment.object_poses[-1]
    return found


def spread(shown: Film, most: int = 60) -> list[int]:
    """Returns at most `most` rows, evenly spaced from the first to the last."""
    last = len(shown.times) - 1
    return sorted({round(row) for row in np.linspace(0, last, min(most, last + 1))})
