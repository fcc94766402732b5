# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Places on a support where a picked object can be put down."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames, geometry
from ..errors import TaskError
from ..tasks import scenes
from ..tasks.source import Source
from ..tasks.statement import pose_fields
from . import loose
from .obstacles import documents
from .place_fields import Place, place_of
from .wish import dense

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..perception import Support
    from .wish import Wish

MARGIN = 0.01  # of the middle of the object within the edge of its support [m]
GAP = 0.01  # to other objects [m]
SPACING = 0.04  # of places on a support [m]
EVEN = 0.005  # [m]
DENSE = 0.005  # of points of outlines [m]
TURNS = 8  # yaws at a place without one
MOST = 60  # places that are given to the planner


@dataclass(frozen=True)
class Target:
    """A place that was asked for, on a support of the scene.

    Attributes
    ----------
    wish : Wish
    place : Place
    support : Support
        Support on which the object shall stand.
    """

    wish: Wish
    place: Place
    support: Support

    @cached_property
    def polygon(self) -> geometry.Polygon:
        """Outline of the support, in S [m]."""
        return geometry.Polygon(self.support.polygon)

    @cached_property
    def region(self) -> geometry.Polygon | None:
        """Region that was asked for, in S [m]."""
        if self.place.region is None:
            return None
        try:
            return geometry.Polygon(self._in_S(self.place.region.corners()), "place: region")
        except ValueError as error:
            raise TaskError(str(error)) from None

    @cached_property
    def taken(self) -> list[tuple[str, Matrix, geometry.Polygon]]:
        """Other objects on the support: names, points of their outlines, and outlines, in S."""
        X_SW = np.linalg.inv(self.support.X_WS)
        outlines = [
            (other.name, _moved(np.asarray(other.outline), X_SW @ other.X_WO))
            for other in self.wish.others
            if other.support == self.support.name
        ]
        return [(name, dense(ring, DENSE), geometry.Polygon(ring)) for name, ring in outlines]

    @cached_property
    def ring(self) -> Matrix:
        """Points of the outline in O."""
        return dense(np.asarray(self.wish.thing.outline), DENSE)

    @property
    def yaw(self) -> float:
        """Yaw of S in the world [rad]."""
        return float(np.arctan2(self.support.X_WS[1, 0], self.support.X_WS[0, 0]))

    @property
    def is_same(self) -> bool:
        """True if the object stands on that support now."""
        return bool(self.support.name == self.wish.support.name)

    @property
    def obstacle(self) -> str:
        """Name of the support as an obstacle."""
        return f"scene {self.support.name}"

    def _in_S(self, points: Matrix) -> Matrix:
        """Points of the support [M, 2] in S, straight above or below points of W [M, 2]."""
        X_WS = np.asarray(self.support.X_WS)
        off = points - X_WS[:2, 3]
        z = -(off @ X_WS[:2, 2]) / X_WS[2, 2]
        found: Matrix = np.column_stack([off, z]) @ X_WS[:3, :2]
        return found

    def asked(self) -> list[Matrix]:
        """Returns the poses X_SO [4, 4] of a place with a pose, the turns nearest to now first."""
        pose = self.place.pose
        assert pose is not None
        x, y = self._in_S(np.array([[pose.x, pose.y]]))[0]
        yaws = self.turns if pose.yaw is None else [pose.yaw - self.yaw]
        if pose.yaw is not None and self.is_even:
            yaws.append(yaws[0] + np.pi)
        return [frames.planar(x, y, yaw) for yaw in yaws]

    @cached_property
    def is_even(self) -> bool:
        """True if half a turn changes neither the outline nor the centre of mass, within `EVEN`."""
        off = [abs(float(self.wish.outline.depth(-p))) for p in self.ring]
        return max(off) < EVEN and float(np.linalg.norm(self.wish.com[:2])) < EVEN

    @cached_property
    def turns(self) -> list[float]:
        """Yaws that are tried, in S, the nearest to the present one first [rad]."""
        X_SO = np.linalg.inv(self.support.X_WS) @ self.wish.thing.X_WO
        now = float(np.arctan2(X_SO[1, 0], X_SO[0, 0]))
        steps = sorted(range(TURNS), key=lambda k: min(k, TURNS - k))
        return [now + 2 * np.pi * k / TURNS for k in steps]

    def fault(self, X_SO: Matrix, slack: float = 0.0, in_region: bool = True) -> tuple[int, str]:
        """Says why the object cannot stand at a pose, or up to `slack` from it [m], or nothing.

        Unless `in_region`, it may be outside the region. The number counts the conditions that
        hold, in the order in which they are looked at.
        """
        margin, gap = MARGIN + slack, max(GAP, self.wish.room) + slack
        inside = float(self.polygon.depth(X_SO[:2, 3]))
        if inside < margin:
            where = "beyond" if inside < 0 else "from"
            off = f"{100 * abs(inside):.1f} cm {where} the edge of {self.support.name}"
            return 0, f"its middle would be {off}; {100 * margin:.0f} cm within it are needed"
        ring = _moved(self.ring, X_SO)
        if in_region and self.region is not None:
            region = self.region
            out = [p for p in ring if region.depth(p) < slack and self.polygon.contains(p)]
            if out:
                return 1, self._too_small()
        X_OS = np.asarray(np.linalg.inv(X_SO), dtype=float)
        for name, other, polygon in self.taken:
            apart = np.linalg.norm(ring[:, None] - other[None], axis=2).min()
            is_within = polygon.contains(ring[0])
            if apart < gap or is_within or self.wish.outline.contains(_moved(other[:1], X_OS)[0]):
                near = f"'{name}' is there, or less than {1000 * gap:.0f} mm away"
                return 2, f"the place is taken: {near}"
        return 3, ""

    def _too_small(self) -> str:
        assert self.region is not None
        sizes = [
            " x ".join(f"{1000 * side:.0f}" for side in sorted(np.ptp(ring, axis=0)))
            for ring in (self.region.vertices, np.asarray(self.wish.thing.outline))
        ]
        return f"the region has {sizes[0]} mm, the object {sizes[1]} mm: it does not fit anywhere"

    def spread(self) -> Iterator[Matrix]:
        """Yields poses X_SO all over the support or the region, the nearest first."""
        within = self.polygon if self.region is None else self.region
        low, high = np.min(within.vertices, axis=0), np.max(within.vertices, axis=0)
        axes = [np.arange(a, b + SPACING / 2, SPACING) for a, b in zip(low, high, strict=True)]
        spots = np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 2)
        spots = np.vstack([spots, [within.centroid]])
        for k in np.argsort(np.linalg.norm(spots - self.middle, axis=1), kind="stable"):
            for yaw in [*self.turns, *self._along_region()]:
                yield frames.planar(float(spots[k, 0]), float(spots[k, 1]), yaw)

    def _along_region(self) -> list[float]:
        """Yaws at which the longest extent of the object lies along or across the region."""
        if self.region is None:
            return []
        side = self.region.edge(0)
        x, y = np.asarray(side.b) - np.asarray(side.a)
        return [float(np.arctan2(y, x)) + k * np.pi / 2 for k in range(4)]

    @property
    def middle(self) -> Matrix:
        """Point in S near which places are tried first: where the object is, or the region [2]."""
        if self.region is not None:
            return np.asarray(self.region.centroid)
        X_SO = np.linalg.inv(self.support.X_WS) @ self.wish.thing.X_WO
        here: Matrix = X_SO[:2, 3]
        return here


