# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The force of two fingers, by the effort limits of their joints."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..tasks.grip import STRONGEST, forces
from .jaws import at_end

if TYPE_CHECKING:
    from ..frames import Matrix
    from .jaws import Jaws
    from .tree import Tree


def describe_grip(tree: Tree, jaws: Jaws) -> tuple[str, str, bool]:
    """Returns the largest force of each finger half way closed, its reason, and if it is sure."""
    half = (jaws.open + jaws.closed) / 2
    found = forces(tree.robot, jaws.drivers, half, lambda q: _gap(tree, jaws, q))
    unknown = [name for name, force in found.items() if not math.isfinite(force)]
    if unknown or not found:
        return "unknown", f"no effort limit of {', '.join(unknown or jaws.drivers)}", False
    weakest = min(found, key=lambda name: found[name])
    force = found[weakest]
    why = f"by virtual work, from the effort limit of {weakest}"
    if force > STRONGEST:
        why += "; few grippers are as strong: write the real limit into the URDF"
    return f"{force:.3g} N", why, force <= STRONGEST


def _gap(tree: Tree, jaws: Jaws, q: Matrix) -> float:
    """Returns the distance between the middles of both ends, across the hand [m]."""
    X_WL, across, out = tree.poses(q), jaws.R_WH[:, 1], jaws.R_WH[:, 2]
    clouds = [tree.cloud(finger.links(tree), X_WL) for finger in jaws.fingers]
    first, second = (cloud[at_end(cloud, out)].mean(axis=0) @ across for cloud in clouds)
    return float(first - second)
