# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Collisions of motions that deviate from the plan: shifted paths, and lifting off."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import slide
from . import plane
from .deviation import IN_CONTACT

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..slide import Plan
    from .correction import Correction
    from .deviation import Deviation
    from .hand import Hand


class Guard:
    """Tests robot and object against support and obstacles, and the robot against itself."""

    def __init__(self, plan: Plan, hand: Hand) -> None:
        problem = plan.task.problem
        self._surroundings = slide.Surroundings(problem, plan.task.options)
        self._hand = hand
        self._polygon, self._com = problem.support.polygon, np.append(problem.object.com, 1.0)

    def touching(self, phase: str, q: Matrix, place: Matrix, height: float = 0.0) -> str:
        """Returns a pair that touches, "a - b", or an empty text.

        q [dof] is in the segment `phase`. The object is at a place [3] of the support, which is
        `height` higher than planned [m].
        """
        X_WO = self._hand.pose(place)
        X_WO[:3, 3] += height * self._hand.X_WS[:3, 2]
        return next(iter(self._surroundings.touching(phase, q, X_WO, height)), "")

    def ahead(self, deviation: Deviation, correction: Correction, seconds: float) -> str:
        """Returns a pair that touches `seconds` later, or an empty text; also without a shift.

        Less than `seconds` after the start of a segment, it looks ahead by the time that has
        passed, so that calls at successive times see all of the path. The correction goes on as
        it moves now.
        """
        course = deviation.course
        if not (np.any(correction.motion) or correction.height or course.differs):
            return ""
        later = min(seconds, course.clock)
        motion = correction.ahead(later, deviation.pivot)
        q = self._hand.shifted(course.position(later), motion, correction.height)
        moves = course.name in IN_CONTACT
        place = plane.compose(motion, course.place(later)) if moves else deviation.place
        return self.touching(course.name, q, place, correction.height)

    def falls(self, place: Matrix) -> bool:
        """Returns True if an object at a place [3] falls when the finger leaves it.

        Its centre of mass, projected along gravity, is beyond the support's edge.
        """
        com = (self._hand.X_SW @ self._hand.pose(place) @ self._com)[:3]
        up = self._hand.X_WS[2, :3]
        foot = com - up * (com[2] / up[2])
        return float(self._polygon.depth(foot[:2])) < 0

    def free_part(self, phase: str, path: Matrix, place: Matrix) -> Matrix:
        """Returns the rows [N, dof] of a path up to the first that touches, two at least.

        A path that touches at once stays at its first row.
        """
        touches = (bool(self.touching(phase, q, place)) for q in path[1:])
        free = 1 + next((k for k, touch in enumerate(touches) if touch), len(path) - 1)
        return path[:free] if free > 1 else np.array([path[0], path[0]])
