# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""World that is simulated in place of the one that a plan knows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ... import frames

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...frames import Matrix


@dataclass(frozen=True)
class Body:
    """A body of convex parts, in a frame of its own or in the world.

    Attributes
    ----------
    parts : list of array [N, 3]
        Points whose convex hulls are its parts [m].
    mass : float
        [kg].
    com : array [3]
        Centre of mass [m].
    inertia : array [3, 3]
        About the centre of mass, in the axes of the frame [kg m^2].
    """

    parts: list[Matrix]
    mass: float
    com: Matrix
    inertia: Matrix

    def moved(self, X_AB: Matrix) -> Body:
        """Returns the body, given in B, in A."""
        R = X_AB[:3, :3]
        parts = [frames.transform(X_AB, points) for points in self.parts]
        com = frames.transform(X_AB, self.com[None])[0]
        return Body(parts, self.mass, com, R @ self.inertia @ R.T)


@dataclass(frozen=True)
class Truth:
    """World that is simulated in place of the one that the plan knows; the support stays.

    Attributes
    ----------
    object : Body
        In O.
    others : sequence of Body
        Bodies that stand around the object, in W. They can be pushed and knocked over, and are in
        place of the obstacles of the task.
    """

    object: Body
    others: Sequence[Body] = ()
