# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pose of a prism that is another planner's object."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ... import frames
from ..shapes import PlanarPose

if TYPE_CHECKING:
    from ... import slide
    from ...frames import Matrix

SAME = 1e-4  # [m]; corners of one object, described twice
FLAT = SAME / 10  # of a corner, from the line between the corners beside it


def lying(corners_S: Matrix, com_S: Matrix, prism: slide.Object) -> PlanarPose:
    """Returns the pose in S at which a prism has given corners.

    Of several, the one whose centre of mass is nearest to the given one, and then the least turned.

    Parameters
    ----------
    corners_S : array [N, 3]
        Of the object's convex hull, in S [m].
    com_S : array [3]
        Its centre of mass, in S [m].
    prism : slide.Object

    Raises
    ------
    ValueError
        The prism is no such object, or the object does not lie on the support.
    """
    low, high = corners_S[:, 2].min(), corners_S[:, 2].max()
    thickness = prism.thickness
    if abs(low) > SAME:
        raise ValueError(f"lies {low:.4g} m over the support")
    if abs(high - low - thickness) > SAME:
        raise ValueError(f"is {high - low:.4g} m high as it lies; thickness is {thickness:.4g}")
    seen, own = convex_hull(corners_S[:, :2]), convex_hull(np.asarray(prism.outline.vertices))
    fits = [_fitted(own, np.roll(seen, -k, axis=0)) for k in range(len(seen))]
    if len(seen) != len(own):
        raise ValueError(f"has {len(seen)} corners seen from above; the outline has {len(own)}")
    off = min(error for error, _ in fits)
    if off > SAME:
        raise ValueError(f"has another outline seen from above: corners are {off:.4g} m off")
    poses = [pose for error, pose in fits if error < off + SAME / 10]
    coms = [frames.planar(p.x, p.y, p.yaw)[:2, :3] @ [*prism.com[:2], 0] for p in poses]
    away = [
        float(np.linalg.norm([p.x, p.y] + com - com_S[:2]))
        for p, com in zip(poses, coms, strict=True)
    ]
    least = min(away) + SAME
    nearest = (pose for pose, d in zip(poses, away, strict=True) if d <= least)
    return min(nearest, key=lambda pose: abs(pose.yaw))


def _fitted(own: Matrix, seen: Matrix) -> tuple[float, PlanarPose]:
    """Returns the pose that maps corners to corners in order, and the largest distance left."""
    if len(own) != len(seen):
        return np.inf, PlanarPose()
    a, b = own - own.mean(axis=0), seen - seen.mean(axis=0)
    yaw = float(np.arctan2(cross(a, b).sum(), (a * b).sum()))  # least squares
    c, s = np.cos(yaw), np.sin(yaw)
    R = np.array([[c, -s], [s, c]])
    x, y = seen.mean(axis=0) - R @ own.mean(axis=0)
    error = float(np.linalg.norm(a @ R.T - b, axis=1).max())
    return error, PlanarPose(x=float(x), y=float(y), yaw=yaw)


def convex_hull(points: Matrix) -> Matrix:
    """[K, 2] corners of the convex hull, counter-clockwise, without those that are hardly any."""
    _, first = np.unique(np.round(points, 9), axis=0, return_index=True)
    ordered = points[first]
    ring = np.array(_half(ordered)[:-1] + _half(ordered[::-1])[:-1])
    before, after = np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0)
    along = after - before
    reach = cross(ring - before, along) / np.linalg.norm(along, axis=1)
    ring = np.roll(ring, -int(np.argmax(reach)), axis=0)  # the sharpest first: it stays
    corners = [ring[0]]
    for p, after in zip(ring[1:], [*ring[2:], ring[0]], strict=True):
        along = after - corners[-1]
        if cross(p - corners[-1], along) > FLAT * np.linalg.norm(along):
            corners.append(p)
    return np.array(corners)


def _half(ordered: Matrix) -> list[Any]:
    """Returns one side of Andrew's monotone chain."""
    chain: list[Any] = []
    for p in ordered:
        while len(chain) > 1 and cross(chain[-1] - chain[-2], p - chain[-1]) <= 0:
            chain.pop()
        chain.append(p)
    return chain


def cross(a: Matrix, b: Matrix) -> Any:
    """[...] of vectors in the plane, [..., 2]."""
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
