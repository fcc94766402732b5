# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Round ends of a hand's fingers, with which it moves objects without grasping them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import geometry

if TYPE_CHECKING:
    from collections.abc import Iterator

    from .. import robot as robots
    from ..frames import Matrix

SAME = 1e-4  # distance of a frame from the centre of a round end [m]
EQUAL = 1e-3  # difference of the radii of two fingertips [m]


@dataclass(frozen=True)
class Fingertips:
    """Round ends of two fingers.

    Attributes
    ----------
    frames : list of str
        Frames at their centres.
    links : list of str
        Finger of each.
    radius : float
        [m].
    apart : float
        Distance of the centres when the hand is open [m].
    """

    frames: list[str]
    links: list[str]
    radius: float
    apart: float


def fingertips_of(problem: Any) -> Fingertips | str:
    """Returns the fingertips of the hand of a pinch, or what it lacks."""
    robot, hand = problem.robot, problem.hand
    if len(hand.fingers) != 2:
        return f"the hand has {len(hand.fingers)} links that close; fingertips of two are needed"
    q = np.asarray(robot.state(hand.open, problem.q_home))
    out = np.asarray(robot.pose(hand.grasp_frame, q))[:3, 2]
    frames, centres, radii = [], [], []
    for link in hand.fingers:
        ends = list(_round_ends(robot, link, q))
        if not ends:
            return f"'{link}' has no sphere or capsule as a round end"
        centre, radius = max(ends, key=lambda end: float(end[0] @ out))
        frame = _frame_at(robot, link, centre, q)
        if frame is None:
            return f"the robot has no frame at the centre of the round end of '{link}'"
        frames.append(frame)
        centres.append(centre)
        radii.append(radius)
    if abs(radii[1] - radii[0]) > EQUAL:
        return f"its fingertips have radii of {1000 * radii[0]:.1f} and {1000 * radii[1]:.1f} mm"
    apart = float(np.linalg.norm(centres[1] - centres[0]))
    return Fingertips(frames, list(hand.fingers), max(radii), apart)


def _round_ends(robot: robots.Robot, link: str, q: Matrix) -> Iterator[tuple[Matrix, float]]:
    """Yields centres in the world and radii of the spheres and ends of capsules of a link [m]."""
    index = robot.frame(link)
    X_WL = np.asarray(robot.pose(index, q))
    for body, placed in robot.shapes:
        if body != index:
            continue
        X_WG = X_WL @ np.asarray(placed.X_BG)
        if isinstance(placed.shape, geometry.Sphere):
            yield X_WG[:3, 3], float(placed.shape.radius)
        elif isinstance(placed.shape, geometry.Capsule):
            half = float(placed.shape.length) / 2
            for end in (-half, half):
                yield X_WG[:3, 3] + end * X_WG[:3, 2], float(placed.shape.radius)


def _frame_at(robot: robots.Robot, link: str, p_W: Matrix, q: Matrix) -> str | None:
    """Returns a frame that is fixed in a link at a point, or None."""
    index = robot.frame(link)
    for k, name in enumerate(robot.frame_names):
        is_fixed = k == index or int(robot.parent(k)) == index
        if is_fixed and np.linalg.norm(np.asarray(robot.pose(k, q))[:3, 3] - p_W) < SAME:
            return str(name)
    return None
