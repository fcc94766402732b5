# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies of a fingertip plan: object, floor, walls, fingertips and forces."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ... import frames, geometry
from ..bodies import OBJECT, Body, Color, Part, placed_part

if TYPE_CHECKING:
    from ...frames import Matrix
    from ...tasks import Task
    from .moments import Moment

FLOOR: Color = (0.86, 0.83, 0.78)
WALL: Color = (0.62, 0.70, 0.80)
POSITION: Color = (0.12, 0.42, 0.78)
FORCE: Color = (0.84, 0.18, 0.24)
FREE: Color = (0.70, 0.71, 0.73)
ARROW: Color = (0.16, 0.74, 0.45)
MODES = {"position": POSITION, "force": FORCE, "free": FREE}
CONTACT: Color = (0.10, 0.10, 0.12)
LONGEST_ARROW = 0.7  # of the object's size
HEAD_LENGTH, HEAD_RADIUS = 4.5, 2.2  # of the radius of an arrow's shaft
SHARP = 0.3  # an edge between faces that turn more [rad]
TOUCHING = 0.004  # of the size: corners that are no farther from a plane


def object_body(task: Task) -> Body:
    """Returns the object, in O."""
    mesh = task.problem.object.mesh
    corners = np.asarray(mesh.vertices)[np.asarray(mesh.triangles)]
    # Each triangle has its own corners, so that edges stay sharp.
    triangles = np.arange(3 * len(corners)).reshape(-1, 3)
    return Body("object", [Part(corners.reshape(-1, 3), triangles, OBJECT)], is_flat=True)


def floor_body(task: Task, points: Matrix) -> Body:
    """Returns the floor under points in the world [N, 3], cut off behind the walls."""
    height = task.problem.planes[0].offset
    low, high = _extent(task, points)
    thick = 0.02 * float((high - low).max())
    outline = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    ring = np.array(outline)
    for wall in task.problem.planes[1:]:
        ring = _clipped(ring, np.asarray(wall.n_W), float(wall.offset), height)
    if len(ring) < 3:
        return Body("floor")
    ends = [np.insert(ring, 2, z, axis=1) for z in (height - thick, height)]
    return Body("floor", [_hull(np.concatenate(ends), FLOOR)], is_flat=True)


def wall_bodies(task: Task, points: Matrix) -> list[Body]:
    """Returns the walls, as high as the object gets."""
    found = []
    low, high = _extent(task, points)
    height = task.problem.planes[0].offset
    top = height + 1.05 * float(points[:, 2].max() - height)
    for wall in task.problem.planes[1:]:
        normal = np.asarray(wall.n_W)
        level = np.linalg.norm(normal[:2])
        if level < 0.1:  # a ceiling would hide everything
            continue
        found.append(Body(wall.name, [_plate(normal, wall.offset, low, high, height, top)], True))
    return found


def fingertip_body(radius: float, color: Color) -> Body:
    """Returns a fingertip, centred at its frame."""
    import trimesh

    ball = trimesh.creation.uv_sphere(radius, count=(24, 36))
    return Body("fingertip", [Part(np.asarray(ball.vertices), np.asarray(ball.faces), color)])


def arrows(task: Task, moment: Moment, largest: float) -> list[tuple[Body, Matrix]]:
    """Returns arrows of the nominal forces, ending at the fingertips, with poses in the world."""
    size = task.problem.object.size
    found = []
    for tail, tip in arrow_ends(task, moment, largest):
        length = float(np.linalg.norm(tip - tail))
        if length > 1e-6 * size:
            body = Body("force", [_arrow(length, arrow_width(task))])
            found.append((body, _along(tail, tip)))
    return found


def arrow_width(task: Task) -> float:
    """Returns the radius of an arrow's shaft [m]."""
    return float(min(0.018 * task.problem.object.size, 0.4 * task.problem.fingers.radius))


def arrow_ends(task: Task, moment: Moment, largest: float) -> Matrix:
    """Returns tails and tips of the nominal forces' arrows, [n, 2, 3] in the world; equal if zero.

    Parameters
    ----------
    task : Task
    moment : Moment
    largest : float
        Force with the longest arrow [N].
    """
    radius = task.problem.fingers.radius
    scale = LONGEST_ARROW * task.problem.object.size / max(largest, 1e-9)
    found = np.zeros((len(moment.modes), 2, 3))
    for k, (center, force) in enumerate(zip(moment.centers_W, moment.forces_W, strict=True)):
        strength = float(np.linalg.norm(force))
        if moment.modes[k] == "free" or strength < 1e-9:
            continue
        direction = force / strength
        tip = center - radius * direction
        found[k] = tip - scale * strength * direction, tip
    return found


