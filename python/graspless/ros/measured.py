# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Joints as a robot measures them, and as plans have them. It knows no ROS.

A measured joint may have gone beyond its limit a little, or turned many times.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .._xml import parse

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping
    from xml.etree.ElementTree import Element

    from .._core.robot import Robot
    from ..frames import Matrix
    from .jobs import Found

_TURN = 2 * np.pi
_WEIGHTS = {"revolute": 1.0, "continuous": 1.0, "prismatic": 10.0}  # as in Robot.step_weights


@dataclass(frozen=True)
class Joint:
    """A joint that moves.

    Attributes
    ----------
    is_continuous : bool
        True if a whole turn changes nothing.
    weight : float
        Weight of its motion, as in Robot.step_weights.
    driver, multiplier, offset : str, float, float
        A mimic joint is at multiplier * (value of the driver) + offset [rad or m]. An independent
        joint is its own driver.
    """

    is_continuous: bool
    weight: float
    driver: str
    multiplier: float
    offset: float


def joints_of(robot: Robot) -> dict[str, Joint]:
    """Returns the joints of a robot that move, by their names, mimic joints included."""
    elements = {each.get("name", ""): each for each in parse(robot.urdf).iterfind("joint")}
    return {
        name: Joint(kind == "continuous", _WEIGHTS[kind], *_drive(element, elements))
        for name, element in elements.items()
        if (kind := element.get("type", "")) in _WEIGHTS
    }


def _drive(element: Element, elements: dict[str, Element]) -> tuple[str, float, float]:
    """Returns driver, multiplier and offset of a joint, which may mimic a mimic joint."""
    multiplier, offset = 1.0, 0.0
    while (mimic := element.find("mimic")) is not None:
        offset += multiplier * float(mimic.get("offset", 0))
        multiplier *= float(mimic.get("multiplier", 1))
        element = elements[mimic.get("joint", "")]
    return element.get("name", ""), multiplier, offset


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
        home[name] = near if abs(q - near) * joints[name].weight <= tolerance else q
    return home


def with_mimics(found: Found, names: Iterable[str]) -> Found:
    """Returns a trajectory that has the mimic joints among some joints, too."""
    added = [name for name in names if name in found.joints and name not in found.joint_names]
    joints = [found.joints[name] for name in added]
    columns = [found.joint_names.index(joint.driver) for joint in joints]
    factors, offsets = (
        np.array([getattr(j, what) for j in joints]) for what in ("multiplier", "offset")
    )

    def extended(values: Matrix, shift: Any = 0.0) -> Matrix:
        return np.hstack([values, values[:, columns] * factors + shift])

    return replace(
        found,
        joint_names=[*found.joint_names, *added],
        positions=extended(found.positions, offsets),
        velocities=extended(found.velocities),
        accelerations=extended(found.accelerations),
    )


def turns_of(found: Found, q: Matrix) -> Matrix:
    """Returns the whole turns from the start of a trajectory to measured joints [dof] [rad]."""
    is_continuous = np.array([found.joints[name].is_continuous for name in found.joint_names])
    return np.where(is_continuous, _TURN * np.round((q - found.positions[0]) / _TURN), 0.0)
