# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Object, surroundings and bare fingertips of a plan as plain shapes.

They are those of the MuJoCo model, for formats that have no use for the model itself.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np
import trimesh

from .. import frames
from .mujoco_scene import OBJECT, build

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..frames import Matrix
    from ..robot import Robot
    from ..timing import Trajectory

_KINDS = {
    mujoco.mjtGeom.mjGEOM_BOX: "box",
    mujoco.mjtGeom.mjGEOM_SPHERE: "sphere",
    mujoco.mjtGeom.mjGEOM_CAPSULE: "capsule",
    mujoco.mjtGeom.mjGEOM_MESH: "mesh",
    mujoco.mjtGeom.mjGEOM_PLANE: "plane",
}


@dataclass(frozen=True)
class Shape:
    """One shape of a thing.

    Attributes
    ----------
    kind : str
        box, sphere, capsule, mesh, plane (which has z as its normal) or surface (a mesh whose holes
        are open).
    size : list of float
        box: lengths; sphere: radius; capsule: radius and length without its ends [m].
    X_BG : array [4, 4]
        Pose in the thing.
    vertices, triangles : array [V, 3], array [T, 3]
        Of a mesh or surface, in G; empty for others.
    friction : float
        Coefficient of sliding friction.
    """

    kind: str
    size: list[float]
    X_BG: Matrix
    vertices: Matrix
    triangles: NDArray[np.int64]
    friction: float


@dataclass(frozen=True)
class Thing:
    """A body that is not of the robot.

    Attributes
    ----------
    name : str
        As in the MuJoCo model.
    X_WB : array [4, 4]
        Pose in the world; of the object and of fingertips, at the start.
    shapes : list of Shape
    mass : float
        [kg]; 0 for surroundings.
    com : array [3]
        Centre of mass [m].
    moments : array [3, 3]
        Inertia about it, in the axes of the thing [kg m^2].
    """

    name: str
    X_WB: Matrix
    shapes: list[Shape]
    mass: float
    com: Matrix
    moments: Matrix


def things(trajectory: Trajectory) -> tuple[list[Thing], Robot | None]:
    """Returns the object, bare fingertips and surroundings of a task, and the robot that moves."""
    spec, robot = build(trajectory)
    model = spec.compile()
    links = set() if robot is None else set(robot.frame_names)
    found = [
        _thing(spec, model, body)
        for body in spec.bodies
        if body.name not in links and body.name != "world"
    ]
    for geom in spec.worldbody.geoms:
        if geom.type == mujoco.mjtGeom.mjGEOM_PLANE:
            zero = np.zeros((3, 3))
            found.append(Thing(geom.name, np.eye(4), [_shape(spec, geom)], 0.0, zero[0], zero))
    return found, robot


def _thing(spec: Any, model: Any, body: Any) -> Thing:
    compiled = model.body(body.name)
    is_fixed = compiled.weldid[0] == 0 and not compiled.mocapid[0] >= 0
    R = frames.from_quaternion(compiled.iquat)[:3, :3]
    shapes = [_shape(spec, geom) for geom in body.geoms]
    if body.name == OBJECT:
        shapes += [_surface(flex) for flex in spec.flexes]
    return Thing(
        body.name,
        frames.translation(body.pos) @ frames.from_quaternion(body.quat),
        shapes,
        0.0 if is_fixed else float(compiled.mass[0]),
        np.array(compiled.ipos),
        R @ np.diag(compiled.inertia) @ R.T,
    )


def _shape(spec: Any, geom: Any) -> Shape:
    kind = _KINDS[geom.type]
    x, y, z = (float(half) for half in geom.size)
    sizes = {"box": [2 * x, 2 * y, 2 * z], "sphere": [x], "capsule": [x, 2 * y]}
    vertices, triangles = np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64)
    if kind == "mesh":
        mesh = spec.mesh(geom.meshname)
        vertices = np.array(mesh.uservert).reshape(-1, 3)
        triangles = np.array(mesh.userface, dtype=np.int64).reshape(-1, 3)
        if not len(triangles):
            hull = trimesh.Trimesh(vertices).convex_hull
            vertices, triangles = np.asarray(hull.vertices), np.asarray(hull.faces)
    X_BG = frames.translation(geom.pos) @ frames.from_quaternion(geom.quat)
    friction = float(geom.friction[0])
    return Shape(kind, sizes.get(kind, []), X_BG, vertices, triangles, friction)


def _surface(flex: Any) -> Shape:
    vertices = np.array(flex.vert).reshape(-1, 3)
    triangles = np.array(flex.elem, dtype=np.int64).reshape(-1, 3)
    return Shape("surface", [], np.eye(4), vertices, triangles, float(flex.friction[0]))
