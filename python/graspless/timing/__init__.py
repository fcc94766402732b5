# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans in time: the fastest motion through their rows within limits, by toppra."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from ..errors import TaskError
from ..kinds import part
from ..plans import as_plan
from .rates import Rate
from .trajectory import Trajectory

if TYPE_CHECKING:
    from pathlib import Path

    from ..plans import Plan
    from ..robot import Robot
    from .settings import PerJoint, Settings


class TimingKind(Protocol):
    """What `timing` needs of a kind."""

    def robot(self, plan: Any, fingers: bool) -> Robot | None:
        """That the plan was made for; `fingers`: none is to be moved."""

    def trajectory(self, plan: Any, settings: Settings) -> Trajectory:
        """A plan that is solved, in time."""


def time(
    plan: Plan | str | Path,
    robot: Robot | None = None,
    *,
    max_velocity: PerJoint | None = None,
    max_acceleration: PerJoint | None = None,
    contact_speed: float | None = None,
    rate: float | None = None,
    pause: float | None = None,
    fingers: bool = False,
) -> Trajectory:
    """A plan in time: as fast as its limits allow, segment by segment from rest to rest.

    Between rows the joints move along straight lines, and round corners by at most 1e-3 (rad or
    m), 2e-4 where something is touched. Limits hold at every moment. Where something is touched,
    joint accelerations are a tenth of their limits, and an object in fingertips is moved so slowly
    that its inertia takes a tenth of the least `stability` of the segment.

    A fingertip plan without an arm has no joints; rows go from -0.5 to N - 0.5, from the first of
    `X_WO` to the last. In a regrasp they go from 0 to 1: until 1/3 the finger leaves along the
    contact's normal, until 2/3 it moves above its new place, until 1 it touches.

    Parameters
    ----------
    plan : Plan, str or Path
        One that is solved, or the file it stands in. It is not checked: `check` does that.
    robot : Robot, optional
        Instead of the plan's own, with the same joints: for its limits.
    max_velocity : float or dict, optional
        Of all joints or by joint [rad/s, m/s]; the URDF's limits hold besides. Where there is
        neither: 1 rad/s, 0.25 m/s.
    max_acceleration : float or dict, optional
        Of all joints or by joint [rad/s^2, m/s^2]; URDFs have none. Default: 5 rad/s^2, 1 m/s^2.
    contact_speed : float, optional
        Of what touches or is about to [m/s]: the sliding fingertip while it presses, slides and
        lifts, the hand on the last way to a grasp and while it carries, every point of fingers
        that close; of fingertip plans the object. Default 0.05, of fingertip plans 0.02.
    rate : float, optional
        Moments a second that the trajectory has; between them it is linear. Default 100.
    pause : float, optional
        Between segments, where contacts change [s]. Default 0.05. Above 0: the end of one segment
        and the start of the next are moments of their own, and no two are at the same time.
    fingers : bool
        Of a fingertip plan that has an arm: the bare fingertips' `segments` all the same, also
        where its status is not_realized.

    Raises
    ------
    TaskError
        The plan is not solved, the robot is another one, a limit is not positive or so small that
        the trajectory has more than 1e6 moments or takes more than 2^31 - 1 s, or toppra is not
        installed.
    """
    from . import settings as defaults

    plan = as_plan(plan)
    if not plan and not (fingers and plan.status == "not_realized"):
        raise TaskError(f"the plan's status is {plan.status}, not solved: nothing to time")
    rate = defaults.require_positive("rate", defaults.RATE if rate is None else rate)
    pause = defaults.require_positive("pause", defaults.PAUSE if pause is None else pause)
    if pause > defaults.LONGEST:
        raise TaskError(f"pause: {pause:g}: should be at most {defaults.LONGEST}")
    kind = _kind(plan.kind)
    own = kind.robot(plan, fingers)
    robot = own if robot is None else _require_same_joints(robot, own)
    if contact_speed is not None:
        contact_speed = defaults.require_positive("contact_speed", contact_speed)
    velocity, acceleration = defaults.joint_limits(robot, max_velocity, max_acceleration)
    asked = defaults.Settings(robot, velocity, acceleration, contact_speed, Rate(rate), pause)
    return defaults.require_sayable(kind.trajectory(plan, asked), pause)


def _require_same_joints(robot: Robot, own: Robot | None) -> Robot:
    if not hasattr(robot, "joint_names"):
        raise TaskError(f"robot: {robot}: should be a graspless.robot.Robot")
    needed = [] if own is None else list(own.joint_names)
    if list(robot.joint_names) != needed:
        has, wants = ", ".join(robot.joint_names), ", ".join(needed) or "none"
        raise TaskError(f"robot: {robot.name}: its joints are {has}; the plan's are {wants}")
    return robot


def _kind(name: str) -> TimingKind:
    try:
        kind: TimingKind = part("timing", name)
    except ImportError as error:
        raise TaskError(f"needs {error.name or error}: pip install 'graspless[timing]'") from None
    return kind


__all__ = ["Trajectory", "time"]
