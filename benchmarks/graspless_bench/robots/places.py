# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Places of a table at which an arm can press on an object and grasp it at an edge."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from graspless import frames, geometry, robot, scene, slide

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from graspless.frames import Matrix
    from graspless.inspection import Proposal

TABLE = (0.4, 0.5)  # size away from the robot and across [m]
SLAB = 0.04  # thickness of the table top [m]


class Place(NamedTuple):
    """Table relative to the hand at home; lengths are scaled with the robot [m].

    Attributes
    ----------
    out, side : float
        Middle of the table away from the robot, and to its left.
    below : float
        Height of the hand above the top.
    size : float
        Scale of the table and of the object on it.
    """

    out: float
    below: float
    side: float = 0.0
    size: float = 1.0


# Tried first, in this order.
IN_FRONT = tuple(
    Place(*place)
    for place in ((0.08, 0.25), (0.16, 0.25), (0.0, 0.1), (0.16, 0.1), (0.08, 0.4), (0.24, 0.4))
)
AROUND = tuple(
    Place(out, below, side, size)
    for size, out, side, below in itertools.product(
        (1.0, 0.6),
        (-0.1, 0.05, 0.2, 0.35, 0.5),
        (0.0, -0.3, 0.3),
        (0.05, -0.1, 0.1, -0.2, 0.2, -0.3, 0.3, -0.4),
    )
)
TRIED = 8  # of AROUND


def in_reach(
    found: Proposal, pose: Callable[[Place], Matrix], scale: float, thickness: float
) -> list[Place]:
    """Returns the best places of AROUND at which the robot at home is free.

    A place is good if the finger can press at many points of the table and the hand can grasp at
    many of its edges, by inverse kinematics alone.

    Parameters
    ----------
    found : Proposal
        Robot with a hand for slides.
    pose : function
        Pose X_WS of the table's top at a place.
    scale : float
        Of the table at a place of size 1.
    thickness : float
        Of the object [m].
    """
    reach = _Reach(found, thickness)
    rated: list[tuple[int, int, Place]] = []
    for place in AROUND:
        a, b = (length * scale * place.size / 2 for length in TABLE)
        X_WS = pose(place)
        rating = reach.pressed(X_WS, a, b) * reach.grasped(X_WS, a, b)
        if rating and not _is_home_blocked(found.robot, X_WS, a, b):
            rated.append((-rating, len(rated), place))
    return [place for *_, place in sorted(rated)[:TRIED]]


class _Reach:
    """Inverse kinematics of the fingertip and of the grasp frame."""

    def __init__(self, found: Proposal, thickness: float) -> None:
        self._q = found.robot.state("home")
        self._tip, self._grasp = (
            robot.Ik(found.robot, found.hand[frame], found.hand["arm"], restarts=2, free_samples=8)
            for frame in ("fingertip", "grasp_frame")
        )
        self._pitch = found.hand.get("pitch", slide.Options().pitch)
        self._thickness = thickness

    def pressed(self, X_WS: Matrix, a: float, b: float) -> int:
        """Number of points, of nine on the table, at which the finger presses at some heading."""
        points = itertools.product((-0.6 * a, 0.0, 0.6 * a), (-0.6 * b, 0.0, 0.6 * b))
        return sum(self._presses(X_WS, x, y) for x, y in points)

    def grasped(self, X_WS: Matrix, a: float, b: float) -> int:
        """Number of edges at which the hand grasps what sticks out."""
        return sum(
            any(self._reaches(self._grasp, X_WS @ X_SH) for X_SH in self._grasps(k, a, b))
            for k in range(4)
        )

    def _presses(self, X_WS: Matrix, x: float, y: float) -> bool:
        for k in range(8):
            # Heading along X, the other finger up.
            X_SF = frames.planar(x, y, k * math.pi / 4)
            c, s = math.cos(self._pitch), math.sin(self._pitch)
            X_SF[:3, :3] = X_SF[:3, :3] @ np.array([[0, s, c], [1, 0, 0], [0, c, -s]])
            X_SF[2, 3] = self._thickness
            if self._reaches(self._tip, X_WS @ X_SF):
                return True
        return False

    def _grasps(self, k: int, a: float, b: float) -> Iterator[Matrix]:
        """Poses of the level hand outside of edge k, either way up."""
        inwards = frames.planar(0.0, 0.0, k * math.pi / 2)
        across, along = (a, b) if k % 2 == 0 else (b, a)
        for up, at in itertools.product((1, -1), (-0.5, 0.0, 0.5)):
            X_SH = inwards @ frames.translation([-across - 0.02, at * along, self._thickness / 2])
            X_SH[:3, :3] = X_SH[:3, :3] @ np.array([[0, 0, 1], [up, 0, 0], [0, up, 0]])
            yield np.asarray(X_SH)

    def _reaches(self, ik: robot.Ik, X_WF: Matrix) -> bool:
        return len(ik.solve_all(X_WF, self._q)) > 0


def _is_home_blocked(arm: robot.Robot, X_WS: Matrix, a: float, b: float) -> bool:
    made = scene.Scene(arm)
    top = geometry.PlacedShape(geometry.Box([2 * a, 2 * b, SLAB]), np.eye(4))
    made.add_obstacle("table", [top], X_WS @ frames.translation([0.0, 0.0, -SLAB / 2]))
    return made.collision(arm.state("home")) is not None
