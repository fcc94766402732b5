# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timed trajectories of plans."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from .. import frames
from .._arguments import require_type
from ..errors import TaskError, shown
from ..kinds import stages_of
from .quintic import between
from .rates import Rate
from .settings import LONGEST, require_positive

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from numpy.typing import ArrayLike, NDArray

    from .._core.robot import Robot
    from .._plan import Plan
    from ..frames import Matrix
    from .clip import Clip


def robot_of(plan: Any) -> Robot | None:
    """Returns the robot of a plan, or of the first stage of a chain."""
    task = stages_of(plan)[0].task
    robot: Robot | None = task.arm.robot if task.arm else getattr(task.problem, "robot", None)
    return robot


@dataclass(frozen=True, eq=False)
class Trajectory:
    """A timed plan: positions of joints and object at N samples.

    It may be copied and pickled if its plan may. It equals only itself.

    Attributes
    ----------
    plan : Plan
        Plan that was timed.
    segments : list
        Segments of the plan; for a fingertip plan with an arm, its joint_segments. Each has a name.
    times : array [N]
        Times from 0, increasing [s].
    segment_index : array [N]
        Index into `segments` at each moment.
    rows : array [N]
        Fractional row of that segment: 2.25 is a quarter of the way from row 2 to row 3.
    joint_names : list of str
        Names of the columns of positions; empty for fingertips without an arm.
    positions, velocities, accelerations : array [N, dof]
        Joint motion [rad, rad/s, rad/s^2], or [m, m/s, m/s^2] for sliding joints.
    object_poses : array [N, 4, 4]
        Poses X_WO of the object.
    """

    plan: Plan
    segments: list[Any]
    times: Matrix
    segment_index: NDArray[np.int64]
    rows: Matrix
    joint_names: list[str]
    positions: Matrix
    velocities: Matrix
    accelerations: Matrix
    object_poses: Matrix

    def __repr__(self) -> str:
        what = ", ".join(dict.fromkeys(self.names))
        return f"<Trajectory of {len(self)} samples, {self.duration:.2f} s: {what}>"

    def __reduce__(self) -> Any:
        # Segments of the core cannot be pickled: they are those of the plan.
        own = {field.name: getattr(self, field.name) for field in fields(self)}
        del own["segments"]
        return _restored, (own,)

    def __len__(self) -> int:
        return len(self.times)

    @property
    def duration(self) -> float:
        """Duration [s]."""
        return float(self.times[-1])

    @property
    def is_of_group(self) -> bool:
        """True if it has the joints of a group alone, not those of the whole robot."""
        robot = robot_of(self.plan)
        return robot is not None and 0 < len(self.joint_names) < robot.dof

    @property
    def start(self) -> dict[str, float]:
        """Start configuration by joint [rad or m]."""
        return dict(zip(self.joint_names, self.positions[0].tolist(), strict=True))

    def of_group(self, group: str) -> Trajectory:
        """Returns the motion of the joints of one group of the SRDF, such as arm or hand.

        Raises
        ------
        TaskError
            No joints move, or the robot has no such group; names those that it has.
        """
        require_type("group", group, str)
        robot = robot_of(self.plan)
        if not self.joint_names or robot is None:
            raise TaskError(f"group: {shown(group)}: the plan moves no joints")
        try:
            names = [robot.joint_names[j] for j in robot.group(group)]
        except ValueError as error:
            raise TaskError(f"group: {error}") from None
        if not set(names) <= set(self.joint_names):
            raise TaskError(f"group: {shown(group)}: the trajectory is of another group")
        columns = [self.joint_names.index(name) for name in names]
        return replace(
            self,
            joint_names=[self.joint_names[i] for i in columns],
            positions=np.ascontiguousarray(self.positions[:, columns]),
            velocities=np.ascontiguousarray(self.velocities[:, columns]),
            accelerations=np.ascontiguousarray(self.accelerations[:, columns]),
        )

    @property
    def names(self) -> list[str]:
        """Name of the segment at each moment."""
        return [str(self.segments[i].name) for i in self.segment_index]

    def at(self, times: ArrayLike) -> Trajectory:
        """Returns the trajectory at other `times` [s]; its ends are held.

        Between two samples the joints move along the polynomial of degree 5 that has the positions,
        velocities and accelerations of both. Rows and poses of the object are interpolated
        linearly. With the default `rate` of `time`, accelerations between the samples exceed the
        limits by up to 1 %, and jerks by up to 15 %; with 20 samples a second, by 6 % and 20 %.

        Raises TaskError unless there is at least one time, and all are finite.
        """
        try:
            asked = np.atleast_1d(np.asarray(times, dtype=float))
        except (TypeError, ValueError, OverflowError):
            asked = np.empty(0)
        if asked.ndim > 1 or not asked.size or not np.isfinite(asked).all():
            raise TaskError(f"times: {shown(times)}: should be one or more finite numbers")
        last = len(self.times) - 1
        after = np.searchsorted(self.times, asked).clip(min(1, last), last)
        before = np.maximum(after - 1, 0)
        gap = self.times[after] - self.times[before]
        gap = np.where(gap > 0, gap, 1.0)
        t = np.clip((asked - self.times[before]) / gap, 0.0, 1.0)
        # Between two segments there is no row, so the later one counts as begun.
        same = self.segment_index[before] == self.segment_index[after]
        rows = np.where(same, _mix(self.rows, before, after, t), self.rows[after])
        segment_index = np.where(t > 0, self.segment_index[after], self.segment_index[before])
        rows = np.where(t > 0, rows, self.rows[before])
        joints = between(self._joints(before), self._joints(after), t, gap)
        return replace(
            self,
            times=asked,
            segment_index=segment_index,
            rows=rows,
            positions=joints[0],
            velocities=joints[1],
            accelerations=joints[2],
            object_poses=frames.mixed(self._places, before, after, t),
        )

    def _joints(self, at: NDArray[np.int64]) -> tuple[Matrix, Matrix, Matrix]:
        return self.positions[at], self.velocities[at], self.accelerations[at]

    @cached_property
    def _places(self) -> tuple[Matrix, Matrix]:
        return frames.places(self.object_poses)

    def followed(self, names: Sequence[str], times: ArrayLike) -> Matrix:
        """Returns the planned poses X_WO for an execution, which may have additional pauses.

        Parameters
        ----------
        names : list of str
            Name of what is executed at each moment: a segment, or something else.
        times : array [N]
            Times of the execution, increasing [s].

        Returns
        -------
        array [N, 4, 4]
            While a segment is executed: the pose of that segment at the elapsed time. Under any
            other name: the last pose of the segment before. Where several segments have one name,
            they are told apart by their order.
        """
        now, of = np.asarray(times, dtype=float), np.array(names)
        found = np.repeat(self.object_poses[:1], len(now), axis=0)
        planned = [str(segment.name) for segment in self.segments]
        executed = np.flatnonzero(np.isin(of, planned))
        turns = np.split(executed, np.flatnonzero(of[executed[1:]] != of[executed[:-1]]) + 1)
        for k, name in enumerate(planned):
            rows, own = np.flatnonzero(of == name), np.flatnonzero(self.segment_index == k)
            if planned.count(name) > 1:  # the first segment of this name has its first turn
                mine = [turn for turn in turns if (of[turn] == name).any()]
                turn = planned[:k].count(name)
                rows = mine[turn] if turn < len(mine) else rows[:0]
            if len(rows) and len(own):
                start, end = self.times[own[[0, -1]]]
                elapsed = np.minimum(now[rows] - now[rows[0]], end - start)
                found[rows] = self.at(start + elapsed).object_poses
                found[rows[-1] + 1 :] = self.object_poses[own[-1]]
        return found

    def sampled(self, rate: float) -> Trajectory:
        """Returns at most 1e6 samples of the trajectory, `rate` per second and one at its end.

        Between the samples of the timing the joints move as `at` says.
        """
        return self.at(Rate(require_positive("rate", rate)).times(self.duration))


