# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A fingertip plan in time, slowly enough to be quasi-static."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ... import frames
from ...timing import Trajectory

if TYPE_CHECKING:
    from ...frames import Matrix
    from ...plans.fingertip import Plan, Segment

SPEED = 0.005  # of any corner that slides; faster, MuJoCo lifts the object off [m/s]
TURNING = np.pi / 6  # of a tumble: a quarter in three seconds [rad/s]
RAMP = 0.3  # from rest, and to rest [s]
REGRASP = 1.5  # [s]
RATE = 100.0  # [1/s]


def paced(plan: Plan) -> Trajectory:
    """Every stretch from rest to rest at its steady pace; rows of a regrasp go from 0 to 1."""
    hull = np.array(plan.task.problem.object.hull)
    parts = [_segment(segment, hull) for segment in plan.segments]
    starts = np.concatenate([[0.0], np.cumsum([times[-1] + 1e-6 for times, _, _ in parts])])
    times = np.concatenate([t + start for (t, _, _), start in zip(parts, starts, strict=False)])
    index = np.concatenate([np.full(len(t), s) for s, (t, _, _) in enumerate(parts)])
    none = np.zeros((len(times), 0))
    rows = np.concatenate([r for _, r, _ in parts])
    poses = np.concatenate([p for _, _, p in parts])
    return Trajectory(plan, plan.segments, times, index, rows, [], none, none, none, poses)


def _segment(segment: Segment, hull: Matrix) -> tuple[Matrix, Matrix, Matrix]:
    """Times, rows and poses."""
    arcs = len(segment.X_WO) - 1
    if arcs == 0:
        times = np.linspace(0, REGRASP, round(REGRASP * RATE) + 1)
        return times, times / REGRASP, np.repeat(segment.X_WO[:1], len(times), axis=0)
    total = sum(_seconds(*pair, hull) for pair in zip(segment.X_WO, segment.X_WO[1:], strict=False))
    times = np.linspace(0, total + RAMP, int((total + RAMP) * RATE) + 2)
    along = _ramped(times, total + RAMP, min(RAMP, total)) * arcs
    rows = along * len(segment) / arcs - 0.5
    before = np.floor(along).astype(int).clip(0, arcs - 1)
    poses = [
        frames.between(segment.X_WO[k], segment.X_WO[k + 1], u - k)
        for k, u in zip(before, along, strict=True)
    ]
    return times, rows.clip(0, len(segment) - 1), np.array(poses)


def _ramped(times: Matrix, total: float, ramp: float) -> Matrix:
    """From 0 to 1 in `total` seconds with an even pace between ramps."""
    pace = 1 / (total - ramp)
    steady = pace * (times - ramp / 2)
    start, end = pace * times**2 / 2 / ramp, 1 - pace * (total - times) ** 2 / 2 / ramp
    return np.where(times < ramp, start, np.where(times > total - ramp, end, steady))


def _seconds(X_WO: Matrix, X_WO_next: Matrix, hull: Matrix) -> float:
    """That an arc takes at its steady pace."""
    step = X_WO_next - X_WO
    farthest = np.linalg.norm(hull @ step[:3, :3].T + step[:3, 3], axis=1).max()
    axis = np.cross(X_WO[:3, :3], X_WO_next[:3, :3], axis=0).sum(axis=1) / 2
    tilts = np.linalg.norm(axis[:2]) > 1e-9
    turned = np.arcsin(min(1.0, float(np.linalg.norm(axis))))
    return float(turned / TURNING if tilts else farthest / SPEED)
