# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A fingertip plan over time, at a speed for watching: quasi-static plans have no times."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from ... import frames
from ..clock import LONGEST, Clock, clock_of, pace_of
from ..film import planned_poses
from .moments import Moment, at, start_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ...fingertip import JointSegment, Plan, Segment
    from ...frames import Matrix
    from ...simulation.results import Recording

SLIDE = 8.0  # [cm/s]
TURN = 25.0  # [degrees/s]
LEAVE, TRAVEL = 0.4, 0.8  # of a regrasp: leaving or reaching the surface, moving over it [s]
JOINTS = 0.6  # speed of a robot that moves the fingers [rad/s]


@dataclass(frozen=True)
class Key:
    """A moment and its time [s]."""

    time: float
    moment: Moment


def film(plan: Plan, rate: float, clock: Clock | None = None) -> list[Moment]:
    """Returns `rate` moments per second, by a clock or else at a speed for watching."""
    keys = list(_joint_keys(plan, clock) if plan.joint_segments else _keys(plan, clock))
    if not keys:
        return [start_of(plan)]
    scale = min(1.0, LONGEST / max(keys[-1].time, 1e-9))
    return _sampled(keys, scale * rate)


def timed(plan: Plan, rate: float) -> tuple[list[Moment], float | None]:
    """Returns the film at its robot's speed, if known, and its speed-up."""
    clock = clock_of(plan)
    return film(plan, rate, clock), None if clock is None else clock.pace


def recorded(plan: Plan, recording: Recording, rate: float) -> tuple[list[Moment], float]:
    """Returns the film of a simulation and its speed-up.

    If the recording has no fingertips, the arm's configuration gives them.
    """
    times = np.asarray(recording.times, dtype=float)
    pace = pace_of(float(times[-1]))
    planned = planned_poses(plan, recording)
    keys = []
    for row, time in enumerate(times):
        X_WO = np.asarray(recording.object_poses[row])
        q = recording.positions[row] if recording.positions.shape[1] else None
        tips_W = recording.fingers[row] if q is None else _tips(plan, q)
        centers = (tips_W - X_WO[:3, 3]) @ X_WO[:3, :3]
        count = len(centers)
        name, modes = recording.names[row], ["free"] * count
        forces = np.zeros((count, 3))
        keys.append(Key(time, Moment(X_WO, centers, forces, modes, name, q=q, X_WP=planned[row])))
    return _sampled(keys, rate / pace), pace


def _sampled(keys: list[Key], rate: float) -> list[Moment]:
    """Returns moments at equal time steps, `rate` per second."""
    last = keys[-1].time
    times = np.array([key.time for key in keys])
    wanted = np.linspace(0, last, max(2, int(np.ceil(last * rate)) + 1))
    after = np.clip(np.searchsorted(times, wanted), min(1, len(keys) - 1), len(keys) - 1)
    return [_between(keys[max(j - 1, 0)], keys[j], t) for j, t in zip(after, wanted, strict=True)]


def _tips(plan: Plan, q: Matrix) -> Matrix:
    """Returns the centres of the fingertips, [n, 3] in the world, in the order of the fingers."""
    arm, found = plan.task.arm, plan.realization
    assert found is not None
    links = np.asarray(arm.robot.forward(q))
    names = list(arm.robot.frame_names)
    tips_W = np.array([links[names.index(name)][:3, 3] for name in arm.carrier.fingertips])
    return np.asarray(tips_W[np.argsort(found.finger_of_fingertip)])


def _keys(plan: Plan, clock: Clock | None) -> Iterator[Key]:
    """Yields the keys of a plan without a robot."""
    now = 0.0
    for k, segment in enumerate(plan.segments):
        if not len(segment):
            continue
        found = list(_regrasp(plan, k) if segment.name == "regrasp" else _held(plan, segment))
        steps = np.array([step for step, _, _ in found])
        times = now + np.cumsum(steps)
        if clock is not None:
            times = clock.times(k, [row for _, row, _ in found])
        for time, (_, _, moment) in zip(times, found, strict=True):
            yield Key(float(time), moment)
        now = float(times[-1]) if len(times) else now


def _held(plan: Plan, segment: Segment) -> Iterator[tuple[float, float, Moment]]:
    """Yields time steps, rows and moments of a motion of the object."""
    last = len(segment) - 1
    before = at(plan, segment, 0, segment.X_WO[0])
    yield 0.0, -0.5, before
    for row in range(len(segment)):
        moment = at(plan, segment, row)
        yield _seconds(before.X_WO, moment.X_WO), float(row), moment
        before = moment
    end = at(plan, segment, last, segment.X_WO[-1])
    yield _seconds(before.X_WO, end.X_WO), last + 0.5, end