def _restored(own: dict[str, Any]) -> Trajectory:
    """Returns the trajectory of its fields but `segments`."""
    segments: list[Any] = []
    for stage in stages_of(own["plan"]):
        is_carried = stage.kind == "fingertip" and own["joint_names"]
        segments += stage.joint_segments if is_carried else stage.segments
    return Trajectory(segments=segments, **own)


def _mix(values: Matrix, before: NDArray[np.int64], after: NDArray[np.int64], t: Matrix) -> Matrix:
    mixed: Matrix = (1 - t) * values[before] + t * values[after]
    return mixed


def require_sayable(trajectory: Trajectory, pause: float) -> Trajectory:
    """Returns the trajectory; raises TaskError if it takes longer than LONGEST."""
    if trajectory.duration <= LONGEST:
        return trajectory
    takes = f"{trajectory.duration:.3g} s in all, more than {LONGEST}"
    if pause * (len(trajectory.segments) - 1) > LONGEST / 2:
        raise TaskError(f"pause: {pause:g}: makes {takes}: should be less")
    raise TaskError(f"max_velocity, max_acceleration or contact_speed: {takes}: should be more")


def assembled(
    plan: Plan,
    segments: list[Any],
    joint_names: list[str],
    clips: list[Clip],
    object_poses: list[Matrix],
    pauses: Sequence[float],
) -> Trajectory:
    """Joins one clip per segment to a trajectory, with `pauses` [s] after them."""
    lengths = [clip.times[-1] + pause for clip, pause in zip(clips, pauses, strict=True)]
    starts = np.cumsum([0.0, *lengths[:-1]])
    dof = len(joint_names)
    return Trajectory(
        plan,
        segments,
        np.concatenate([clip.times + t for clip, t in zip(clips, starts, strict=True)]),
        np.repeat(np.arange(len(clips)), [len(clip.times) for clip in clips]),
        np.concatenate([clip.rows for clip in clips]),
        joint_names,
        np.concatenate([clip.coordinates[:, :dof] for clip in clips]),
        np.concatenate([clip.velocities[:, :dof] for clip in clips]),
        np.concatenate([clip.accelerations[:, :dof] for clip in clips]),
        np.concatenate(object_poses),
    )


def concatenated(plan: Plan, parts: list[Trajectory], pause: float) -> Trajectory:
    """Joins trajectories of the same joints, with `pause` [s] between them."""
    starts = np.cumsum([0.0, *(part.duration + pause for part in parts[:-1])])
    counts = np.cumsum([0, *(len(part.segments) for part in parts[:-1])])
    return Trajectory(
        plan,
        [segment for part in parts for segment in part.segments],
        np.concatenate([part.times + t for part, t in zip(parts, starts, strict=True)]),
        np.concatenate([part.segment_index + n for part, n in zip(parts, counts, strict=True)]),
        np.concatenate([part.rows for part in parts]),
        parts[0].joint_names,
        np.concatenate([part.positions for part in parts]),
        np.concatenate([part.velocities for part in parts]),
        np.concatenate([part.accelerations for part in parts]),
        np.concatenate([part.object_poses for part in parts]),
    )
