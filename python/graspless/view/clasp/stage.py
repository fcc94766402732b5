# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts that picture and replay share: the moments to draw, and the cameras."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ... import frames
from ..bodies import obstacles, vertices_of, without_wide
from ..raster import Camera
from . import bodies
from .film import linking

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...clasp import Plan
    from ...frames import Matrix
    from ..bodies import Body
    from ..film import Film

ELEVATIONS = (0.38, 0.1)  # [rad], in order of preference
CLOSE_ELEVATIONS = (0.38, 0.0, -0.3, 0.9)
OPEN = 0.85  # cosine between view and the loop's axis: into the hole, slightly from the side


class Scene:
    """Bodies of a clasp, made once, and their poses at each row."""

    def __init__(self, plan: Plan, shown: Film) -> None:
        self.plan, self.shown = plan, shown
        self.object = bodies.object_body(plan.task)
        self.links = shown.robot
        self.obstacles = obstacles(plan.task)
        marks = [*bodies.loop_bodies(plan), bodies.target_body(plan)]
        self.marks = [body for body in marks if body.parts]

    def solid(self, row: int, around: Camera | None = None) -> list[tuple[Body, Matrix]]:
        """Returns robot and object in the world; for a close-up, only nearby links."""
        links = zip(self.links, self.shown.link_poses[row], strict=True)
        near = [(body, X) for body, X in links if around is None or _is_near(body, X, around)]
        found = [(self.object, self.shown.object_poses[row]), *near]
        return [(body, X_WB) for body, X_WB in found if body.parts]

    def lines(self, row: int) -> list[tuple[Body, Matrix]]:
        """Returns loops, target and finger curves in the world."""
        marks = [(body, self.shown.object_poses[row]) for body in self.marks]
        curves = bodies.curve_bodies(self.plan.task, self.shown.link_poses[row])
        return marks + [(body, np.eye(4)) for body in curves]


def moments(plan: Plan) -> list[tuple[int, str]]:
    """Returns rows to draw the robot at, with captions."""
    found = linking(plan)
    if not len(found):
        return [(0, "start")]
    last = len(found) - 1
    apart = np.flatnonzero(~(found > 1e-9).all(axis=1))
    linked = min(int(apart[-1]) + 1, last) if len(apart) else 0
    return [(0, "1  start"), (linked, "2  the loop runs through the hand"), (last, "3  clasped")]


def camera(scene: Scene, rows: Sequence[int], shape: tuple[int, int]) -> Camera:
    """Places the camera where it looks into the hole, and never behind the robot.

    Parameters
    ----------
    scene : Scene
    rows : sequence of int
        Rows that the picture must contain.
    shape : tuple of int
        Width and height of the picture.
    """
    moving = (body for row in rows for body in scene.solid(row))
    points = vertices_of([*without_wide(scene.obstacles), *moving])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    toward = direction(scene.plan, scene.shown)
    eye = middle + 3.5 * float(np.ptp(points, axis=0).max()) * toward
    return Camera(eye, middle).fitted(points, *shape)


def close_camera(scene: Scene, row: int, shape: tuple[int, int]) -> Camera:
    """Places a camera that looks into the hand."""
    plan, shown = scene.plan, scene.shown
    curves = np.concatenate(bodies.finger_curves(plan.task, shown.link_poses[row]))
    middle = (curves.min(axis=0) + curves.max(axis=0)) / 2
    reach = float(np.ptp(curves, axis=0).max())
    around = middle + 0.8 * reach * np.concatenate([np.eye(3), -np.eye(3)])
    toward = direction(plan, shown, row)
    return Camera(middle + 8 * reach * toward, middle).fitted(around, *shape)


def direction(plan: Plan, shown: Film, row: int | None = None) -> Matrix:
    """Returns the unit vector to the viewer, [3]; for a close-up of a row, along the loop."""
    base = shown.link_poses[0, 0, :3, 3]
    X_WO = shown.object_poses[0]
    cloud = frames.transform(X_WO, plan.task.problem.object.points)
    ahead = cloud.mean(axis=0) - base
    ahead[2] = 0.0
    ahead /= max(float(np.linalg.norm(ahead)), 1e-6)
    axis = _loop_axis(plan, X_WO) if row is None else _sideways(plan, shown, row)
    hand = np.concatenate(bodies.finger_curves(plan.task, shown.link_poses[-1]))
    middle = (hand.min(axis=0) + hand.max(axis=0)) / 2
    reach = 0.3 * float(np.ptp(hand, axis=0).max())
    best: tuple[float, Matrix] | None = None
    for elevation in ELEVATIONS if row is None else CLOSE_ELEVATIONS:
        for azimuth in np.radians(np.arange(0, 360, 10)):
            level = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
            toward = np.cos(elevation) * level + np.sin(elevation) * np.array([0.0, 0.0, 1.0])
            facing = float(level @ ahead)  # -1: from behind the robot, 1: into its face
            score = -abs(abs(float(toward @ axis)) - OPEN)
            score -= 0.5 * max(0.0, -facing - 0.2) + 0.3 * max(0.0, facing - 0.5)
            score -= 0.6 * _hidden(cloud - middle, toward, reach)
            if best is None or score > best[0] + 0.05 * (elevation != ELEVATIONS[0]) + 1e-9:
                best = score, toward
    assert best is not None
    return best[1]


def _hidden(points: Matrix, toward: Matrix, radius: float) -> float:
    """Returns the share of a disc about the origin that points hide from a viewer, in [0, 1]."""
    along = points @ toward
    across = points - np.outer(along, toward)
    before = (along > radius) & (np.linalg.norm(across, axis=1) < radius)
    return min(1.0, np.count_nonzero(before) / 25)


def _loop_axis(plan: Plan, X_WO: Matrix) -> Matrix:
    """Returns the normal of the clasped loop, or else the shortest, [3] in the world."""
    loops = plan.task.problem.object.loops.found
    if not loops:
        return np.array([0.0, 1.0, 0.0])
    points = np.asarray(loops[plan.loop or 0].points)
    axis = np.linalg.svd(points - points.mean(axis=0))[2][2]
    return np.asarray(X_WO[:3, :3] @ axis)


def _sideways(plan: Plan, shown: Film, row: int) -> Matrix:
    """Returns the hand's sideways direction v_swd, [3] in the world."""
    problem = plan.task.problem
    X_WH = shown.link_poses[row, list(problem.robot.frame_names).index(problem.hand.frame)]
    return np.asarray(X_WH[:3, :3] @ np.asarray(problem.hand.sideways_H))


def _is_near(body: Body, X_WB: Matrix, view: Camera) -> bool:
    """Returns True if a body has a corner near the centre of a camera's view."""
    if not body.parts:
        return False
    points = vertices_of([(body, X_WB)])
    reach = 1.7 * np.linalg.norm(view.target - view.eye) * np.tan(view.angle / 2)
    return bool((np.linalg.norm(points - view.target, axis=1) < reach).any())
