# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Moving parts that are attached to the palm but are no fingers: bars, and parts that spin."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from .jaws import middle, snapped

if TYPE_CHECKING:
    from ..frames import Matrix
    from .palm import Finger, Palm
    from .tree import Tree

SPINS = 0.15  # offset of a part's middle from the axis that it turns about, over its size
SHORTER = 0.9  # a bar reaches less far than this fraction of the finger beside it
BESIDE = 0.7  # cosine: directions from the middle of the palm to a bar and to its finger


def without_linkage(tree: Tree, palm: Palm) -> Palm:
    """Returns the palm with fingers only.

    A bar is moved by the same one joint as a finger beside it, and does not reach as far. A motor's
    horn or a flywheel turns about an axis through its own middle.
    """
    palm = _without_spinning(tree, palm)
    if len(palm.fingers) < 3:
        return palm
    X_WL = tree.poses(tree.robot.clamp(np.zeros(tree.robot.dof)))
    clouds = [tree.cloud(finger.links(tree), X_WL) for finger in palm.fingers]
    base = X_WL[palm.link(tree)][:3, 3]
    axes = np.vstack([X_WL[link][:3, :3].T for link in tree.members[palm.body]])
    out = snapped(np.mean([cloud.mean(axis=0) for cloud in clouds], axis=0) - base, axes)
    heights = [float(((cloud - base) @ out).max()) for cloud in clouds]
    aside = [_aside(cloud.mean(axis=0) - base, out) for cloud in clouds]
    moved_by = [tree.driver(finger.bodies[0]) for finger in palm.fingers]
    joints = [len(tree.drivers(list(finger.bodies))) for finger in palm.fingers]

    def is_bar(i: int) -> bool:
        return any(
            i != j
            and joints[i] == 1
            and moved_by[i] == moved_by[j]
            and heights[i] < SHORTER * heights[j]
            and aside[i] @ aside[j] > BESIDE
            for j in range(len(clouds))
        )

    kept: tuple[Finger, ...] = tuple(f for i, f in enumerate(palm.fingers) if not is_bar(i))
    bars = [f.name(tree) for i, f in enumerate(palm.fingers) if is_bar(i)]
    if len(kept) < 2 or not bars:
        return palm
    return replace(palm, fingers=kept, reason=f"{palm.reason}; {', '.join(bars)} are its linkage")


def _without_spinning(tree: Tree, palm: Palm) -> Palm:
    kept = tuple(finger for finger in palm.fingers if not _spins(tree, finger))
    return replace(palm, fingers=kept) if len(kept) >= 2 else palm


def _spins(tree: Tree, finger: Finger) -> bool:
    """True if the finger is one body that turns about an axis through its middle."""
    body, joint = finger.bodies[0], tree.joint(finger.bodies[0])
    if finger.is_fixed or len(finger.bodies) > 1 or joint is None or joint.kind == "prismatic":
        return False
    X_WL = tree.poses(tree.robot.clamp(np.zeros(tree.robot.dof)))
    cloud = (tree.cloud(tree.members[body], X_WL) - X_WL[body][:3, 3]) @ X_WL[body][:3, :3]
    axis = np.asarray(joint.axis_L) / np.linalg.norm(joint.axis_L)
    across = cloud - np.outer(cloud @ axis, axis)
    size = float(np.linalg.norm(np.ptp(cloud, axis=0)))
    return float(np.linalg.norm(middle(across))) < SPINS * size


def _aside(offset: Matrix, out: Matrix) -> Matrix:
    across = offset - out * (offset @ out)
    return np.asarray(across / max(float(np.linalg.norm(across)), 1e-9))
