# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Motions of a block by fingertips after which a hand may grasp it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames, geometry
from ..tasks.statement import pose_fields
from .block import SPACING, Block
from .wish import dense

if TYPE_CHECKING:
    from collections.abc import Callable

    from ..frames import Matrix
    from .wish import Wish

SEGMENTS = 18  # of a tumble: 5 degrees each
STEP = 0.01  # of a slide [m]
TURN_STEP = 0.0873  # [rad]
DISTANCES = (0.04, 0.08, 0.12, 0.16, 0.2)  # of slides [m]
DIRECTIONS = 8  # of slides, the first towards the robot
TURNS = (np.pi / 4, -np.pi / 4, np.pi / 2)  # about the vertical [rad]
WITHIN = 0.005  # least distance of a footprint from the edge of its support [m]
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True)
class Move:
    """A motion of a block by fingertips.

    Attributes
    ----------
    words : str
        Description, for messages.
    motion : dict
        Field `motion` of a fingertip task.
    goal : Block
        The block at its end.
    """

    words: str
    motion: dict[str, Any]
    goal: Block


def tumbles(block: Block, base: Matrix) -> list[Move]:
    """Returns the tumbles over its four edges: the lowest goal first, then the nearest to `base`.

    `base` is the place of the robot's base in the world, seen from above [2].
    """
    X_WB = np.asarray(block.X_WB)
    below = X_WB[:3, 3] - block.height / 2 * UP
    found = []
    for k in block.across:
        for sign in (1.0, -1.0):
            outward = sign * X_WB[:3, k]
            point, axis = below + block.size[k] / 2 * outward, np.cross(UP, outward)
            tumble = {
                "pose": pose_fields(X_WB),
                "point": [float(value) for value in point],
                "axis": [float(value) for value in axis],
                "angle": np.pi / 2,
                "segments": SEGMENTS,
            }
            goal = block.moved(_turn(point, axis, np.pi / 2))
            found.append(Move(_towards("tumbled", outward), {"tumble": tumble}, goal))
    return sorted(found, key=lambda move: (round(move.goal.height, 3), _away(move.goal, base)))


def pushes(block: Block, base: Matrix) -> list[Move]:
    """Returns slides and turns on the support: the shortest first, then the nearest to `base`."""
    X_WB = np.asarray(block.X_WB)
    inward = np.asarray(base) - X_WB[:2, 3]
    start = float(np.arctan2(inward[1], inward[0]))
    found: list[tuple[float, Move]] = []
    for distance in DISTANCES:
        for k in range(DIRECTIONS):
            angle = start + 2 * np.pi * k / DIRECTIONS
            along = distance * np.array([np.cos(angle), np.sin(angle), 0.0])
            count = int(np.ceil(distance / STEP))
            translation = [float(value) for value in along]
            slide = {"pose": pose_fields(X_WB), "translation": translation, "segments": count}
            words = _towards(f"pushed {100 * distance:.0f} cm", along)
            goal = block.moved(frames.translation(translation))
            found.append((distance, Move(words, {"slide": slide}, goal)))
    radius = float(np.linalg.norm(block.sides)) / 2
    for angle in TURNS:
        count = int(np.ceil(abs(angle) / TURN_STEP))
        turn = {"pose": pose_fields(X_WB), "angle": float(angle), "segments": count}
        words = f"turned by {np.degrees(angle):.0f} deg"
        goal = block.moved(_turn(X_WB[:3, 3], UP, float(angle)))
        found.append((radius * abs(angle), Move(words, {"turn": turn}, goal)))
    found.sort(key=lambda one: (one[0], _away(one[1].goal, base)))
    return [move for _, move in found]


MOVES: dict[str, Callable[[Block, Matrix], list[Move]]] = {"tumble": tumbles, "push": pushes}


def misplaced(move: Move, wish: Wish) -> str:
    """Says why the block cannot stand where a motion ends, or nothing.

    `wish` has a level support.
    """
    X_SW = np.linalg.inv(wish.support.X_WS)
    corners = move.goal.corners @ X_SW[:2, :2].T + X_SW[:2, 3]
    depths = [float(geometry.Polygon(wish.support.polygon).depth(p)) for p in corners]
    if min(depths) < WITHIN:
        return f"a corner would be {_edge(min(depths))} the edge of {wish.support.name}"
    own = geometry.Polygon(move.goal.corners)
    for other in wish.others:
        if other.support != wish.support.name:
            continue
        X_WO = np.asarray(other.X_WO)
        ring = np.asarray(other.outline) @ X_WO[:2, :2].T + X_WO[:2, 3]
        near = any(own.contains(p) or own.depth(p) > -wish.room for p in dense(ring, SPACING))
        if near or geometry.Polygon(ring).contains(move.goal.corners[0]):
            return f"'{other.name}' is there"
    return ""


def _edge(depth: float) -> str:
    return f"{1000 * abs(depth):.0f} mm {'beyond' if depth < 0 else 'from'}"


def _turn(point: Matrix, axis: Matrix, angle: float) -> Matrix:
    """(4, 4) rotation of the world's points about an axis through a point."""
    X = frames.from_quaternion([np.cos(angle / 2), *(np.sin(angle / 2) * axis)])
    X[:3, 3] = point - X[:3, :3] @ point
    return X


def _towards(what: str, along: Matrix) -> str:
    return f"{what} towards {np.degrees(np.arctan2(along[1], along[0])):.0f} deg"


def _away(goal: Block, base: Matrix) -> float:
    return float(np.linalg.norm(np.asarray(goal.X_WB)[:2, 3] - base))
