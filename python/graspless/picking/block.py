# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""An object of a scene as a block that fingertips can move."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

import numpy as np

from .. import frames, geometry, perception
from .wish import dense

if TYPE_CHECKING:
    from ..frames import Matrix
    from .wish import Wish

MOST_OFF = 0.006  # of what was seen from the block's surface [m]
OUTLINE_QUANTILE = 0.9  # of the outline that must be as near: it has spikes where pixels mix
POINTS_QUANTILE = 0.98
SPACING = 0.002  # of points along the outline [m]
BESIDE = 0.008  # points of the outline that are as near to a side belong to it [m]
TOP = 0.005  # depth below the top of the points that belong to it [m]
STRAY = 0.005  # part of them beyond each side
LEAST_POINTS = 50  # of the top
GRID = 0.005  # of points on the top of a block [m]
COARSE = np.radians(2)  # first steps of the yaw
MOST_TILT = 0.02  # of a support that counts as level [rad]


@dataclasses.dataclass(frozen=True)
class Block:
    """A box on a level support.

    Attributes
    ----------
    size : array [3]
        Its sides [m].
    X_WB : array [4, 4]
        Pose of its centre; the axes of B are its edges.
    """

    size: Matrix
    X_WB: Matrix

    @property
    def vertical(self) -> int:
        """Axis of B that is vertical."""
        return int(np.argmax(np.abs(np.asarray(self.X_WB)[2, :3])))

    @property
    def across(self) -> list[int]:
        """The two axes of B that are level."""
        return [k for k in range(3) if k != self.vertical]

    @property
    def height(self) -> float:
        """Its height as it stands [m]."""
        return float(self.size[self.vertical])

    @property
    def sides(self) -> Matrix:
        """(2,) sides of its footprint [m]."""
        found: Matrix = self.size[self.across]
        return found

    @property
    def corners(self) -> Matrix:
        """(4, 2) corners of its footprint in the world, counter-clockwise [m]."""
        a, b = np.asarray(self.X_WB)[:2, :3][:, self.across].T * self.sides[:, None] / 2
        turned = np.array([a + b, b - a, -a - b, a - b])
        ring: Matrix = turned + np.asarray(self.X_WB)[:2, 3]
        return ring if a[0] * b[1] > a[1] * b[0] else ring[::-1]

    @property
    def text(self) -> str:
        """Its sides, the longest first."""
        return " x ".join(f"{1000 * side:.0f}" for side in sorted(self.size, reverse=True)) + " mm"

    def moved(self, X_WW: Matrix) -> Block:
        """Returns the block after a motion of the world's points."""
        return Block(self.size, X_WW @ self.X_WB)


def level(wish: Wish) -> Wish | str:
    """Returns the same wish with a level support below the object, or why it is not level.

    Fingertips move objects on a level floor. A camera sees a level table tilted a little.
    """
    X_WS, X_WO = np.asarray(wish.support.X_WS), np.asarray(wish.thing.X_WO)
    tilt = float(np.arccos(min(1.0, X_WS[2, 2])))
    if tilt > MOST_TILT:
        is_tilted = f"{wish.support.name} is tilted by {np.degrees(tilt):.1f} deg"
        return f"{is_tilted}, at most {np.degrees(MOST_TILT):.1f} deg are allowed"
    polygon = np.asarray(wish.support.polygon) @ X_WS[:2, :2].T + X_WS[:2, 3]
    support = perception.Support(
        name=wish.support.name,
        polygon=polygon,
        edges=wish.support.edges,
        X_WS=frames.translation([0, 0, X_WO[2, 3]]),
    )
    flat = frames.planar(X_WO[0, 3], X_WO[1, 3], float(np.arctan2(X_WO[1, 0], X_WO[0, 0])))
    flat[2, 3] = X_WO[2, 3]
    thing = placed(wish, wish.thing.outline, float(wish.thing.thickness), flat, wish.thing.points)
    return dataclasses.replace(wish, support=support, thing=thing)


