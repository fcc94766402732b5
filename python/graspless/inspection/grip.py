# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The force of fingers, by the effort limits of their joints."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..tasks.grip import STRONGEST, forces, weakest_joint
from .jaws import at_end

if TYPE_CHECKING:
    from ..frames import Matrix
    from .fist import Fist
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
    return _described(weakest, found[weakest])


def describe_fist(tree: Tree, fist: Fist) -> tuple[str, str, bool]:
    """Returns the largest force of a finger against the thumb, as `describe_grip` does."""
    ends = [(tree.links[link], p_LT) for link, p_LT in fist.tips_L]
    thumb = ends.pop(fist.thumb)
    half = (fist.open + fist.closed) / 2
    joints = [tree.robot.joint_names[i] for i in (fist.open != fist.closed).nonzero()[0]]
    found = [weakest_joint(tree.robot, joints, half, (end, thumb)) for end in ends]
    known = [limit for limit in found if limit is not None]
    if not known:
        return "unknown", f"no effort limit of {', '.join(joints)}", False
    return _described(*max(known, key=lambda limit: limit[1]))


def _described(joint: str, force: float) -> tuple[str, str, bool]:
    why = f"by virtual work, from the effort limit of {joint}"
    if force > STRONGEST:
        why += "; few grippers are as strong: write the real limit into the URDF"
    return f"{force:.3g} N", why, force <= STRONGEST


def _gap(tree: Tree, jaws: Jaws, q: Matrix) -> float:
    """Returns the distance between the middles of both ends, across the hand [m]."""
    X_WL, across, out = tree.poses(q), jaws.R_WH[:, 1], jaws.R_WH[:, 2]
    clouds = [tree.cloud(finger.links(tree), X_WL) for finger in jaws.fingers]
    first, second = (cloud[at_end(cloud, out)].mean(axis=0) @ across for cloud in clouds)
    return float(first - second)
