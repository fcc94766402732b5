# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Joints as a robot measures them, and as plans have them. It knows no ROS.

A measured joint may have gone beyond its limit a little, or turned many times.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .._xml import parse

if TYPE_CHECKING:
    from collections.abc import Mapping
    from xml.etree.ElementTree import Element

    from .._core.robot import Robot

TURN = 2 * math.pi
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
            q -= TURN * round(q / TURN)
        near = min(max(q, float(robot.lower[k])), float(robot.upper[k]))
        home[name] = near if abs(q - near) * joints[name].weight <= tolerance else q
    return home
