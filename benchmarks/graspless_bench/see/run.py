# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Comparison of what is perceived with the truth."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import perception
from graspless.frames import transform

from . import scenes

if TYPE_CHECKING:
    from collections.abc import Callable

    from graspless import geometry
    from graspless.frames import Matrix

    from ..machine import Row

NEAR = 0.015  # distance from a true edge within which an edge is right [m]
STEP = 0.005  # between samples along edges [m]
NOISES = (0.5, 1.0, 2.0)  # times that of the default camera


def run(
    meshes: dict[str, geometry.Mesh],
    poses: int,
    seed: int,
    tell: Callable[[int], object] = lambda done: None,
) -> list[Row]:
    """Returns one row per mesh, pose, noise and choice of views."""
    rows: list[Row] = []
    for i, (name, read) in enumerate(meshes.items()):
        mesh = scenes.lying(read)
        for pose in range(poses):
            rng = np.random.default_rng([seed, i, pose])
            shot = scenes.shot(mesh, rng)
            for noise in NOISES:
                rows += _rows(shot, noise, name, pose)
        tell(i + 1)
    return rows


def _rows(shot: scenes.Shot, noise: float, name: str, pose: int) -> list[Row]:
    fault = perception.Noise(constant=0.001 * noise, quadratic=0.002 * noise)
    frames = [
        perception.render(shot.bodies, X_WC, noise=fault, seed=100 * pose + k)
        for k, X_WC in enumerate(shot.cameras)
    ]
    views = [perception.View(frame.depth, frame.K, frame.X_WC) for frame in frames]
    rows = []
    for label, chosen in (("1", [0]), ("1", [1]), ("2", [0, 1])):
        begin = time.perf_counter()
        scene = perception.perceive_views([views[k] for k in chosen])
        seconds = time.perf_counter() - begin
        sigma = max(_sigma(shot, frames[k], noise) for k in chosen)
        row = {"mesh": name, "pose": pose, "noise": noise, "views": label, "seconds": seconds}
        row |= {"thickness": shot.thickness, "sigma": sigma}
        rows.append(row | _compare(scene, shot, [frames[k] for k in chosen]))
    return rows


def _sigma(shot: scenes.Shot, frame: perception.Frame, noise: float) -> float:
    """Standard deviation of the depth where the object is [m]."""
    depth = frame.clean[frame.labels == len(shot.bodies) - 1]
    z = float(np.median(depth)) if depth.size else 1.0
    return noise * (0.001 + 0.002 * z**2)


def _compare(
    scene: perception.Scene, shot: scenes.Shot, frames: list[perception.Frame]
) -> dict[str, Any]:
    table = next((s for s in scene.supports if abs(s.X_WS[2, 3] - scenes.HEIGHT) < 0.02), None)
    if table is None:
        return {"table": False, "found": False, "reason": scene.reason}
    row: dict[str, Any] = {
        "table": True,
        "angle": float(np.arccos(min(1.0, table.X_WS[2, 2]))),
        "height_error": _height(table) - scenes.HEIGHT,
        **_edges(table, frames),
    }
    overlaps = [(_overlap(thing, shot), thing) for thing in scene.objects]
    best = max(overlaps, key=lambda pair: pair[0], default=None)
    row["objects"] = len(scene.objects)
    row["found"] = best is not None and best[0] > 0.3
    if best is not None and row["found"]:
        row["iou"] = best[0]
        row["thickness_off"] = best[1].thickness - shot.thickness
        row["thickness_error"] = best[1].thickness_error
        row["is_flat"] = best[1].is_flat
    return row


def _height(table: perception.Support) -> float:
    """Height of the plane at the middle of the table."""
    n, p = table.X_WS[:3, 2], table.X_WS[:3, 3]
    return float((n @ p) / n[2])


def _from_above(corners: Matrix, X: Matrix) -> Matrix:
    """Corners of a polygon in the plane of a frame, as x and y in the world."""
    rows: Matrix = transform(X, np.column_stack([corners, np.zeros(len(corners))]))[:, :2]
    return rows


def _overlap(thing: perception.Object, shot: scenes.Shot) -> float:
    """Intersection over union of outline and silhouette."""
    from matplotlib.path import Path

    ring = _from_above(thing.outline, thing.X_WO)
    places = shot.places.reshape(-1, 2)
    inside = Path(ring).contains_points(places).reshape(shot.silhouette.shape)
    union = np.count_nonzero(inside | shot.silhouette)
    return float(np.count_nonzero(inside & shot.silhouette) / union)


def _edges(table: perception.Support, frames: list[perception.Frame]) -> dict[str, float]:
    """Lengths of edges that are called real, of those that are, and of true edges that were
    visible and were found.
    """
    ring = _from_above(table.polygon, table.X_WS)
    half = np.array(scenes.SIZE) / 2
    box = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half
    truth = _samples(box, [True] * 4)
    real = _samples(ring, [str(label) == "real" for label in table.edges])
    right = np.array([_distance(p, truth) < NEAR for p in real], dtype=bool)
    visible = np.array([any(_is_seen(p, frame) for frame in frames) for p in truth], dtype=bool)
    found = np.array([len(real) > 0 and _distance(p, real) < NEAR for p in truth], dtype=bool)
    return {
        "real": STEP * len(real),
        "real_right": STEP * float(right.sum()),
        "visible": STEP * float(visible.sum()),
        "visible_found": STEP * float((found & visible).sum()),
    }


def _samples(ring: Matrix, wanted: list[bool]) -> Matrix:
    points = [np.empty((0, 2))]
    for a, b, is_wanted in zip(ring, np.roll(ring, -1, axis=0), wanted, strict=True):
        count = max(1, round(float(np.linalg.norm(b - a)) / STEP))
        if is_wanted:
            points.append(a + (np.arange(count)[:, None] + 0.5) / count * (b - a))
    return np.concatenate(points)


def _distance(p: Matrix, points: Matrix) -> float:
    return float(np.linalg.norm(points - p, axis=1).min())


def _is_seen(p: Matrix, frame: perception.Frame) -> bool:
    """True if a point of the table's edge is in the image and nothing hides it."""
    margin = 12  # pixels
    p_C = np.linalg.inv(frame.X_WC) @ [*p, scenes.HEIGHT, 1]
    u, v, _ = frame.K @ p_C[:3] / p_C[2]
    height, width = frame.labels.shape
    if not (margin <= u < width - margin and margin <= v < height - margin):
        return False
    around = frame.labels[round(v) - 4 : round(v) + 5, round(u) - 4 : round(u) + 5]
    return bool((around == 0).any() and not (around > 1).any())
