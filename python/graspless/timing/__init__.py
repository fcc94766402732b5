# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of plans: the fastest motion through their rows within limits, by toppra."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from .._arguments import require_type
from .._core.robot import Robot
from ..errors import TaskError, missing
from ..kinds import part
from ..plan_files import as_motion
from .rates import Rate
from .trajectory import Trajectory, require_sayable

if TYPE_CHECKING:
    from pathlib import Path

    from .._plan import Plan
    from .settings import PerJoint, Settings


class TimingKind(Protocol):
    """Functions that `timing` needs of each kind of plan."""

    def robot(self, plan: Any, fingers: bool) -> Robot | None:
        """Returns the robot of the plan; None if bare fingertips are timed (`fingers`)."""

    def trajectory(self, plan: Any, settings: Settings) -> Trajectory:
        """Times a solved plan."""


def time(
    plan: Plan | str | Path,
    robot: Robot | None = None,
    *,
    max_velocity: PerJoint | None = None,
    max_acceleration: PerJoint | None = None,
    max_jerk: PerJoint | None = None,
    contact_speed: float | None = None,
    rate: float | None = None,
    pause: float | None = None,
    fingers: bool = False,
) -> Trajectory:
    """Times a plan: as fast as its limits allow, at rest where contacts change.

    Between rows the joints move along straight lines. Corners are rounded by at most 1e-3 (rad or
    m), and by 2e-4 near a contact. Limits hold at every moment. Near a contact, which is within 15
    mm of it, joint accelerations and jerks are at most a tenth of their limits. Fingertips move an
    object so slowly that its inertia takes at most a tenth of the least `stability` of the segment.

    A fingertip plan without an arm has no joints. Its rows go from -0.5 to N - 0.5, from the first
    pose of `X_WO` to the last. During a regrasp they go from 0 to 1: up to 1/3 the finger leaves
    along the contact normal, up to 2/3 it moves above its new contact, up to 1 it approaches it.

    Parameters
    ----------
    plan : Plan, str or Path
        Solved plan, or the path of its file. It is not checked first; `check` does that.
    robot : Robot, optional
        Robot whose limits are used instead of those of the plan's robot. It must have the same
        joints.
    max_velocity : float or dict, optional
        Limit of all joints, or limits by joint name [rad/s, m/s]. The limits of the URDF hold as
        well. Default for joints without any: 1 rad/s, 0.25 m/s.
    max_acceleration : float or dict, optional
        Limit of all joints, or limits by joint name [rad/s^2, m/s^2]. Default: 5 rad/s^2, 1 m/s^2.
    max_jerk : float or dict, optional
        Limit of all joints, or limits by joint name [rad/s^3, m/s^3]. Default: the limit of
        acceleration is reached in 0.02 s.
    contact_speed : float, optional
        Speed limit of parts in contact or about to be [m/s]: the sliding fingertip while it
        presses, slides and lifts; the hand on its approach to a grasp and while it carries; every
        point of closing fingers; the object of fingertip plans. Parts that press, lift or close
        are free until 15 mm before the contact. Default: 0.05; for fingertip plans 0.02, for a
        held object on its way to a place 0.2.
    rate : float, optional
        Samples of the trajectory per second [1/s]. Default: 100.
    pause : float, optional
        Rest where contacts change [s]; above 0, so that the end of one segment and the start of
        the next are separate samples. Default: 0.05.
    fingers : bool
        Time the bare fingertips of a plan that has an arm. This also works for a plan whose
        status is not_realized.

    Returns
    -------
    Trajectory
        Positions, velocities and accelerations of the joints, and poses of the object.

    Raises
    ------
    TaskError
        The plan is not solved, or has a segment without rows; the robot has other joints; a limit
        is not positive, or so small that the trajectory has more than 1e6 samples or takes more
        than 2^31 - 1 s; or toppra is not installed.
    """
    from . import settings as defaults

    plan = as_motion(plan, "time", *(["not_realized"] if fingers else []))
    rate = defaults.require_positive("rate", defaults.RATE if rate is None else rate)
    pause = defaults.require_positive("pause", defaults.PAUSE if pause is None else pause)
    if pause > defaults.LONGEST:
        raise TaskError(f"pause: {pause:g}: should be at most {defaults.LONGEST}")
    kind = _kind(plan.kind)
    own = kind.robot(plan, fingers)
    robot = own if robot is None else _require_same_joints(robot, own)
    if contact_speed is not None:
        contact_speed = defaults.require_positive("contact_speed", contact_speed)
    limits = defaults.joint_limits(robot, max_velocity, max_acceleration, max_jerk)
    asked = defaults.Settings(robot, *limits, contact_speed, Rate(rate), pause)
    try:
        return require_sayable(kind.trajectory(plan, asked), pause)
    except defaults.NoMotionError:
        given = {
            "max_velocity": max_velocity,
            "max_acceleration": max_acceleration,
            "max_jerk": max_jerk,
            "contact_speed": contact_speed,
        }
        names = [name for name, value in given.items() if value is not None]
        raise defaults.NoMotionError(names) from None


def _require_same_joints(robot: Robot, own: Robot | None) -> Robot:
    require_type("robot", robot, Robot)
    needed = [] if own is None else list(own.joint_names)
    if list(robot.joint_names) != needed:
        has, wants = ", ".join(robot.joint_names), ", ".join(needed) or "none"
        raise TaskError(f"robot: {robot.name}: its joints are {has}; the plan's are {wants}")
    return robot


def _kind(name: str) -> TimingKind:
    try:
        kind: TimingKind = part("timing", name)
    except ImportError as error:
        raise missing(error, "timing") from None
    return kind


__all__ = ["Trajectory", "time"]
