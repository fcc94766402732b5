# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks in front of a robot, placed by its proposed home and size."""

from __future__ import annotations

import math
import random
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import frames
from graspless.inspection.tree import Tree

from .places import IN_FRONT, TABLE, Place, in_reach

if TYPE_CHECKING:
    from collections.abc import Iterator

    from graspless.frames import Matrix
    from graspless.inspection import Proposal

FAR = 0.56  # distance of the hand from its base from which on the table is not scaled [m]
ABOVE = 0.1  # of the hand over the handle [m]
CARD = (0.10, 0.06)  # size of the thin object [m]
# Scale of the object of a small robot. At 0.5 it would fall before it sticks out by min_overhang.
SMALLEST_CARD = 0.75
THICKNESS = 0.003  # of the object, if the hand closes that far [m]
GRIPPED = 1.5  # thickness over the distance between the closed fingers
HANDLE = 0.29  # height of the purse's handle [m]


class Scene:
    """Table near the hand at home. Small arms get a smaller one.

    Attributes
    ----------
    scale : float
        Of lengths, at most 1.
    place : Place
        Where the table is.
    gap : float
        Distance between the closed fingers [m].
    """

    def __init__(self, found: Proposal, urdf: str) -> None:
        robot, self.urdf = found.robot, urdf
        q = robot.state("home")
        frame = found.hand["grasp_frame"] if found.hand else found.clasp["frame"]
        p_WH, p_WB = (np.asarray(robot.pose(link, q))[:3, 3] for link in (frame, _base(robot)))
        away = (p_WH - p_WB)[:2]
        self.distance = float(np.linalg.norm(p_WH - p_WB))
        self.scale = min(1.0, self.distance / FAR)
        self.home = p_WH
        self.yaw = math.atan2(away[1], away[0])
        self.lowest = float(_cloud(robot, found.hand_links, q)[:, 2].min())
        self.place = IN_FRONT[0]
        self.gap = found.smallest_gap
        self._found = found

    @property
    def thickness(self) -> float:
        """Thickness of the object [m]."""
        gripped = math.ceil(1000 * GRIPPED * self.gap) / 1000
        return min(max(THICKNESS, gripped), min(self.card()) / 2)

    def too_thin(self) -> str:
        """Reason why no object of this size can be gripped."""
        return (
            f"the fingers' shapes touch while their tips are still {self.gap * 1000:.1f} mm apart, "
            f"and an object that is {min(self.card()) * 1000:.0f} mm wide can be "
            f"{self.thickness * 1000:.0f} mm thick at most"
        )

    def card(self) -> list[float]:
        """Size of the thin object [m]."""
        return [length * max(SMALLEST_CARD, self.scale * self.place.size) for length in CARD]

    def table(self) -> list[float]:
        """Size of the table [m]."""
        return [length * self.scale * self.place.size for length in TABLE]

    def places(self) -> Iterator[Place]:
        """Places to try the table at: in front of the robot, then where the arm reaches."""
        yield from IN_FRONT
        yield from in_reach(self._found, self.support, self.scale, self.thickness)

    def support(self, place: Place | None = None) -> Matrix:
        """Pose X_WS of the table's top, by default at the scene's place."""
        place = place or self.place
        turned = frames.planar(float(self.home[0]), float(self.home[1]), self.yaw)
        p = np.array([place.out, place.side, -place.below]) * self.scale
        return np.asarray(turned @ frames.translation(p + [0.0, 0.0, self.home[2]]))

    def slide(self, seconds: float) -> dict[str, Any]:
        """Returns the task of a slide; poses() has the poses of its object in S."""
        X_WS = self.support()
        return {
            "kind": "slide",
            "robot": {"urdf": self.urdf},
            "object": {
                "rectangle": {"size": self.card()},
                "thickness": self.thickness,
                "pose": {"x": 0.0, "y": 0.0, "yaw": 0.0},
            },
            "support": {
                "rectangle": {"size": self.table()},
                "pose": {"position": X_WS[:3, 3].tolist(), "rpy": [0.0, 0.0, self.yaw]},
            },
            "budget": {"seconds": seconds},
        }

    def poses(self, name: str, runs: int) -> list[Matrix]:
        """Returns poses of the object in S, uniform over those with the whole object on it."""
        rng = random.Random(name)  # the same numbers on any Python
        size = self.table()
        a, b = (length / 2 for length in self.card())
        found: list[Matrix] = []
        while len(found) < runs:
            x, y = ((rng.random() - 0.5) * length for length in size)
            yaw = 2 * math.pi * rng.random()
            c, s = abs(math.cos(yaw)), abs(math.sin(yaw))
            if abs(x) + a * c + b * s < size[0] / 2 and abs(y) + a * s + b * c < size[1] / 2:
                found.append(np.asarray(frames.planar(x, y, yaw)))
        return found

    def clasp(self, seconds: float, number: int) -> dict[str, Any]:
        """Returns the task of a clasp: a purse under the hand, turned from number to number."""
        at = [*self.home[:2], self.lowest - (HANDLE + ABOVE) * self.scale]
        return {
            "kind": "clasp",
            "robot": {"urdf": self.urdf},
            "object": {
                "sample": "purse",
                "scale": self.scale,
                "pose": {"position": [float(x) for x in at], "rpy": [0.0, 0.0, self.yaw + number]},
            },
            "budget": {"seconds": seconds, "seed": number + 1},
        }


def _cloud(robot: Any, links: tuple[str, ...], q: Matrix) -> Matrix:
    """Points on the collision shapes of links; (N, 3) in W [m]."""
    tree = Tree(robot)
    return tree.cloud([robot.frame(link) for link in links], tree.poses(q))


def _base(robot: Any) -> str:
    """Name of the link that carries the first joint of the arm."""
    first = min(robot.group("arm"))
    q = np.asarray(robot.clamp(np.zeros(robot.dof)))
    turned = q.copy()
    turned[first] = (robot.lower[first] + robot.upper[first]) / 2 + 0.1
    moved = next(
        i
        for i, link in enumerate(robot.frame_names)
        if not np.allclose(robot.pose(link, q), robot.pose(link, turned))
    )
    return str(robot.frame_names[robot.parent(moved)])
