# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that look like millimetres or degrees."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .shapes import Pose
    from .source import Location, Source

WIDEST = 1e6  # of an angle: rounding takes the meaning of larger ones [rad]
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
