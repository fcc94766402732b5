# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Script of a whole plan: touch, load, move, regrasp, rest."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from .script import Script, blended, joined, moving, still

if TYPE_CHECKING:
    from ...fingertip import Plan
    from ...frames import Matrix
    from ...timing import Trajectory
    from ..settings import Fingertip


def program(plan: Plan, trajectory: Trajectory, settings: Fingertip) -> Script:
    """Returns the program of the fingertips of a plan. Between two motions the object rests,
    while the forces change from those of one to those of the next.
    """
    moves = [_moving(plan, trajectory, s) for s in range(len(plan.segments))]
    parts = [touch(moves[0], settings)]
    for s, segment in enumerate(plan.segments):
        if segment.name == "regrasp":
            moves[s] = _regrasp(plan, moves, s)
        parts += [blended(parts[-1], moves[s], settings.load_seconds), moves[s]]
    return joined([*parts, still(moves[-1], -1, settings.rest_seconds, "rest")])


def touch(first: Script, settings: Fingertip) -> Script:
    """Returns the approach of the fingers along their normals to the start of `first`."""
    start = still(first, 0, settings.load_seconds, "touch")
    centers = start.centers.copy()
    centers[0] -= settings.approach * start.normals[0]
    holds, forces = np.ones_like(start.holds), np.zeros_like(start.forces)
    drift = np.ones_like(start.drift)
    return replace(start, centers=centers, holds=holds, forces=forces, drift=drift)


def _moving(plan: Plan, trajectory: Trajectory, s: int) -> Script:
    here = np.flatnonzero(trajectory.segment_index == s)
    times = trajectory.times[here]
    return moving(
        plan.segments[s],
        times - times[0],
        trajectory.rows[here],
        trajectory.object_poses[here],
        plan.task.problem.fingers.radius,
    )


def _regrasp(plan: Plan, moves: list[Script], s: int) -> Script:
    """Returns a regrasp: the finger leaves along its normal, rounds the object and approaches."""
    stay, finger = moves[s], plan.segments[s].finger
    thing = plan.task.problem.object
    X_WO = plan.segments[s].object_poses[0]
    middle = X_WO[:3, :3] @ thing.com + X_WO[:3, 3]
    reach = np.linalg.norm(np.asarray(thing.hull) - thing.com, axis=1).max()
    far = float(reach + 2 * plan.task.problem.fingers.radius)
    before, after = moves[s - 1], moves[s + 1]
    way = way_round(
        before.centers[-1, finger], before.normals[-1, finger],
        after.centers[0, finger], after.normals[0, finger], middle, far,
    )  # fmt: skip
    # At constant speed over the time of the trajectory.
    along = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(way, axis=0), axis=1))])
    times = along / along[-1] * max(stay.duration, 1e-3)
    held = still(stay, 0, stay.duration, "regrasp").at(times)
    centers, normals, holds = held.centers.copy(), held.normals.copy(), held.holds.copy()
    centers[:, finger], holds[:, finger] = way, 1.0
    half = (times > times[-1] / 2)[:, None]
    normals[:, finger] = np.where(half, after.normals[0, finger], before.normals[-1, finger])
    return replace(held, centers=centers, normals=normals, holds=holds)


def way_round(p: Matrix, n: Matrix, q: Matrix, m: Matrix, middle: Matrix, far: float) -> Matrix:
    """Returns a path [T, 3] from p against normal n, round a ball, and along normal m to q.

    Parameters
    ----------
    p, q : array [3]
        Centres of the fingertip before and after [m].
    n, m : array [3]
        Normals into the object there.
    middle : array [3]
        Of the ball [m].
    far : float
        Its radius [m].
    """
    out, back = _leave(p, n, middle, far), _leave(q, m, middle, far)
    a, b = out - middle, back - middle
    axis = np.cross(a, b)
    if np.linalg.norm(axis) < 1e-9 * far**2:  # opposite or the same: over the top, or not at all
        axis = np.cross(a, [0.0, 0.0, 1.0] if abs(a[2]) < 0.9 * far else [1.0, 0.0, 0.0])
    axis = axis / np.linalg.norm(axis)
    angle = np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)
    turns = np.linspace(0, angle, 20)[:, None]
    round_it = middle + np.cos(turns) * a + np.sin(turns) * np.cross(axis, a)
    return np.concatenate([p[None], round_it, q[None]])


def _leave(p: Matrix, n: Matrix, middle: Matrix, far: float) -> Matrix:
    """Returns the point where the ray from p against n leaves the ball."""
    d = p - middle
    along = -float(d @ n)
    outside = along**2 - (float(d @ d) - far**2)
    left: Matrix = p - n * (max(outside, 0.0) ** 0.5 - along)
    return left
