# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Settings of the timing: all defaults, and the values of the caller."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .._arguments import require_number
from .._xml import parse
from ..errors import TaskError, shown

if TYPE_CHECKING:
    from .._core.robot import Robot
    from ..frames import Matrix
    from .rates import Rate

    PerJoint = float | Mapping[str, float]

TOLERANCE = 1e-3  # how far joints round the corners of free motions [rad or m]
CONTACT_TOLERANCE = 2e-4  # and where something is touched [rad or m]
OBJECT_TOLERANCE = 1e-4  # how far an object in fingertips rounds its corners [m]

# Limits where the URDF has none, of turning and of sliding joints. URDFs have no accelerations.
VELOCITY = (1.0, 0.25)  # [rad/s], [m/s]
ACCELERATION = (5.0, 1.0)  # [rad/s^2], [m/s^2]
JERK = 50.0  # per acceleration, which is reached in 0.02 s [1/s]
CONTACT_SHARE = 0.1  # of joint accelerations and jerks during contact, so that none breaks it
GUARD = 0.015  # distance to a contact below which parts move at contact speed [m]

CARRY_SPEED = 0.2  # of a held object on its way to a place [m/s]
CONTACT_SPEED = 0.05  # of parts in contact or about to be [m/s]
FINGERTIP_SPEED = 0.02  # of an object in fingertips: faster sliding chatters [m/s]
TUMBLE_SPEED = math.pi / 6  # 90 degrees in 3 s hold in a physics engine, in 1 s not [rad/s]
STABILITY_SHARE = 0.1  # of the disturbance withstood that inertia may take
FREE_FINGER_SPEED = 0.1  # of a fingertip without an arm, off the object [m/s]
FREE_FINGER_ACCELERATION = 0.5  # [m/s^2]

RATE = 100.0  # [1/s]
PAUSE = 0.05  # between segments, where contacts change [s]
LARGEST = 1e9  # limit of a joint: rounding errors spoil the timing with larger ones
_ADVICE = ", because of rounding errors: plan again with another seed"
LONGEST = 2**31 - 1  # duration that ROS messages can hold [s]


class NoMotionError(TaskError):
    """No motion was found along a path.

    Parameters
    ----------
    given : list of str
        Names of the limits that the caller gave.
    """

    def __init__(self, given: Sequence[str] = ()) -> None:
        limits = f" within {', '.join(given)}: should be closer to the defaults" if given else ""
        super().__init__(f"toppra found no motion along a path{limits or _ADVICE}")
        self._given = tuple(given)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._given,)


@dataclass(frozen=True)
class Settings:
    """Settings of one call of `time`.

    Attributes
    ----------
    robot : Robot or None
        Robot that moves; None for fingertips without an arm.
    velocity, acceleration, jerk : array [dof]
        Limits of its joints [rad/s, rad/s^2, rad/s^3], or [m/s, m/s^2, m/s^3] for sliding joints.
    contact_speed : float or None
        Speed limit of parts in contact [m/s]; None for the default of the kind of plan.
    rate : Rate
        Sampling rate.
    pause : float
        Rest between segments [s].
    """

    robot: Robot | None
    velocity: Matrix
    acceleration: Matrix
    jerk: Matrix
    contact_speed: float | None
    rate: Rate
    pause: float

    def speed(self, default: float) -> float:
        """Returns the speed limit of parts in contact [m/s]."""
        return default if self.contact_speed is None else self.contact_speed


def joint_limits(
    robot: Robot | None,
    max_velocity: PerJoint | None,
    max_acceleration: PerJoint | None,
    max_jerk: PerJoint | None,
) -> tuple[Matrix, Matrix, Matrix]:
    """Returns limits of velocity, acceleration and jerk [dof], in the order of a robot's joints.

    A velocity limit is the smaller one of the URDF and the caller.
    """
    if robot is None:
        every = {
            "max_velocity": max_velocity,
            "max_acceleration": max_acceleration,
            "max_jerk": max_jerk,
        }
        for name, given in every.items():
            if given is not None:
                what = "this plan moves no joints: should be left out"
                raise TaskError(f"{name}: {shown(given)}: {what}")
        return np.zeros(0), np.zeros(0), np.zeros(0)
    _require_velocities(robot, max_velocity)
    slides = np.asarray(robot.step_weights) > 1  # of prismatic joints, also if others follow them
    velocity = np.asarray(robot.max_velocity, dtype=float).copy()
    unknown = ~(np.isfinite(velocity) & (velocity > 0))
    velocity[unknown] = np.where(slides, VELOCITY[1], VELOCITY[0])[unknown]
    velocity = np.minimum(velocity, _per_joint("max_velocity", max_velocity, robot, np.inf))
    default = np.where(slides, ACCELERATION[1], ACCELERATION[0])
    acceleration = _per_joint("max_acceleration", max_acceleration, robot, default)
    jerk = _per_joint("max_jerk", max_jerk, robot, JERK * acceleration)
    return velocity, acceleration, jerk


def require_positive(name: str, value: float, other: str = "") -> float:
    """Returns the value; raises TaskError unless it is a finite positive number.

    The message names what `other` than a number it may be.
    """
    require_number(name, value, other)
    if not math.isfinite(value) or value <= 0:
        raise TaskError(f"{name}: {value}: should be positive and finite")
    return float(value)


def _per_joint(name: str, given: PerJoint | None, robot: Robot, default: Matrix | float) -> Matrix:
    """Returns limits [dof]: the values of the caller, and a default for other joints."""
    values: Matrix = np.broadcast_to(np.asarray(default, dtype=float), (robot.dof,)).copy()
    if isinstance(given, Mapping):
        for joint, value in given.items():
            if not isinstance(joint, str):
                raise TaskError(f"{name}: {shown(joint)}: should be the name of a joint")
            try:
                index = robot.joint(joint)
            except ValueError as error:
                raise TaskError(f"{name}: {error}") from None
            values[index] = _limit(f"{name}: {joint}", value)
    elif given is not None:
        values[:] = _limit(name, given, ", or numbers by name of joint")
    return values


def _limit(name: str, value: float, other: str = "") -> float:
    """Returns a limit; raises TaskError unless it is in (0, LARGEST]."""
    if require_positive(name, value, other) > LARGEST:
        raise TaskError(f"{name}: {value:g}: should be at most {LARGEST:g}")
    return float(value)


def _require_velocities(robot: Robot, given: PerJoint | None) -> None:
    """Raises TaskError if the URDF's velocity limit of a joint is none, and the caller has none."""
    if given is not None and not isinstance(given, Mapping):
        return
    for joint in parse(robot.urdf).iter("joint"):
        name, limit = joint.get("name"), joint.find("limit")
        if name not in robot.joint_names or limit is None or name in (given or {}):
            continue
        text = limit.get("velocity", "0")
        if not float(text) > 0:
            what = "should be positive in the URDF, or be given as max_velocity of this joint"
            raise TaskError(f"robot: {name}: velocity limit {text}: {what}")
