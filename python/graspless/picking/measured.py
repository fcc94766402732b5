# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures of the points that the cameras saw, and plans on a prism compared with them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import geometry

if TYPE_CHECKING:
    from ..frames import Matrix
    from .wish import Wish

PRESS_LOWER = 0.004  # below the top, where a finger presses: a quarter of its flexing is lost [m]
PINCH_LOWER = 0.002  # below the fingers' contacts: pads reach lower [m]
GRIP_LOWER = 0.006  # below the top, where a hand closes: its middle is half of that too high [m]
LEAST_NEAR = 0.01  # radius in which heights are looked at, at least [m]
LEAST_POINTS = 3
HIGHEST = 0.9  # quantile of the heights between fingers: a wall is enough to close on
NEAR = 0.012  # a point of the side is seen if a point of the cloud is as near [m]
MOST = 2000  # points that are compared
SPACING = 0.005  # between points of the outline [m]
HOLLOW = 0.004  # below the top of what is flat [m]
CELL = 0.006  # between points at which the height is looked at [m]


def doubt(plan: Any, wish: Wish) -> str:
    """Says why the first stage of a chain, or a slide at its end, misses the object as it was
    measured, or why the fingers of a slide do not bear it; or nothing.

    A slide needs the measured height where the finger presses. Plans that take the object for a
    prism also need the height where the hand closes: a slide the whole height, a pinch that of the
    fingers.
    """
    stage = plan.stages[-1]
    if stage.kind != "slide":
        stage = plan.stages[0]
    doubted = ""
    if stage.kind == "slide":
        doubted = _doubt_slide(stage, wish)
    elif stage.kind == "pinch" and stage.task.problem.object.heights is None:
        doubted = _doubt_pinch(stage, wish)
    return doubted or _too_heavy(plan, wish)


def _doubt_slide(stage: Any, wish: Wish) -> str:
    hand, thing = stage.task.problem.hand, stage.task.problem.object
    bears = 1 - float(stage.task.options.pad_spread)
    near = max(LEAST_NEAR, bears * float(hand.pad_width) / 2)
    top = float(thing.top)
    slide = next(segment for segment in stage.segments if segment.name == "slide")
    places = [
        ("the finger presses", hand.fingertip, slide, 0, PRESS_LOWER),
        ("the hand closes", hand.grasp_frame, stage.segments[-1], -1, GRIP_LOWER),
    ]
    is_left = stage.task.problem.X_WO_end is not None
    for what, frame, segment, row, lower in places[: 1 if thing.heights or is_left else None]:
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


def _too_heavy(plan: Any, wish: Wish) -> str:
    """Says that the fingers do not bear the object where a slide ends; or nothing."""
    borne = [stage.max_mass for stage in plan.stages if stage.kind == "slide"]
    least = min((mass for mass in borne if mass is not None), default=np.inf)
    if wish.mass is None or wish.mass <= least:
        return ""
    what = f"the fingers bear {least:.3f} kg; it weighs {wish.mass:.3f} kg"
    return f"where the hand grasps it, {what}"


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


def top_share(wish: Wish) -> float:
    """Returns the part of the outline over which the object is as high as its top, from 0 to 1."""
    cells = np.asarray(geometry.sample_grid(wish.outline, CELL))
    points = np.asarray(wish.thing.points)
    high = points[points[:, 2] > float(wish.thing.thickness) - HOLLOW][:, :2]
    if not len(high) or not len(cells):
        return 0.0
    known = {tuple(cell) for cell in np.round(high / CELL).astype(int)}
    around = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
    at = np.round(cells / CELL).astype(int)
    seen = [any((x + i, y + j) in known for i, j in around) for x, y in at]
    return float(np.mean(seen))


def unseen_share(wish: Wish) -> float:
    """Returns the part of the object's side near which no point was seen, from 0 to 1.

    The side is the outline, half way between the support and the top.
    """
    ring = np.asarray(wish.thing.outline)
    pieces = []
    for a, b in zip(ring, np.roll(ring, -1, axis=0), strict=True):
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / SPACING)))
        pieces.append(a + (b - a) * (np.arange(count)[:, None] + 0.5) / count)
    along = np.concatenate(pieces)
    points, height = np.asarray(wish.thing.points), float(wish.thing.thickness)
    middle = points[(points[:, 2] > 0.2 * height) & (points[:, 2] < 0.8 * height)]
    if not len(middle):
        return 1.0
    every = max(1, len(middle) // MOST)
    away = np.linalg.norm(along[:, None] - middle[None, ::every, :2], axis=2).min(axis=1)
    return float(np.mean(away > NEAR))
