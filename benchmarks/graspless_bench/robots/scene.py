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

if TYPE_CHECKING:
    from graspless.frames import Matrix
    from graspless.inspection import Proposal

TABLE = (0.4, 0.5)  # away from the robot and across, if the hand is FAR from its base or more [m]
FAR = 0.56  # [m]
# Places of the table, of which the first is taken where a slide is solved: of its middle outwards
# from the hand at home, and of its top below that [m].
PLACES = ((0.08, 0.25), (0.16, 0.25), (0.0, 0.1), (0.16, 0.1), (0.08, 0.4), (0.24, 0.4))
ABOVE = 0.1  # of the hand over the handle [m]
CARD = (0.10, 0.06)  # size of the thin object [m]
SMALLEST_CARD = 0.5  # scale of the object of a small robot
THICKNESS = 0.003  # of the object, if the hand closes that far [m]
GRIPPED = 1.5  # thickness over the distance between the closed fingers
HANDLE = 0.29  # height of the purse's handle [m]


class Scene:
    """Table near the hand at home. Small arms get a smaller one.

    Attributes
    ----------
    scale : float
        Of lengths, at most 1.
    thickness : float
        Of the object [m].
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
        self.place = PLACES[0]
        self.thickness = max(THICKNESS, math.ceil(1000 * GRIPPED * found.smallest_gap) / 1000)
        self.thickness = min(self.thickness, min(self.card()) / 2)

    def card(self) -> list[float]:
        """Size of the thin object [m]."""
        return [length * max(SMALLEST_CARD, self.scale) for length in CARD]

    def support(self) -> Matrix:
        """Pose X_WS of the table's top."""
        turned = frames.planar(float(self.home[0]), float(self.home[1]), self.yaw)
        out, below = self.place
        down = [out * self.scale, 0.0, self.home[2] - below * self.scale]
        return np.asarray(turned @ frames.translation(down))

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
                "rectangle": {"size": [length * self.scale for length in TABLE]},
                "pose": {"position": X_WS[:3, 3].tolist(), "rpy": [0.0, 0.0, self.yaw]},
            },
            "budget": {"seconds": seconds},
        }

    def poses(self, name: str, runs: int) -> list[Matrix]:
        """Returns poses of the object in S, uniform over those with the whole object on it."""
        rng = random.Random(name)  # the same numbers on any Python
        size = [length * self.scale for length in TABLE]
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
