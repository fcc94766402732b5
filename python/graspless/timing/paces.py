# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Speeds of points and links as bounds along a path: see `limits.Limits`.

A path's first coordinates are the robot's joints.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from .._core.robot import Robot
    from ..frames import Matrix
    from .limits import Pace


def frame_speed(robot: Robot, frame: str, speed: float) -> Pace:
    """Returns a pace that keeps the origin of a link at or below `speed` [m/s]."""

    def pace(q: Matrix, dq: Matrix) -> Matrix:
        joints, rates = q[:, : robot.dof], dq[:, : robot.dof]
        velocities = np.einsum("nij,nj->ni", robot.jacobian(frame, joints)[:, :3], rates)
        moved: Matrix = np.linalg.norm(velocities, axis=1) / speed
        return moved

    return pace


def link_speed(robot: Robot, speed: float) -> Pace:
    """Returns a pace that keeps every point of all links at or below `speed` [m/s]."""
    reach = np.array([robot.reach(frame) for frame in robot.frame_names])

    def pace(_: Matrix, dq: Matrix) -> Matrix:
        moved: Matrix = (np.abs(dq[:, : robot.dof]) @ reach.T).max(axis=1) / speed
        return moved

    return pace
