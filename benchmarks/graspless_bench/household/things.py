# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as bodies of convex parts, and the poses in which they come to rest on a table."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np
import trimesh

from graspless import frames, geometry
from graspless.simulation.shapes import add_hull, give_inertia
from graspless.simulation.slide.truth import Body

if TYPE_CHECKING:
    from pathlib import Path

    from graspless.frames import Matrix

PARTS = 32  # convex parts of an object, at most
_DROP = 0.02  # height from which an object falls [m]
_FRICTION = (0.5, 0.005, 0.002)  # sliding, spinning and rolling, of an object that comes to rest
_SECONDS = 4.0  # until it lies still
_TIMESTEP = 0.002  # [s]


@dataclass(frozen=True)
class Thing:
    """A mesh with a mass.

    Attributes
    ----------
    name : str
    mesh : trimesh.Trimesh
        In its own frame T [m].
    body : Body
        Convex parts, mass, centre of mass and inertia in T.
    """

    name: str
    mesh: Any
    body: Body


@functools.lru_cache(maxsize=64)
def read(path: Path, mass: float) -> Thing:
    """Reads a mesh of a mass [kg], and takes it apart into convex parts of one density."""
    found = geometry.read_mesh(str(path))
    mesh = trimesh.Trimesh(found.vertices, found.triangles)
    parts = trimesh.decomposition.convex_decomposition(
        mesh, maxConvexHulls=PARTS, resolution=60_000
    )
    solid = [trimesh.Trimesh(**part).convex_hull for part in parts]
    volumes = np.array([part.volume for part in solid])
    shares = mass * volumes / volumes.sum()
    com = sum(m * part.center_mass for m, part in zip(shares, solid, strict=True)) / mass
    inertia = np.zeros((3, 3))
    for m, part in zip(shares, solid, strict=True):
        off = part.center_mass - com
        own = part.moment_inertia * m / max(part.volume, 1e-12)
        inertia += own + m * (off @ off * np.eye(3) - np.outer(off, off))
    hulls = [np.asarray(part["vertices"]) for part in parts]
    return Thing(path.stem, mesh, Body(hulls, mass, com, inertia))


def dropped(thing: Thing, rng: np.random.Generator) -> Matrix:
    """Returns the pose [4, 4] in which a thing rests that fell on z = 0, turned at random."""
    quaternion = rng.normal(size=4)
    X_WT = frames.from_quaternion(quaternion / np.linalg.norm(quaternion))
    X_WT[2, 3] = _DROP - lowest(thing, X_WT)
    spec = mujoco.MjSpec()
    spec.option.timestep = _TIMESTEP
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[1, 1, 0.1])
    body = spec.worldbody.add_body(pos=X_WT[:3, 3], quat=frames.to_quaternion(X_WT))
    give_inertia(body, thing.body.mass, thing.body.com, thing.body.inertia)
    body.add_freejoint()
    for points in thing.body.parts:
        add_hull(spec, body, points, {"condim": 6, "friction": _FRICTION, "priority": 1})
    model = spec.compile()
    data = mujoco.MjData(model)
    for _ in range(round(_SECONDS / _TIMESTEP)):
        mujoco.mj_step(model, data)
    X_WT = frames.from_quaternion(data.qpos[3:7])
    X_WT[2, 3] = -lowest(thing, X_WT)
    return X_WT


def lowest(thing: Thing, X_WT: Matrix) -> float:
    """Returns the height of a thing's lowest point, turned as in a pose, over its origin [m]."""
    return float((np.asarray(thing.mesh.vertices) @ X_WT[2, :3]).min())