def _extent(task: Task, points: Matrix) -> tuple[Matrix, Matrix]:
    """Returns two opposite corners of the floor, [2] and [2]."""
    margin = 0.22 * task.problem.object.size
    return points[:, :2].min(axis=0) - margin, points[:, :2].max(axis=0) + margin


def _clipped(ring: Matrix, normal: Matrix, offset: float, height: float) -> Matrix:
    """Returns the part of a floor polygon in front of a wall."""
    depth = ring @ normal[:2] + normal[2] * height - offset
    kept: list[Any] = []
    for i in range(len(ring)):
        j = (i + 1) % len(ring)
        if depth[i] >= 0:
            kept.append(ring[i])
        if depth[i] * depth[j] < 0:
            t = depth[i] / (depth[i] - depth[j])
            kept.append(ring[i] + t * (ring[j] - ring[i]))
    return np.array(kept).reshape(-1, 2)


def _hull(vertices: Matrix, color: Color) -> Part:
    """Returns the convex hull of points in the world."""
    return placed_part(geometry.PlacedShape(geometry.Convex(vertices), np.eye(4)), color)


def _plate(
    normal: Matrix, offset: float, low: Matrix, high: Matrix, bottom: float, top: float
) -> Part:
    """Returns a wall across the floor, from the floor up."""
    across = np.array([-normal[1], normal[0], 0.0]) / np.linalg.norm(normal[:2])
    rise = np.cross(normal, across)
    rise *= 1 if rise[2] > 0 else -1
    middle = np.array([*(low + high) / 2, bottom])
    foot = middle + normal * (offset - normal @ middle)
    foot += rise * (bottom - foot[2]) / rise[2]
    corners = np.array([[x, y] for x in (low[0], high[0]) for y in (low[1], high[1])])
    reach = (corners - foot[:2]) @ across[:2]
    span = rise * (top - bottom) / rise[2]
    a, b = foot + across * reach.min(), foot + across * reach.max()
    quad = np.array([a, b, b + span, a + span])
    thick = 0.012 * float(np.linalg.norm(high - low)) * normal
    return _hull(np.concatenate([quad - thick, quad]), WALL)


def _arrow(length: float, width: float) -> Part:
    """Returns an arrow from the origin along z."""
    import trimesh

    head = min(HEAD_LENGTH * width, 0.6 * length)
    shaft = trimesh.creation.cylinder(width, length - head, sections=20)
    shaft.apply_translation([0, 0, (length - head) / 2])
    cone = trimesh.creation.cone(HEAD_RADIUS * width, head, sections=24)
    cone.apply_translation([0, 0, length - head])
    whole: Any = trimesh.util.concatenate([shaft, cone])
    return Part(np.asarray(whole.vertices), np.asarray(whole.faces), ARROW)


def _along(tail: Matrix, tip: Matrix) -> Matrix:
    """Returns the pose at the tail with z towards the tip."""
    z = (tip - tail) / np.linalg.norm(tip - tail)
    x = np.cross(z, [1.0, 0.0, 0.0] if abs(z[0]) < 0.9 else [0.0, 1.0, 0.0])
    x /= np.linalg.norm(x)
    X = frames.translation(tail)
    X[:3, :3] = np.stack([x, np.cross(z, x), z], axis=1)
    return X


def supported(task: Task, X_WO: Matrix) -> Matrix:
    """Returns the object's corners on the floor and the walls, [N, 3] in the world."""
    problem = task.problem
    hull = frames.transform(X_WO, problem.object.hull)
    near = TOUCHING * problem.object.size
    heights = [hull @ np.asarray(plane.n_W) - plane.offset for plane in problem.planes]
    touching = np.any(np.abs(heights) < near, axis=0)
    return np.asarray(np.round(hull[touching], 5), dtype=np.float32)


def edges(task: Task) -> Matrix:
    """Returns the object's edges, [N, 2, 3] in O."""
    import trimesh

    shape = task.problem.object.mesh
    mesh: Any = trimesh.Trimesh(shape.vertices, shape.triangles)
    sharp = mesh.face_adjacency_edges[mesh.face_adjacency_angles > SHARP]
    return np.asarray(mesh.vertices[sharp])
