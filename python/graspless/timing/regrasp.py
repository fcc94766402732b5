# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of a regrasp: a fingertip without an arm moves to another contact.

Three parts, each from rest to rest and a third of a row long: it leaves along the contact's normal
by twice its radius, it moves to as far above its new place, and it touches.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .clip import Clip, clip, joined
from .limits import Limits, Zone
from .settings import FINGERTIP_SPEED, FREE_FINGER_ACCELERATION, FREE_FINGER_SPEED

if TYPE_CHECKING:
    from ..fingertip import Plan
    from ..frames import Matrix
    from .rates import Rate
    from .settings import Settings


def regrasp(plan: Plan, index: int, settings: Settings) -> Clip:
    """Times the regrasp in segment `index`: rows from 0 to 1, without coordinates."""
    clearance = 2 * plan.task.problem.fingers.radius
    slow, free = settings.speed(FINGERTIP_SPEED), FREE_FINGER_SPEED
    parts = [
        _part(i, distance, speed, settings.rate)
        for i, (distance, speed) in enumerate(
            [(clearance, slow), (_distance(plan, index) + clearance, free), (clearance, slow)]
        )
    ]
    whole = joined(parts)
    nothing = np.zeros((len(whole.times), 0))
    return Clip(whole.times, whole.rows, nothing, nothing, nothing)


def _part(i: int, distance: float, speed: float, rate: Rate) -> Clip:
    limits = Limits(np.array([speed]), np.array([FREE_FINGER_ACCELERATION]), np.array([np.inf]))
    points = np.array([[0.0], [distance]])
    timed = clip(points, [Zone(slice(0, 2), limits, np.array([1.0]))], rate)
    return Clip(
        timed.times,
        (i + timed.rows) / 3,
        timed.coordinates,
        timed.velocities,
        timed.accelerations,
    )


def _distance(plan: Plan, index: int) -> float:
    """Returns the distance between the two contacts plus the size of the object [m]."""
    finger = plan.segments[index].finger
    old = _seen(plan, finger, range(index - 1, -1, -1), -1)
    new = _seen(plan, finger, range(index + 1, len(plan.segments)), 0)
    size = float(plan.task.problem.object.size)
    if old is None or new is None:  # a finger that is not needed before, or after
        return size
    return float(np.linalg.norm(new - old)) + size


def _seen(plan: Plan, finger: int, segments: range, row: int) -> Matrix | None:
    """Returns the contact point [3] in O of a finger in the first segment where it touches."""
    for i in segments:
        point: Matrix = plan.segments[i].fingers[row, finger]
        if np.isfinite(point).all():
            return point
    return None
