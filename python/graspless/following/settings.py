# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Settings of a follower, all choices unless a source is given, and what it returns."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from .._arguments import require_integer, require_within
from ..errors import TaskError, shown
from .estimate import Noise

if TYPE_CHECKING:
    from ..frames import Matrix


_COUNTS = ("look_poses", "resumes", "restarts")
_RANGES = {
    "gain": (0.01, 20.0),
    "speed": (1e-4, 0.1),
    "turn_speed": (1e-3, 1.0),
    "acceleration": (1e-3, 1.0),
    "turn_acceleration": (1e-2, 10.0),
    "brake_seconds": (0.02, 10.0),
    "lift": (1e-3, 1.0),
    "joint_tolerance": (1e-3, 3.2),
    **dict.fromkeys(("plan_seconds", "resume_seconds", "search_seconds"), (1e-9, math.inf)),
    **dict.fromkeys(("look_seconds", "settle_seconds", "settle_most", "between"), (0, math.inf)),
    **dict.fromkeys(("blind_seconds", "lost_seconds", "joint_seconds"), (0, math.inf)),
    **dict.fromkeys(("correct", "grasp_correct", "shift", "stand_off", "settled"), (0, 0.2)),
    **dict.fromkeys(("correct_angle", "grasp_correct_angle"), (0, 1.6)),
    **dict.fromkeys(("shift_angle", "settled_angle"), (0, 1.6)),
}


@dataclass(frozen=True)
class Settings:
    """Settings of a follower.

    Attributes
    ----------
    noise : Noise
        Assumptions of the filter.
    look_poses : int
        Poses to see before the arm moves, and after the finger was lifted off.
    look_seconds : float
        Longest time to wait for them [s]. Without a single pose the plan is followed blindly. Where
        poses were given, but none could be used, it waits on for `lost_seconds`.
    correct, correct_angle : float
        Deviations of the object up to which the path of the hand is shifted in place [m, rad].
        Beyond them the slide is planned anew.
    grasp_correct, grasp_correct_angle : float
        The same, of the object on which the hand closes [m, rad].
    shift, shift_angle : float
        Largest shift of the hand's path while it slides the object [m, rad].
    stand_off : float
        Distance that the hand keeps from the object while it reaches, beyond the plan's [m].
    gain : float
        Fraction of a deviation that is corrected per second [1/s].
    speed, turn_speed : float
        Largest speeds of corrections [m/s, rad/s].
    acceleration, turn_acceleration : float
        Largest accelerations of corrections [m/s^2, rad/s^2].
    settle_seconds : float
        Rest after pressing and after sliding [s].
    settled, settled_angle : float
        Deviations at the end of the slide that are left alone [m, rad].
    settle_most : float
        Longest time for reaching them [s].
    brake_seconds : float
        Time in which a motion comes to rest, and starts again [s].
    blind_seconds : float
        Time without a usable pose after which a slide waits [s].
    lost_seconds : float
        Time without a usable pose after which a slide that waits is given up [s].
    between : float
        Least time between two plans [s].
    resumes : int
        Number of plans without lifting off after which the motion begins anew.
    restarts : int
        Number of times that the motion may begin anew before it is given up.
    lift : float
        Height to which the hand is lifted to begin anew [m].
    joint_tolerance : float
        Largest distance of the arm's joints from their targets [rad; m/10].
    joint_seconds : float
        Time of larger distances, of joints that are no numbers, or of a clock that does not go on,
        after which the motion is given up [s]. A first distance that is larger ends it at once.
    plan_seconds, resume_seconds : float
        Longest searches for a new plan: from rest, and without lifting off [s].
    search_seconds : float
        Part of them in one update [s]. A search that ends without a plan goes on in the next
        update, with another seed and from the state of then. Its part doubles every time at rest,
        and every fourth time otherwise.

    Raises
    ------
    TaskError
        A value is no number, or outside its range. The message has the range.
    """

    noise: Noise = field(default_factory=Noise)
    look_poses: int = 10
    look_seconds: float = 2.0
    correct: float = 0.006
    correct_angle: float = 0.105
    grasp_correct: float = 0.012
    grasp_correct_angle: float = 0.21
    shift: float = 0.02
    shift_angle: float = 0.25
    stand_off: float = 0.006
    gain: float = 3.0
    speed: float = 0.015
    turn_speed: float = 0.25
    acceleration: float = 0.1
    turn_acceleration: float = 1.5
    settle_seconds: float = 0.3
    settled: float = 0.001
    settled_angle: float = 0.0087
    settle_most: float = 2.5
    brake_seconds: float = 0.3
    blind_seconds: float = 0.7
    lost_seconds: float = 5.0
    between: float = 0.3
    resumes: int = 8
    restarts: int = 3
    lift: float = 0.08
    joint_tolerance: float = 0.2
    joint_seconds: float = 0.2
    plan_seconds: float = 2.0
    resume_seconds: float = 0.15
    search_seconds: float = 0.004

    def __post_init__(self) -> None:
        if not isinstance(self.noise, Noise):
            raise TaskError(f"noise: {shown(self.noise)}: should be a following.Noise")
        for name in _COUNTS:
            require_integer(name, getattr(self, name), least=0)
        for name, (least, most) in _RANGES.items():
            require_within(name, getattr(self, name), least, most)


@dataclass(frozen=True, eq=False)
class Target:
    """Answer of a follower. It equals only itself.

    Attributes
    ----------
    position, velocity : array [dof]
        Target of the joints [rad or m, rad/s or m/s]; valid until the next update.
    status : str
        looking: waiting at rest for poses; moving; waiting: come, or coming, to rest for a reason
        that may pass; done: the hand has closed; stopped: given up.
    reason : str
        Reason of waiting and stopping, and of the last new plan; empty if there was none. When
        done: the reason for which the hand may have closed on nothing.
    phase : str
        Segment of the plan, or retreat: lifting off to begin anew.
    pose : str
        What became of the pose of this update: none was given; used; moved: the object jumped, as
        several poses agree; jumped: unlike the other poses; late; out_of_order; not_a_pose;
        not_a_covariance; vague: has a covariance that is too large; bad_age; off_support; tilted;
        bad_time: came with a t that is a fault.
    """

    position: Matrix
    velocity: Matrix
    status: str
    reason: str = ""
    phase: str = ""
    pose: str = "none"