def block_of(wish: Wish) -> Block | str:
    """Returns the object as a block, or how far it is off the block that fits it best."""
    ring = dense(np.asarray(wish.thing.outline), SPACING)
    height = float(wish.thing.thickness)
    fits = [_fitted(ring, yaw) for yaw in np.arange(0, np.pi / 2, COARSE)]
    best = min(fits, key=lambda fit: fit.off)
    near = best.yaw + COARSE * np.linspace(-1, 1, 21)
    best = min((_fitted(ring, yaw) for yaw in near), key=lambda fit: fit.off)
    points = np.asarray(wish.thing.points)
    top = points[points[:, 2] > height - TOP][:, :2]
    if len(top) < LEAST_POINTS:
        return f"no block: {len(top)} points of its top were seen, {LEAST_POINTS} are needed"
    # The outline holds what lies between the top's far edge and the support; the top is seen.
    best = _fitted(ring, best.yaw, top)
    size = np.array([*(best.high - best.low), height])
    X_OB = frames.planar(0, 0, best.yaw)
    X_OB[:3, 3] = X_OB[:3, :3] @ [*(best.low + best.high) / 2, height / 2]
    block = Block(size, np.asarray(wish.thing.X_WO) @ X_OB)
    points_B = (points - X_OB[:3, 3]) @ X_OB[:3, :3]
    for what, off, quantile in (
        ("its outline is", best.apart, OUTLINE_QUANTILE),
        ("its points are", _off(points_B, size), POINTS_QUANTILE),
    ):
        farthest = float(np.quantile(off, quantile)) if len(off) else np.inf
        if farthest > MOST_OFF:
            return (
                f"no block: {what} {1000 * farthest:.0f} mm off one of {block.text}; at most "
                f"{1000 * MOST_OFF:.0f} mm are allowed"
            )
    return block


def wish_at(wish: Wish, goal: Block) -> Wish:
    """Returns the wish for a block where it stands after a motion: its top counts as seen.

    `wish` has a level support.
    """
    x, y, z = np.asarray(goal.X_WB)[:3, 3]
    along = np.asarray(goal.X_WB)[:2, :3][:, goal.across][:, int(np.argmax(goal.sides))]
    X_WO = frames.planar(float(x), float(y), float(np.arctan2(along[1], along[0])))
    X_WO[2, 3] = z - goal.height / 2
    ring = (goal.corners - X_WO[:2, 3]) @ X_WO[:2, :2]
    top = np.asarray(geometry.sample_grid(geometry.Polygon(ring), GRID))
    points = np.column_stack([top, np.full(len(top), goal.height)])
    thing = placed(wish, ring, goal.height, X_WO, points)
    return dataclasses.replace(wish, thing=thing)


def placed(
    wish: Wish, outline: Matrix, thickness: float, X_WO: Matrix, points: Matrix
) -> perception.Object:
    """Returns the object of a wish with another shape and pose."""
    old = wish.thing
    return perception.Object(
        name=old.name,
        support=old.support,
        outline=outline,
        X_WO=X_WO,
        thickness=thickness,
        thickness_error=old.thickness_error,
        is_flat=old.is_flat,
        position_error=old.position_error,
        yaw_error=old.yaw_error,
        points=points,
        touches_border=old.touches_border,
        warnings=list(old.warnings),
    )


@dataclasses.dataclass(frozen=True)
class _Fit:
    """A rectangle at a yaw: its bounds in its axes, and the ring's distances from its sides [m]."""

    yaw: float
    low: Matrix
    high: Matrix
    apart: Matrix

    @property
    def off(self) -> float:
        return float(self.apart.mean())


def _fitted(ring: Matrix, yaw: float, top: Matrix | None = None) -> _Fit:
    """Returns a rectangle at a yaw, whose sides run through most of a ring's points near them.

    With points of the top, it is the rectangle around these.
    """
    R = np.asarray(frames.planar(0, 0, float(yaw)))[:2, :2]
    turned = ring @ R
    if top is None:
        low, high = np.quantile(turned, [0.02, 0.98], axis=0)
        low, high = (
            np.array([np.median(turned[np.abs(turned[:, k] - b[k]) < BESIDE, k]) for k in (0, 1)])
            for b in (low, high)
        )
    else:
        low, high = np.quantile(top @ R, [STRAY, 1 - STRAY], axis=0)
    apart = _off(turned - (low + high) / 2, high - low)
    return _Fit(float(yaw), low, high, apart)


def _off(points_B: Matrix, size: Matrix) -> Matrix:
    """(N,) distances of points from the surface of a box, or of a rectangle [m]."""
    beyond = np.abs(points_B) - size / 2
    outside = np.linalg.norm(np.maximum(beyond, 0), axis=1)
    off: Matrix = np.where((beyond < 0).all(axis=1), -beyond.max(axis=1), outside)
    return off
