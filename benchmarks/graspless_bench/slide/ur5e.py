# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A UR5e that carries the hand of wam_t42: the arm of the comparison with sscbirrt."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING

import numpy as np

from graspless import _data
from graspless import robot as robots

from ..ik import ARMS, RIGHT, urdf_of

if TYPE_CHECKING:
    from graspless.frames import Matrix

ROWS = ARMS["UR5e"]
RADII = (0.06, 0.055, 0.045, 0.04, 0.04, 0.035)  # of the links' cylinders [m]


def arm_urdf() -> str:
    """URDF of the arm from Denavit and Hartenberg's parameters, with two cylinders a link."""
    text = urdf_of(ROWS)
    for i, ((a, _, d), radius) in enumerate(zip(ROWS, RADII, strict=True), 1):
        parts = _cylinder(f"0 0 {d / 2!r}", "0 0 0", abs(d), radius)
        parts += _cylinder(f"{a / 2!r} 0 {d!r}", f"0 {RIGHT!r} 0", abs(a), radius)
        text = text.replace(f"<link name='l{i}'/>", f"<link name='l{i}'>{parts}</link>")
    return text


def _cylinder(xyz: str, rpy: str, length: float, radius: float) -> str:
    if length == 0:
        return ""
    shape = f"<cylinder length='{length!r}' radius='{radius!r}'/>"
    return f"<collision><origin xyz='{xyz}' rpy='{rpy}'/><geometry>{shape}</geometry></collision>"


@functools.cache
def robot() -> robots.Robot:
    """The robot, with groups, states and ignored pairs as proposed."""
    path = _data.robot("wam_t42")
    assert path is not None
    arm = robots.Description(urdf=arm_urdf())
    hand = robots.Description(urdf=path.read_text(encoding="utf-8"), directory=str(path.parent))
    joined = robots.join(arm, hand, "l7", root="hand_base")
    found = robots.inspect(robots.Robot.from_urdf(joined.urdf), name="ur5e_t42")
    return found.robot


def home() -> Matrix:
    """All joints at the start: the hand points down at the middle of the tables."""
    return np.asarray(robot().state("home"))
