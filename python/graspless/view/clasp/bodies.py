# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies of a clasp: the object with its loops, and the hand's finger curves."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..bodies import FINGER, LOOP, OBJECT, TRAIL, Body, Color
from ..surface import surface_part
from ..tubes import ball, smooth, tube

if TYPE_CHECKING:
    from ...clasp import Plan
    from ...frames import Matrix
    from ...tasks import Task

CLASPED: Color = TRAIL
CURVE: Color = FINGER
TARGET: Color = (0.98, 0.98, 0.98)
CHORD: Color = (0.72, 0.36, 0.95)
NODE: Color = (0.55, 0.57, 0.60)
PATH: Color = (0.13, 0.52, 0.30)


def object_body(task: Task) -> Body:
    """Returns the object's surface, in O, or the point cloud if it has no triangle."""
    surface = task.problem.object.loops.surface
    part = surface_part(surface.points, surface.triangles, OBJECT)
    if len(part.triangles):
        return Body("object", [part])
    cloud = np.asarray(task.problem.object.points)
    some = cloud[:: max(1, len(cloud) // 500)]
    return Body("object", [ball(p, 0.004 * size(task), OBJECT) for p in some])


def loop_bodies(plan: Plan) -> list[Body]:
    """Returns a tube along each loop, in O; the clasped loop has its own colour."""
    loops = plan.task.problem.object.loops.found
    radius = 0.0045 * size(plan.task)
    return [
        Body(
            f"loop {k}",
            [
                tube(
                    smooth(loop.points),
                    1.4 * radius if k == plan.loop else radius,
                    CLASPED if k == plan.loop else LOOP,
                    closed=True,
                )
            ],
        )
        for k, loop in enumerate(loops)
    ]


def target_body(plan: Plan) -> Body:
    """Returns the target, where the loop is clasped, in O."""
    if plan.target is None:
        return Body("target")
    return Body("target", [ball(plan.target.point, 0.011 * size(plan.task), TARGET)])


def curve_bodies(task: Task, link_poses: Matrix) -> list[Body]:
    """Returns a tube along each finger curve and one along its chord, in the world.

    Parameters
    ----------
    task : Task
    link_poses : array [F, 4, 4]
        Poses of every frame of the robot in the world.
    """
    curves = finger_curves(task, link_poses)
    reach = max((float(np.ptp(curve, axis=0).max()) for curve in curves), default=0.1)
    radius = 0.016 * reach
    return [
        Body(
            f"curve {k}",
            [
                tube(curve, radius, CURVE),
                *(ball(corner, 1.7 * radius, CURVE) for corner in curve),
                tube(curve[[0, -1]], 0.7 * radius, CHORD),
            ],
        )
        for k, curve in enumerate(curves)
    ]


def finger_curves(task: Task, link_poses: Matrix) -> list[Matrix]:
    """Returns the corners of each finger curve, [K, 3] in the world, from finger to thumb tip."""
    problem = task.problem
    names = list(problem.robot.frame_names)

    def corners(finger: object) -> list[Matrix]:
        found = []
        for node in finger.nodes:  # type: ignore[attr-defined]
            X_WL = link_poses[names.index(node.link)]
            found.append(X_WL[:3, :3] @ np.asarray(node.p_L) + X_WL[:3, 3])
        return found

    thumb = corners(problem.hand.thumb)
    return [np.array([*corners(finger)[::-1], *thumb]) for finger in problem.hand.fingers]


def size(task: Task) -> float:
    """Returns the longest side of the object's bounding box [m]."""
    return float(np.ptp(np.asarray(task.problem.object.points), axis=0).max())
