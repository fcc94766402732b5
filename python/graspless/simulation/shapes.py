# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes of tasks as geoms of MuJoCo."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from .. import frames, geometry

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..frames import Matrix


def add_placed(spec: Any, body: Any, placed: geometry.PlacedShape, **given: Any) -> Any:
    """Adds the geom of a placed shape to a body; a mesh becomes its convex hull."""
    shape, X_BG = placed.shape, np.array(placed.X_BG)
    pose = {"pos": X_BG[:3, 3], "quat": frames.to_quaternion(X_BG)}
    if isinstance(shape, geometry.Box):
        size = (np.array(shape.size) / 2).tolist()
        return body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=size, **pose, **given)
    if isinstance(shape, geometry.Sphere):
        size = [shape.radius, 0, 0]
        return body.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=size, **pose, **given)
    if isinstance(shape, geometry.Capsule):
        size = [shape.radius, shape.length / 2, 0]
        return body.add_geom(type=mujoco.mjtGeom.mjGEOM_CAPSULE, size=size, **pose, **given)
    points = frames.transform(X_BG, shape.vertices)
    return add_hull(spec, body, points, given)


def give_inertia(body: Any, mass: float, com: ArrayLike, moments: ArrayLike) -> None:
    """Sets mass [kg], centre of mass [3] [m] and inertia about it [3, 3] [kg m^2] of a body.

    They are in the frame of the body and replace those that follow from its geoms.
    """
    J = np.asarray(moments)
    body.explicitinertial, body.mass, body.ipos = True, mass, com
    body.fullinertia = [*np.diag(J), J[0, 1], J[0, 2], J[1, 2]]


def add_skin(
    spec: Any, name: str, body: str, p_B: Matrix, triangles: ArrayLike, radius: float, **touch: Any
) -> None:
    """Adds a rigid surface of triangles over points [N, 3] of a body.

    MuJoCo would replace a mesh by its convex hull. `radius` is half the thickness of the surface
    [m]; `touch` are its contact parameters.
    """
    spec.add_flex(
        name=name,
        dim=2,
        radius=radius,
        vertbody=[body],
        vert=p_B.ravel().tolist(),
        elem=np.asarray(triangles).ravel().tolist(),
        selfcollide=mujoco.mjtFlexSelf.mjFLEXSELF_NONE,
        **touch,
    )


def add_plane(spec: Any, plane: Any, name: str, **given: Any) -> None:
    """Adds a fingertip.Plane, fixed to the world."""
    normal, quaternion = np.asarray(plane.n_W), np.zeros(4)
    mujoco.mju_quatZ2Vec(quaternion, normal)
    pose = {"pos": plane.offset * normal, "quat": quaternion}
    kind = mujoco.mjtGeom.mjGEOM_PLANE
    spec.worldbody.add_geom(name=name, type=kind, size=[1, 1, 0.1], **pose, **given)


def add_hull(spec: Any, body: Any, points: Matrix, given: dict[str, Any]) -> Any:
    """Adds the convex hull of points [N, 3], in the frame of the body, as a geom."""
    name = f"hull{len(spec.meshes)}"
    spec.add_mesh(name=name, uservert=points.ravel().tolist())
    return body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, **given)
