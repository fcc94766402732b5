# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""MJCF of a task, one keyframe at the start and one at each segment's end: one file, nothing beside
it.

The robot has position servos, the object a free joint; bare fingertips are mocap bodies. The
servos' targets contain the squeeze of a hand that holds. MuJoCo writes numbers with six digits.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from .. import frames
from ..simulation.robots import compiled, set_positions
from ..simulation.settings import Slide
from ..timing.squeeze import targets
from .fingers import centers
from .mujoco_scene import OBJECT, build
from .numbers import numbered

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..robot import Robot
    from ..timing import Trajectory


def text(trajectory: Trajectory) -> str:
    """Returns the MJCF."""
    spec, robot = build(trajectory)
    model = compiled(spec)
    ctrl = targets(trajectory, Slide().squeeze)
    last = np.flatnonzero(np.diff(trajectory.segment_index, append=len(trajectory.segments)))
    names = numbered(trajectory)
    keys: list[tuple[str, int]] = [("start", 0)]
    keys += [(names[int(trajectory.segment_index[k])], int(k)) for k in last]
    for name, k in keys:
        key = spec.add_key(name=name, time=float(trajectory.times[k]))
        key.qpos = _qpos(model, robot, trajectory.positions[k], trajectory.object_poses[k])
        if robot is not None:
            key.ctrl = ctrl[k]
        else:
            key.mpos = centers(trajectory, k).ravel()
    spec.compile()
    document: str = spec.to_xml()
    return document


def _qpos(model: Any, robot: Robot | None, q: Matrix, X_WO: Matrix) -> Matrix:
    """Returns qpos [nq] with the values of mimic joints."""
    data = mujoco.MjData(model)
    if robot is not None:
        set_positions(model, data, robot, q)
    place = model.joint(OBJECT).qposadr[0]
    data.qpos[place : place + 7] = frames.to_row(X_WO)
    qpos: Matrix = data.qpos
    return qpos