def target_of(wish: Wish, given: Any) -> Target:
    """Returns where the object shall be put down. Raises TaskError if there is no such support."""
    place = place_of(given)
    source = Source("place", {"on": place.on})
    name = place.on or wish.support.name
    support = scenes.named(wish.supports, name, source, ("on",))
    return Target(wish, place, support)


def refusal(target: Target, slack: float = 0.0) -> str:
    """Says why the object can stand nowhere where it is asked for, or nothing. See `fault`."""
    poses = target.spread() if target.place.pose is None else iter(target.asked())
    reasons = []
    for X_SO in poses:
        reasons.append(target.fault(X_SO, slack))
        if not reasons[-1][1]:
            return ""
    farthest = max(reach for reach, _ in reasons)
    texts = [reason for reach, reason in reasons if reach == farthest]
    return max(dict.fromkeys(texts), key=texts.count)


def stage_of(target: Target, grasp: Any, lift: Any) -> dict[str, Any] | str:
    """Returns the stage of a chain that puts down what it has grasped and lifted, or a reason.

    `grasp` and `lift` are the plans of these stages. See `over_edge` for what was slid.
    """
    sway = loose.sway_of(lift, target.wish)
    if falls := loose.refusal(sway, lift, target.wish):
        return falls
    slack = 0.0 if sway is None else sway.off
    poses = target.spread() if target.place.pose is None else iter(target.asked())
    found = list(itertools.islice((X for X in poses if not target.fault(X, slack)[1]), MOST))
    if not found:
        return f"it may stand {1000 * slack:.0f} mm off, and {refusal(target, slack)}"
    stage = put_down(target, found, grasp.kind)
    return stage | loose.place_options(sway)


def put_down(target: Target, poses: list[Matrix], grasp: str) -> dict[str, Any]:
    """Returns the stage that puts the object down at the first of poses X_SO that works.

    `grasp` is the kind of the stage that grasped it.
    """
    obstacles = target.wish.around if grasp == "clasp" else target.wish.beside
    on = target.obstacle
    if target.is_same and grasp != "clasp":
        on = "support"
    elif not target.is_same or all(obstacle["name"] != on for obstacle in obstacles):
        others = [obstacle for obstacle in obstacles if obstacle["name"] != on]
        obstacles = [*others, *documents([scenes.slab(target.support)])]
    return {
        "name": "place",
        "kind": "carry",
        "place": {
            "on": on,
            "normal": [float(value) for value in target.support.X_WS[:3, 2]],
            "poses": [pose_fields(target.support.X_WS @ X_SO) for X_SO in poses],
        },
        "obstacles": obstacles,
    }


def _moved(ring: Matrix, X: Matrix) -> Matrix:
    moved: Matrix = ring @ X[:2, :2].T + X[:2, 3]
    return moved
