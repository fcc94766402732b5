# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A timed segment with a clock that brakes, and the transition into it from another motion."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import TaskError
from ..timing import settings
from ..timing.ramps import Ramped
from ..timing.rates import Rate
from . import plane

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix
    from ..robot import Robot
    from ..timing.limits import Zone
    from ..timing.settings import PerJoint, Settings

STRAIGHT = 0.7  # cosine between two velocities below which a motion comes to rest between them
_SHORTEST = 0.1  # of a transition [s]
_LONGEST = 10_000.0  # segment [s]
_UNUSED = 1.0  # sampling rate: segments are not sampled
_SHARE = 0.75  # of the velocity limits; corrections take the rest


class Course:
    """A segment that is followed: its clock, and what is left of the motion before it.

    Parameters
    ----------
    segment : slide.Segment
    places : array [N, 3]
        Place of the object at each row, in the plane of the support.
    zones : list of timing.limits.Zone
        Limits of its rows.
    q, velocity : array [dof], optional
        State in which the segment begins; by default at rest at its first row.

    Raises
    ------
    TaskError
        The limits are so low that the segment would take hours.
    """

    def __init__(
        self,
        segment: Any,
        places: Matrix,
        zones: Sequence[Zone],
        q: Matrix | None = None,
        velocity: Matrix | None = None,
    ) -> None:
        self.name = str(segment.name)
        self.places = places
        rows = np.asarray(segment.positions)
        self._timed = Ramped(rows, zones, velocity)
        if not self._timed.duration <= _LONGEST:
            raise TaskError(
                f"{self.name}: takes {self._timed.duration:.3g} s, more than {_LONGEST:g}: "
                "max_velocity, max_acceleration or contact_speed should be more"
            )
        self.clock, self.rate = 0.0, 1.0
        self._now = 0.0, self._timed.now(0.0)  # the last time asked for, with row and joints
        self._since = 0.0
        none = np.zeros(rows.shape[1])
        self._offset = none if q is None else q - self._now[1][1]
        start = self._timed.at(np.zeros(1)).velocities[0]
        self._drift = none if velocity is None else velocity - start
        self._acceleration = np.min([zone.limits.acceleration for zone in zones], axis=0)
        self._fades = self._fading()

    @property
    def has_ended(self) -> bool:
        """True if the last row is reached."""
        return self.clock >= self._timed.duration and not self.is_fading

    @property
    def is_fading(self) -> bool:
        """True while something is left of the motion before."""
        return self.differs and self._since < self._fades

    @property
    def differs(self) -> bool:
        """True if the segment began in another state than at rest in its first row."""
        return bool(np.any(self._offset) or np.any(self._drift))

    def advance(self, seconds: float, rate: float, braking: float) -> None:
        """Moves the clock; `rate` from 0 to 1 is approached within `braking` [s]."""
        step = seconds / braking
        before = self.rate
        self.rate += float(np.clip(rate - self.rate, -step, step))
        self.clock = min(self.clock + seconds * (before + self.rate) / 2, self._timed.duration)
        self._since += seconds

    def rest(self, offset: Matrix) -> None:
        """Starts again from rest, `offset` [dof] away from where it is now."""
        self._offset = self._left(0.0) + offset
        self._drift = np.zeros_like(offset)
        self.rate = self._since = 0.0
        self._fades = self._fading()

    def _fading(self) -> float:
        """Returns the time in which the motion before fades [s]."""
        fades = 4 * np.abs(self._drift) / self._acceleration
        shifts = np.sqrt(6 * np.abs(self._offset) / self._acceleration)
        return max(_SHORTEST, float(fades.max()), float(shifts.max()))

    def position(self, ahead: float = 0.0) -> Matrix:
        """Returns the joints [dof] now, or `ahead` seconds from now."""
        return self._at(self.clock + ahead)[1] + self._left(ahead)

    def place(self, ahead: float = 0.0) -> Matrix:
        """Returns the planned place [3] of the object now, or `ahead` seconds from now."""
        row = self._at(self.clock + ahead)[0]
        before = min(int(row), len(self.places) - 1)
        after, t = min(before + 1, len(self.places) - 1), row - before
        a, b = self.places[before], self.places[after]
        mixed: Matrix = a + t * plane.difference(a, b)
        return mixed

    @property
    def left(self) -> float:
        """Distance that the object still has to move [m]."""
        return float(np.linalg.norm(self.places[-1][:2] - self.place()[:2]))

    def _left(self, ahead: float) -> Matrix:
        """Returns what is left of the motion before: a cubic that ends in rest."""
        since = max(0.0, self._since + ahead)
        x = since / self._fades
        if x >= 1 or not self.differs:
            return np.zeros_like(self._offset)
        offset = self._offset * (1 - x) ** 2 * (1 + 2 * x)
        left: Matrix = offset + self._drift * since * (1 - x) ** 2
        return left

    def _at(self, t: float) -> tuple[float, Matrix]:
        """Returns row and joints [dof] at a time [s]. Most calls are for the time of the last."""
        if self._now[0] != t:
            self._now = t, self._timed.now(t)
        return self._now[1]


def limits_of(
    robot: Robot,
    max_velocity: PerJoint | None,
    max_acceleration: PerJoint | None,
    max_jerk: PerJoint | None,
    contact_speed: float | None,
) -> Settings:
    """Returns the limits of a robot's motions, as `graspless.time` does."""
    velocity, acceleration, jerk = settings.joint_limits(
        robot, max_velocity, max_acceleration, max_jerk
    )
    if contact_speed is not None:
        contact_speed = settings.require_positive("contact_speed", contact_speed)
    velocity = _SHARE * velocity
    return settings.Settings(
        robot, velocity, acceleration, jerk, contact_speed, Rate(_UNUSED), settings.PAUSE
    )


def goes_on(segment: Any, velocity: Matrix) -> bool:
    """Returns True if a motion at `velocity` [dof] can go over into a segment without rest."""
    speed = float(np.linalg.norm(velocity))
    rows = np.asarray(segment.positions)
    ways = rows - rows[0]
    moved = np.linalg.norm(ways, axis=1)
    if speed < 1e-6 or moved.max() < 1e-9:
        return speed < 1e-6
    first = ways[int(np.argmax(moved > 1e-9))]
    return float(velocity @ first) >= STRAIGHT * speed * float(np.linalg.norm(first))
