# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Curves of fingers and thumb for clasps (Stork, Pokorny, Kragic 2013)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from .fist import INSIDE
from .points import is_inside, shape_points

if TYPE_CHECKING:
    from ..frames import Matrix
    from .fist import Fist
    from .jaws import Jaws
    from .palm import Finger
    from .tips import Tip
    from .tree import Tree

BESIDE = 0.02  # largest way of a finger's first corner into the shapes of the palm [m]
APART = 0.002  # corners that are nearer than this are one [m]


def fist_fields(tree: Tree, palm: str, fingers: tuple[Finger, ...], fist: Fist) -> dict[str, Any]:
    """Returns the fields of a hand that clasps by bending its fingers; `palm` is a link of it."""
    curves = [
        _curve(tree, finger, tip, fist.open)
        for finger, tip in zip(fingers, fist.tips_L, strict=True)
    ]
    names = [tree.links[finger.bodies[0]] for finger in fingers]
    named = {
        name: c for k, (name, c) in enumerate(zip(names, curves, strict=True)) if k != fist.thumb
    }
    X_WP = np.asarray(tree.robot.pose(palm, fist.open))
    return _fields(palm, X_WP, fist.forward_W, fist.sideways_W, named, curves[fist.thumb])


def jaw_fields(tree: Tree, palm: str, jaws: Jaws, tips: tuple[Tip, Tip]) -> dict[str, Any]:
    """Returns the fields of a hand that clasps between two fingers: the second is its thumb."""
    curves = [
        _jaw_curve(tree, palm, finger, jaws, tip)
        for finger, tip in zip(jaws.fingers, tips, strict=True)
    ]
    # The curve must end on a finger that moves.
    moving, thumb = (1, 0) if jaws.fingers[0].is_fixed else (0, 1)
    name = tree.links[jaws.fingers[moving].bodies[0]]
    X_WP = np.asarray(tree.robot.pose(palm, jaws.open))
    forward, sideways = jaws.R_WH[:, 2], jaws.R_WH[:, 0]
    return _fields(palm, X_WP, forward, sideways, {name: curves[moving]}, curves[thumb])


def _fields(
    palm: str, X_WP: Matrix, forward_W: Matrix, sideways_W: Matrix, fingers: Any, thumb: Any
) -> dict[str, Any]:
    forward, sideways = (X_WP[:3, :3].T @ direction for direction in (forward_W, sideways_W))
    return {
        "frame": palm,
        "forward": _numbers(forward - sideways * (sideways @ forward)),
        "sideways": _numbers(sideways),
        "fingers": fingers,
        "thumb": thumb,
    }


def _jaw_curve(tree: Tree, palm: str, finger: Finger, jaws: Jaws, tip: Tip) -> list[dict[str, Any]]:
    """Corners in the palm, at the near end of the finger and in its tip."""
    out = jaws.R_WH[:, 2]
    X_WL = tree.poses(jaws.open)
    end = _node(tree, X_WL, tip.link, tip.middle_W - INSIDE * out)
    first = finger.links(tree)[0]
    cloud = tree.cloud([first], X_WL)
    if finger.is_fixed:  # from the height of the other finger's joint
        other = next(f for f in jaws.fingers if not f.is_fixed)
        height = float(X_WL[other.bodies[0]][:3, 3] @ out)
        near = tip.middle_W + out * (height - tip.middle_W @ out)
        return [_node(tree, X_WL, tip.link, near), end]
    heights = cloud @ out
    rear = cloud[heights < heights.min() + INSIDE]
    corner = (rear.min(axis=0) + rear.max(axis=0)) / 2 + INSIDE * out
    # In the palm where the closed finger begins: no joint moves this corner.
    X_WC = np.asarray(tree.robot.pose(first, jaws.closed))
    below = X_WC @ np.linalg.inv(X_WL[first]) @ [*(corner - 2 * INSIDE * out), 1.0]
    carrier = tree.links.index(palm)
    return [
        _node(tree, X_WL, carrier, _inside(tree, X_WL, carrier, below[:3])),
        _node(tree, X_WL, first, corner),
        end,
    ]


def _inside(tree: Tree, X_WL: Matrix, link: int, p_W: Matrix) -> Matrix:
    """Returns the point next to p in the boxes around the shapes of a link, INSIDE their sides."""
    found: list[Matrix] = []
    for placed in (placed for index, placed in tree.robot.shapes if index == link):
        points = shape_points(placed.shape)
        low, high = points.min(axis=0), points.max(axis=0)
        inset = np.minimum(INSIDE, (high - low) / 2)
        X_WG = X_WL[link] @ placed.X_BG
        p_G = frames.transform(np.linalg.inv(X_WG), p_W)
        found.append(frames.transform(X_WG, np.clip(p_G, low + inset, high - inset)))
    return min(found, key=lambda p: float(np.linalg.norm(p - p_W)), default=p_W)


def _node(tree: Tree, X_WL: Matrix, link: int, p_W: Matrix) -> dict[str, Any]:
    R, origin = X_WL[link][:3, :3], X_WL[link][:3, 3]
    return {"link": tree.links[link], "point": _numbers(R.T @ (p_W - origin))}


def _curve(tree: Tree, finger: Finger, tip: tuple[int, Matrix], q: Matrix) -> list[dict[str, Any]]:
    """Corners from the palm to the tip: the finger's joints, each in the link that it moves."""
    X_WL = tree.poses(q)
    owner = tree.parents[finger.bodies[0]]
    last = X_WL[finger.bodies[0]][:3, 3]
    begin = _node(tree, X_WL, owner, last)
    within = _inside(tree, X_WL, owner, last)
    is_beside = np.linalg.norm(within - last) < BESIDE
    if is_beside and not is_inside(tree.robot, begin["link"], begin["point"]):
        begin = _node(tree, X_WL, owner, within)
    nodes = [begin]
    link, p_LT = tip
    end = frames.transform(X_WL[link], p_LT)
    for body in finger.bodies[1:]:
        corner = X_WL[body][:3, 3]
        if min(np.linalg.norm(corner - last), np.linalg.norm(corner - end)) > APART:
            nodes.append({"link": tree.links[body]})
            last = corner
    return [*nodes, {"link": tree.links[link], "point": _numbers(p_LT)}]


def _numbers(values: Matrix) -> list[float]:
    return [round(float(value), 6) + 0.0 for value in values]