def _regrasp(plan: Plan, k: int) -> Iterator[tuple[float, float, Moment]]:
    """Yields time steps, rows from 0 to 1 and moments of a regrasp."""
    segment = plan.segments[k]
    resting = at(plan, segment, 0)
    before = _neighbour(plan, k, -1)
    after = _neighbour(plan, k, 1)
    finger, radius = segment.finger, plan.task.problem.fingers.radius
    if before is None or after is None or finger < 0:
        return
    start, goal = (
        other.fingers[row, finger] - radius * other.normals[row, finger]
        for other, row in ((before, -1), (after, 0))
    )
    off = 2.0 * radius
    leave = start - off * before.normals[-1, finger]
    arrive = goal - off * after.normals[0, finger]
    way = [start, leave, *_round(leave, arrive, np.asarray(plan.task.problem.object.com))]
    steps = [0.0, LEAVE, *[TRAVEL / (len(way) - 2)] * (len(way) - 2), LEAVE]
    rows = [0.0, *np.linspace(1 / 3, 2 / 3, len(way) - 1).tolist(), 1.0]
    kept = at(plan, before, len(before) - 1).centers  # of fingers that wait for their own regrasp
    for step, row, center in zip(steps, rows, [*way, goal], strict=True):
        centers = np.where(np.isfinite(resting.centers), resting.centers, kept)
        centers[finger] = center
        yield step, row, replace(resting, centers=centers)


def _round(start: Matrix, goal: Matrix, middle: Matrix) -> list[Matrix]:
    """Returns points from start to goal that keep their distance from the middle."""
    found = []
    for t in np.linspace(0, 1, 9)[1:]:
        straight = (1 - t) * start + t * goal - middle
        reach = (1 - t) * np.linalg.norm(start - middle) + t * np.linalg.norm(goal - middle)
        found.append(middle + straight * reach / max(float(np.linalg.norm(straight)), 1e-9))
    return found


def _neighbour(plan: Plan, k: int, step: int) -> Segment | None:
    """Returns the next segment with a motion of the object, forwards or backwards."""
    k += step
    while 0 <= k < len(plan.segments):
        if plan.segments[k].name != "regrasp" and len(plan.segments[k]):
            return plan.segments[k]
        k += step
    return None


def _joint_keys(plan: Plan, clock: Clock | None) -> Iterator[Key]:
    """Yields the keys of a plan with a robot, which gives the fingertips."""
    now = 0.0
    for k, segment in enumerate(plan.joint_segments):
        step = np.abs(np.diff(segment.positions, axis=0)).max(axis=1, initial=0.0) / JOINTS
        times = now + np.concatenate([[0.0], np.cumsum(np.maximum(step, 1e-3))])
        if clock is not None:
            times = clock.times(k, np.arange(len(segment)))
        for row, time in enumerate(times):
            yield Key(float(time), _carried(plan, segment, row))
        now = float(times[-1]) + 0.2


def _carried(plan: Plan, segment: JointSegment, row: int) -> Moment:
    """Returns the moment of a row of joint motion; forward kinematics give the fingertips."""
    X_WO, q = segment.object_poses[row], segment.positions[row]
    centers = (_tips(plan, q) - X_WO[:3, 3]) @ X_WO[:3, :3]
    count = len(centers)
    carried = Moment(X_WO, centers, np.zeros((count, 3)), ["free"] * count, segment.name, q=q)
    if segment.plan_segment < 0:
        return carried
    planned = plan.segments[segment.plan_segment]
    if planned.name == "regrasp":
        nearest = 0
    else:
        nearest = round(row / max(len(segment) - 1, 1) * (len(planned) - 1))
    there = at(plan, planned, nearest)
    return replace(carried, forces=there.forces, modes=there.modes)


def _between(before: Key, after: Key, time: float) -> Moment:
    gap = after.time - before.time
    t = float(np.clip((time - before.time) / gap, 0, 1)) if gap > 0 else 1.0
    a, b = before.moment, after.moment
    X_WO = frames.between(a.X_WO, b.X_WO, t)
    q = None if a.q is None or b.q is None else (1 - t) * a.q + t * b.q
    centers = (1 - t) * a.centers + t * b.centers
    X_WP = None if a.X_WP is None or b.X_WP is None else frames.between(a.X_WP, b.X_WP, t)
    # A finger touches or not; forces change with the rows.
    return replace(b, X_WO=X_WO, centers=centers, q=q, X_WP=X_WP)


def _seconds(X_A: Matrix, X_B: Matrix) -> float:
    degrees = float(np.degrees(frames.angle(X_A, X_B)))
    if degrees > 1e-3:
        return degrees / TURN
    return float(100 * np.linalg.norm(X_B[:3, 3] - X_A[:3, 3])) / SLIDE
