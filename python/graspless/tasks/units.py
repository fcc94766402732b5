# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that look like millimetres or degrees."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .source import LARGEST

if TYPE_CHECKING:
    from collections.abc import Callable

    from .._core.robot import Robot
    from .shapes import Pose
    from .source import Location, Source

WIDEST = 1e6  # of an angle: rounding takes the meaning of larger ones [rad]
LARGEST_TURN = 20.0  # of a joint: limits of real ones are a few turns [rad]
FARTHEST = 2.0  # of a gripper from the link that carries it [m]


def warn_of_pose(
    pose: Pose | None, location: Location, source: Source, farthest: float = math.inf
) -> None:
    """Warns of angles that look like degrees, and of a position farther away than `farthest`."""
    if pose is None:
        return
    for i, angle in enumerate(pose.rpy or []):
        warn_of_angle(angle, (*location, "rpy", i), source)
    away = math.hypot(*pose.position)
    if away > farthest:
        source.warn((*location, "position"), f"is {away:.4g} m away; lengths are in metres")


def warn_of_angle(angle: float, location: Location, source: Source) -> None:
    """Warns of an angle that looks like degrees; raises TaskError if it means nothing."""
    if abs(angle) > WIDEST:
        raise source.error(location, f"should lie in [-{WIDEST:g}, {WIDEST:g}] rad")
    if abs(angle) > 2 * math.pi:
        source.warn(location, "is more than a turn; angles are in radians")


def require_limits(robot: Robot, place: Callable[[str], Location], source: Source) -> None:
    """Raises TaskError if a joint has a limit too large to compute with.

    `place` returns the field that a message is about.
    """
    for name, limits in zip(robot.joint_names, np.c_[robot.lower, robot.upper], strict=True):
        most = max(limits, key=abs)
        if abs(most) > LARGEST:
            what = (
                f"joint '{name}' has a limit of {most:g}: should lie in [{-LARGEST:g}, {LARGEST:g}]"
            )
            raise source.error(place(what), what)


def warn_of_limits(robot: Robot, place: Callable[[str], Location], source: Source) -> None:
    """Warns of limits of turning joints that look like degrees."""
    most = np.maximum(np.abs(robot.lower), np.abs(robot.upper))
    wide = np.flatnonzero((most > LARGEST_TURN) & (robot.step_weights == 1))
    if len(wide):
        k = wide[0]
        more = f", and {len(wide) - 1} more are like it" if len(wide) > 1 else ""
        what = f"joint '{robot.joint_names[k]}' turns from {robot.lower[k]:g} to {robot.upper[k]:g}"
        source.warn(place(what), f"{what} rad{more}; limits in a URDF are in radians")
