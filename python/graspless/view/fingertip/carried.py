# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robot that moves the fingertips, at some moments of its joint motion."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ... import frames
from .. import raster
from ..bodies import obstacles, robot, vertices_of
from ..raster import Camera
from . import bodies

if TYPE_CHECKING:
    from ...fingertip import JointSegment, Plan
    from ...frames import Matrix

MOST = 4  # pictures
CLEAR = 0.3  # distance of the arm from the line of sight beyond which it hides nothing [m]


def moments(plan: Plan) -> list[tuple[JointSegment, int, str]]:
    """Returns rows of joint segments to draw, with captions."""
    carrying = [
        s
        for s in plan.joint_segments
        if s.plan_segment >= 0 and plan.segments[s.plan_segment].name != "regrasp" and len(s)
    ]
    if not carrying:
        return []
    found: list[tuple[JointSegment, int, str]] = [
        (plan.joint_segments[0], 0, "robot: start"),
        (carrying[0], 0, "robot: first grip"),
    ]
    found += [(s, len(s) // 2, f"robot: {s.name}") for s in carrying[: MOST - 3]]
    return [*found, (carrying[-1], len(carrying[-1]) - 1, "robot: goal")]


def render(plan: Plan, direction: Matrix, shape: tuple[int, int]) -> list[tuple[Matrix, str]]:
    """Renders each moment; returns pictures with captions.

    Parameters
    ----------
    plan : Plan
        With joint segments.
    direction : array [3]
        From the object to the viewer, turned about z where the arm would hide the object.
    shape : tuple of int
        Width and height of a picture.
    """
    shown = moments(plan)
    task = plan.task
    links = robot(task)
    thing = bodies.object_body(task)
    placed, arms = [], []
    for segment, row, _ in shown:
        poses = np.asarray(task.arm.robot.forward(segment.positions[row]))
        arms.append(_along(poses[:, :3, 3]) - segment.object_poses[row][:3, 3])
        there = [(body, X_WL) for body, X_WL in zip(links, poses, strict=True) if body.parts]
        placed.append([*there, (thing, segment.object_poses[row])])
    points = vertices_of(body for scene in placed for body in scene)
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    toward = _unhidden(arms, direction / np.linalg.norm(direction), task.problem.object.size)
    eye = middle + 4.0 * float(np.ptp(points, axis=0).max()) * toward
    on_floor = points[points[:, 2] < task.problem.planes[0].offset + task.problem.object.size]
    floor = bodies.floor_body(task, on_floor)
    camera = Camera(eye, middle).fitted(points, *shape)
    still = [(floor, np.eye(4)), *obstacles(task)]
    return [
        (raster.render([*still, *scene], camera, *shape), caption)
        for scene, (_, _, caption) in zip(placed, shown, strict=True)
    ]


def _along(origins: Matrix) -> Matrix:
    """Returns points on the lines between successive frames of an arm, [N, 3]."""
    shares = np.linspace(0, 1, 20)[:, None, None]
    points: Matrix = origins[:-1] + shares * np.diff(origins, axis=0)
    return points.reshape(-1, 3)


def _unhidden(arms: list[Matrix], toward: Matrix, size: float) -> Matrix:
    """Returns a direction to the viewer with no arm before the object, turned as little as can be.

    `arms` are points relative to the object, which is `size` large; `toward` [3] is turned.
    """
    turns = sorted(np.radians(np.arange(-180, 180, 15)), key=abs)
    sides = [frames.from_rpy([0, 0, turn])[:3, :3] @ toward for turn in turns]
    return max(sides, key=lambda side: min(_clearance(arm, side, size) for arm in arms))


def _clearance(points: Matrix, toward: Matrix, size: float) -> float:
    """Returns the distance of points before the object from its line of sight, up to CLEAR [m]."""
    before = points[points @ toward > size]
    return float(np.linalg.norm(np.cross(before, toward), axis=1).min(initial=CLEAR))
