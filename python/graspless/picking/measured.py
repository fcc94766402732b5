# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans on a prism, compared with the heights that the camera measured."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from ..frames import Matrix
    from .wish import Wish

PRESS_LOWER = 0.004  # below the top, where a finger presses: a quarter of its flexing is lost [m]
PINCH_LOWER = 0.002  # below the fingers' contacts: pads reach lower [m]
GRIP_LOWER = 0.006  # below the top, where a hand closes: its middle is half of that too high [m]
LEAST_NEAR = 0.01  # radius in which heights are looked at, at least [m]
LEAST_POINTS = 3
HIGHEST = 0.9  # quantile of the heights between fingers: a wall is enough to close on


def doubt(plan: Any, wish: Wish) -> str:
    """Says why the first stage of a chain misses the object as it was measured, or nothing.

    A slide needs the measured height where the finger presses. Plans that take the object for a
    prism also need it where the hand closes: a slide the whole height, a pinch that of the fingers.
    """
    stage = plan.stages[0]
    if stage.kind == "slide":
        return _doubt_slide(stage, wish)
    if stage.kind == "pinch" and stage.task.problem.object.heights is None:
        return _doubt_pinch(stage, wish)
    return ""


def _doubt_slide(stage: Any, wish: Wish) -> str:
    hand, thing = stage.task.problem.hand, stage.task.problem.object
    near = max(LEAST_NEAR, float(hand.pad_width) / 2)
    top = float(thing.top)
    slide = next(segment for segment in stage.segments if segment.name == "slide")
    places = [
        ("the finger presses", hand.fingertip, slide, 0, PRESS_LOWER),
        ("the hand closes", hand.grasp_frame, stage.segments[-1], -1, GRIP_LOWER),
    ]
    for what, frame, segment, row, lower in places[: 1 if thing.heights is not None else None]:
        place = _place(stage, frame, segment, row)
        height = height_at(wish, place, near)
        if height is None:
            return f"nobody saw the top where {what}"
        if height < top - lower:
            return (
                f"where {what}, it is {1000 * height:.0f} mm high, its top {1000 * top:.0f} mm: at "
                f"most {1000 * lower:.0f} mm lower is allowed"
            )
    return ""


def _doubt_pinch(stage: Any, wish: Wish) -> str:
    contacts = np.asarray(stage.contacts_O)
    middle, level = contacts.mean(axis=0)[:2], float(contacts[0, 2])
    near = max(LEAST_NEAR, float(np.linalg.norm(contacts[1] - contacts[0])) / 2)
    height = height_at(wish, middle, near, HIGHEST)
    if height is None:
        return "nobody saw the top between the fingers"
    if height < level - PINCH_LOWER:
        return (
            f"the fingers close {1000 * level:.0f} mm over the support, where the object is "
            f"{1000 * height:.0f} mm high"
        )
    return ""


def _place(stage: Any, frame: str, segment: Any, row: int) -> Matrix:
    """Returns where a frame of the robot is in O at a row of a motion, seen from above (2,) [m]."""
    robot = stage.task.problem.robot
    X_WF = np.asarray(robot.pose(robot.frame(frame), segment.positions[row]))
    X_OF: Matrix = np.linalg.inv(np.asarray(segment.object_poses[row])) @ X_WF
    place: Matrix = X_OF[:2, 3]
    return place


def height_at(wish: Wish, place: Matrix, near: float, quantile: float = 0.5) -> float | None:
    """Returns a quantile of the heights near a place, or None if too few points were seen [m]."""
    points = np.asarray(wish.thing.points)
    heights = points[np.linalg.norm(points[:, :2] - place, axis=1) < near][:, 2]
    return float(np.quantile(heights, quantile)) if len(heights) >= LEAST_POINTS else None
