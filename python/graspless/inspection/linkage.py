# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bars of a gripper's linkage, which are attached to the palm but are no fingers."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from .jaws import snapped

if TYPE_CHECKING:
    from ..frames import Matrix
    from .palm import Finger, Palm
    from .tree import Tree

SHORTER = 0.9  # a bar reaches less far than this share of the finger beside it
BESIDE = 0.7  # cosine: directions from the middle of the palm to a bar and to its finger


def without_linkage(tree: Tree, palm: Palm) -> Palm:
    """Returns the palm with fingers only.

    A bar is moved by the same joint as a finger beside it, and does not reach as far.
    """
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

    def is_bar(i: int) -> bool:
        return any(
            moved_by[i] == moved_by[j]
            and heights[i] < SHORTER * heights[j]
            and aside[i] @ aside[j] > BESIDE
            for j in range(len(clouds))
        )

    kept: tuple[Finger, ...] = tuple(f for i, f in enumerate(palm.fingers) if not is_bar(i))
    bars = [f.name(tree) for i, f in enumerate(palm.fingers) if is_bar(i)]
    if len(kept) < 2 or not bars:
        return palm
    return replace(palm, fingers=kept, reason=f"{palm.reason}; {', '.join(bars)} are its linkage")


def _aside(offset: Matrix, out: Matrix) -> Matrix:
    across = offset - out * (offset @ out)
    return np.asarray(across / max(float(np.linalg.norm(across)), 1e-9))
