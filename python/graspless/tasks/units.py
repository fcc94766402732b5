# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers that look like millimetres or degrees."""

from __future__ import annotations

import itertools
import math
import re
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import BaseModel

from .source import LARGEST

if TYPE_CHECKING:
    from collections.abc import Callable

    from .._core.robot import Robot
    from .source import Location, Source

WIDEST = 1e6  # of an angle: rounding takes the meaning of larger ones [rad]
LARGEST_TURN = 20.0  # of a joint: limits of real ones are a few turns [rad]
FARTHEST, REFUSED = 100.0, 1e4  # largest coordinate that nobody doubts, and of the core [m]
_FARTHEST_MOVES = {"translation": 5.0}  # and of ways of an object: fingertips have no reach [m]
_UNITS = re.compile(r"\[((?:m|rad)(?:, (?:m|rad))*)\]")
_BOUNDED = ("size", "radius", "box", "angle")  # the kinds of tasks have bounds of their own,
_UNBOUNDED = {"obstacles", "region"}  # but not in these sections


def warn_of_units(fields: BaseModel, source: Source, place: Location = ()) -> bool:
    """Warns of angles that look like degrees, and of coordinates that look like millimetres.

    The descriptions of the fields have their units. Of a list, the first such item is named.
    Returns True if there was one. Raises TaskError if an angle means nothing.
    """
    has_warned = False
    for name, info in type(fields).model_fields.items():
        value, inner = getattr(fields, name), (*place, name)
        if isinstance(value, BaseModel):
            has_warned |= warn_of_units(value, source, inner)
        elif isinstance(value, list) and value and isinstance(value[0], BaseModel):
            has_warned |= any(warn_of_units(v, source, (*inner, i)) for i, v in enumerate(value))
        elif name in _BOUNDED and _UNBOUNDED.isdisjoint(place):
            continue
        elif units := _UNITS.search(info.description or ""):
            has_warned |= _warn_of_value(value, units[1].split(", "), inner, source)
    return has_warned


def _warn_of_value(value: Any, units: list[str], place: Location, source: Source) -> bool:
    """Warns of a number, or of the first such number in a list, which has one unit or several."""
    if isinstance(value, list):
        if value and isinstance(value[0], list):  # of points, the kinds look at the extent
            return False
        each = enumerate(zip(value, itertools.cycle(units), strict=False))
        return any(_warn_of_value(v, [unit], (*place, i), source) for i, (v, unit) in each)
    farthest = next((_FARTHEST_MOVES[key] for key in place if key in _FARTHEST_MOVES), FARTHEST)
    if not isinstance(value, float):
        return False
    if units == ["rad"]:
        return warn_of_angle(value, place, source)
    is_far = farthest < abs(value) <= REFUSED
    if is_far:
        source.warn(place, f"is more than {farthest:g} m; lengths are in metres")
    return is_far


def warn_of_angle(angle: float, location: Location, source: Source) -> bool:
    """Warns of an angle that looks like degrees. Returns True if it does.

    Raises TaskError if it means nothing.
    """
    if abs(angle) > WIDEST:
        raise source.error(location, f"should lie in [-{WIDEST:g}, {WIDEST:g}] rad")
    is_wide = abs(angle) > 2 * math.pi
    if is_wide:
        source.warn(location, "is more than a turn; angles are in radians")
    return is_wide


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
