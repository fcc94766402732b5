# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holes of objects that a depth camera saw, compared with the truth."""

from __future__ import annotations

import math
import time
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless import frames, geometry, perception

from . import own, scenes
from .truth import Openings

if TYPE_CHECKING:
    from collections.abc import Callable

    from graspless.frames import Matrix

    from ..machine import Row

NAMES = (
    "mug",
    "pitcher",
    "cup",
    "bowl",
    "scissors",
    "plate",
    "box",
    "bag of two handles",
    "chair",
)
SIDES = 8
NOISES = (0.0, 0.5, 1.0, 1.5, 2.0)  # times that of the default camera; 0: no fault at all
NEAREST = 0.6  # distance of a camera [m]
AROUND = 3.0  # and in radii of the object


def run(names: list[str], tell: Callable[[int], object] = lambda done: None) -> list[Row]:
    """Returns one row per object, side, noise and number of views."""
    rows: list[Row] = []
    for i, name in enumerate(names):
        shape = own.by_name()[name]
        mesh = standing(own.mesh_of(shape))
        openings = Openings(mesh)
        for side in range(SIDES):
            for noise in NOISES:
                rows += _rows(name, shape.holes, mesh, openings, side, noise)
        tell(i + 1)
    return rows


def standing(mesh: geometry.Mesh) -> geometry.Mesh:
    """Returns a mesh as it is, on the plane z = 0 about the z axis."""
    points = np.asarray(mesh.vertices)
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    middle[2] = points[:, 2].min()
    return geometry.Mesh(points - middle, mesh.triangles)


def _rows(
    name: str, holes: int, mesh: geometry.Mesh, openings: Openings, side: int, noise: float
) -> list[Row]:
    X_WO = frames.translation([0, 0, scenes.HEIGHT])
    thing = perception.Body([geometry.PlacedShape(mesh)], X_WO)
    views = [
        _view([*scenes.surroundings(), thing], camera, noise, 10 * side + k)
        for k, camera in enumerate(_cameras(mesh, side))
    ]
    rows = []
    for count in (1, 2):
        begin = time.perf_counter()
        scene = perception.perceive_views(views[:count])
        loops = _loops(scene)
        row = {"object": name, "holes": holes, "side": side, "noise": noise, "views": count}
        row["seconds"] = time.perf_counter() - begin
        rows.append(row | _judged(loops, holes, openings))
    return rows


def _cameras(mesh: geometry.Mesh, side: int) -> list[Matrix]:
    """Returns two cameras: from one of the sides, and from a third of a turn farther."""
    points = np.asarray(mesh.vertices)
    middle = np.array([0, 0, points[:, 2].max() / 2 + scenes.HEIGHT])
    distance = max(NEAREST, AROUND * float(np.linalg.norm(points, axis=1).max()))
    up = math.radians(25 if side % 2 else 45)
    cameras = []
    for turn in (0.0, 2 * math.pi / 3):
        angle = 2 * math.pi * side / SIDES + turn
        level = math.cos(up) * np.array([math.cos(angle), math.sin(angle)])
        cameras.append(
            perception.look_at(middle + distance * np.array([*level, math.sin(up)]), middle)
        )
    return cameras


def _view(
    bodies: list[perception.Body], camera: Matrix, noise: float, seed: int
) -> perception.View:
    fault = perception.Noise(constant=0.001 * noise, quadratic=0.002 * noise)
    fault = fault if noise else perception.Noise.none()
    frame = perception.render(bodies, camera, noise=fault, seed=seed)
    return perception.View(frame.depth, frame.K, frame.X_WC)


def _loops(scene: perception.Scene) -> list[Matrix]:
    """Returns the loops of all objects, in the frame of the mesh."""
    found = []
    for thing in scene.objects:
        try:
            loops = geometry.shortest_loops(thing.points, rays=list(thing.rays))
        except ValueError:  # hardly any points
            continue
        for loop in loops.found:
            p_W = frames.transform(thing.X_WO, loop.points)
            found.append(p_W - [0, 0, scenes.HEIGHT])
    return found


def _judged(loops: list[Matrix], holes: int, openings: Openings) -> Row:
    true = sum(openings.has(loop) for loop in loops)
    wrong = len(loops) - true + max(0, true - holes)
    verdict = "wrong" if wrong else "right" if true == holes else "uncertain"
    return {"found": len(loops), "wrong": wrong, "verdict": verdict}


def sums(of: list[Row], name: str) -> Row:
    """Returns the number of views with each verdict, and the median time [s]."""
    row: Row = {"name": name, "scenes": len(of)}
    row |= {v: sum(row["verdict"] == v for row in of) for v in ("right", "uncertain", "wrong")}
    row["seconds"] = float(np.median([row["seconds"] for row in of]))
    return row


def tables(rows: list[Row]) -> dict[str, list[Row]]:
    """Returns sums by object, and by noise, with one view and two."""
    result: dict[str, list[Any]] = {"objects": [], "noises": []}
    for views in (1, 2):
        some = [row for row in rows if row["views"] == views]
        for name in dict.fromkeys(row["object"] for row in some):
            of = [row for row in some if row["object"] == name]
            result["objects"].append({**sums(of, name), "views": views, "holes": of[0]["holes"]})
        for noise in dict.fromkeys(row["noise"] for row in some):
            of = [row for row in some if row["noise"] == noise]
            result["noises"].append({**sums(of, f"{noise:g}"), "views": views})
    return result
