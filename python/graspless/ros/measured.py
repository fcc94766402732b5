# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Joints as a robot measures them, and as plans have them. It knows no ROS.

A measured joint may have gone beyond its limit a little, or turned many times.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .._xml import parse

if TYPE_CHECKING:
    from collections.abc import Mapping

    from .._core.robot import Robot
    from ..frames import Matrix

_TURN = 2 * np.pi


@dataclass(frozen=True)
class Joint:
    """A joint that moves.

    Attributes
    ----------
    is_continuous : bool
        True if a whole turn changes nothing.
    """

    is_continuous: bool


def joints_of(robot: Robot) -> dict[str, Joint]:
    """Returns the joints of a robot that move, by their names."""
    return {
        element.get("name", ""): Joint(element.get("type") == "continuous")
        for element in parse(robot.urdf).iterfind("joint")
        if element.get("type") in ("revolute", "continuous", "prismatic")
    }


def home_of(robot: Robot, measured: Mapping[str, float], tolerance: float) -> dict[str, float]:
    """Returns the measured joints of a robot as a plan can start from them [rad or m].

    Continuous joints are within half a turn, and those that are beyond a limit by no more than the
    tolerance [rad; of sliding joints 1/10 m] are at it. Other joints of the robot are left out.
    """
    joints, home = joints_of(robot), {}
    for k, name in enumerate(robot.joint_names):
        if name not in measured:
            continue
        q = measured[name]
        if joints[name].is_continuous:
            q -= _TURN * round(q / _TURN)
        near = min(max(q, float(robot.lower[k])), float(robot.upper[k]))
        home[name] = near if abs(q - near) * robot.step_weights[k] <= tolerance else q
    return home


def turns_of(joints: list[Joint], q: Matrix, start: Matrix) -> Matrix:
    """Returns the whole turns from the start of a trajectory to measured joints [dof] [rad]."""
    is_continuous = np.array([joint.is_continuous for joint in joints])
    return np.where(is_continuous, _TURN * np.round((q - start) / _TURN), 0.0)
