# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""MuJoCo model of a task: robot, object and surroundings."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np
import trimesh

from .. import frames, geometry
from ..kinds import stages_of
from ..simulation.clasp.surface import inertia, skin
from ..simulation.robots import apply, robot_spec, unused
from ..simulation.settings import Clasp
from ..simulation.shapes import add_skin, give_inertia
from ..simulation.slide.shapes import plate_inertia
from ..tasks.slide.build import build_object as build_slide_object
from ..tasks.source import Source
from ..timing.trajectory import robot_of
from .mujoco_shapes import add_shape
from .mujoco_surroundings import add_surroundings

if TYPE_CHECKING:
    from collections.abc import Callable

    from ..frames import Matrix
    from ..robot import Robot
    from ..tasks import Task
    from ..timing import Trajectory

OBJECT, FINGER, HELD = "object", "finger", "object_held"


def build(trajectory: Trajectory) -> tuple[Any, Robot | None]:
    """Returns the MjSpec of a trajectory's task, and the robot if one moves."""
    stages = stages_of(trajectory.plan)
    task = stages[0].task
    robot: Robot | None = None
    if trajectory.joint_names:
        robot = robot_of(trajectory.plan)
        assert robot is not None
        spec = robot_spec(robot, task.fields.robot)
        _inline_meshes(spec)
    else:
        spec = mujoco.MjSpec()
        apply(spec)
        _add_fingers(spec, task.problem.fingers)
    spec.modelname = f"graspless {task.kind}"
    body = spec.worldbody.add_body(name=unused(spec, OBJECT))
    body.add_freejoint(name=OBJECT)
    _OBJECTS[task.kind](spec, body, task)
    add_surroundings(spec, stages)
    return spec, robot


def _slide(spec: Any, body: Any, task: Task) -> None:
    thing = task.problem.object
    _give_plate_inertia(body, thing)
    for i, placed in enumerate(thing.shapes):
        add_shape(spec, body, f"{OBJECT}_{i}", placed, mass=0)


def _fingertip(spec: Any, body: Any, task: Task) -> None:
    problem, thing = task.problem, task.problem.object
    spec.option.gravity = problem.gravity_W
    friction = float(np.mean(problem.friction))
    give_inertia(body, thing.mass, thing.com, thing.inertia)
    mesh = geometry.PlacedShape(thing.mesh)
    add_shape(spec, body, OBJECT, mesh, mass=0, friction=[friction, 0.005, 0.0001])


def _clasp(spec: Any, body: Any, task: Task) -> None:
    """Adds the surface of a cloud with its holes open, fixed at its initial pose."""
    surface = task.problem.object.loops.surface
    points = np.asarray(surface.points)
    _give_cloud_inertia(body, points, task.fields.object.mass)
    add_skin(spec, OBJECT, OBJECT, points, skin(surface), Clasp().skin)
    X_WO = np.asarray(task.problem.X_WO)
    body.pos, body.quat = X_WO[:3, 3], frames.to_quaternion(X_WO)
    held = spec.add_equality(name=HELD, type=mujoco.mjtEq.mjEQ_WELD)
    held.name1, held.name2, held.objtype = OBJECT, "world", mujoco.mjtObj.mjOBJ_BODY
    held.data[:3] = X_WO[:3, 3]  # the point that is held, in the world: far away, it gives way


def _carry(spec: Any, body: Any, task: Task) -> None:
    """Adds a carried object. A box has MuJoCo's default density, because its task has no mass."""
    fields, shapes = task.fields.object, task.problem.object.shapes
    if fields.slide is not None:
        _give_plate_inertia(body, build_slide_object(fields.slide, Source("plan", {}), thin=False))
    elif fields.clasp is not None:
        surface = np.asarray(shapes[0].shape.vertices)
        _give_cloud_inertia(body, surface, fields.clasp.mass)
    given = {"mass": 0} if body.explicitinertial else {}
    for i, placed in enumerate(shapes):
        add_shape(spec, body, f"{OBJECT}_{i}", placed, **given)


_OBJECTS: dict[str, Callable[[Any, Any, Task], None]] = {
    "slide": _slide,
    "pinch": _slide,
    "fingertip": _fingertip,
    "clasp": _clasp,
    "carry": _carry,
}


def _give_plate_inertia(body: Any, thing: Any) -> None:
    """Sets the inertia that simulations use: uniform density about the plate's centre of mass."""
    give_inertia(
        body, thing.mass, thing.com, plate_inertia(thing.outline, thing.thickness, thing.mass)
    )


def _give_cloud_inertia(body: Any, points: Matrix, mass: float | None) -> None:
    mass = mass or Clasp().mass
    give_inertia(body, mass, points.mean(axis=0), mass * inertia(points))


def finger_names(trajectory: Trajectory) -> list[str]:
    """Returns the names of the bodies of fingertips; none where an arm carries them."""
    if trajectory.joint_names:
        return []
    count = stages_of(trajectory.plan)[0].task.problem.fingers.count
    return [f"{FINGER}{i}" for i in range(count)]


def _add_fingers(spec: Any, fingers: Any) -> None:
    friction = [float(np.mean(fingers.friction)), 0.005, 0.0001]
    for i in range(fingers.count):
        body = spec.worldbody.add_body(name=f"{FINGER}{i}", mocap=True)
        geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[fingers.radius, 0, 0])
        geom.friction, geom.priority = friction, 1  # else MuJoCo takes the larger of two


def _inline_meshes(spec: Any) -> None:
    """Puts the robot's meshes into the model: the file needs none beside it."""
    for mesh in spec.meshes:
        if mesh.file:
            file, kind = mesh.file, None
            if file in spec.assets:
                file, kind = io.BytesIO(spec.assets[file]), "stl"
            loaded: Any = trimesh.load(file, file_type=kind, force="mesh")
            mesh.uservert = np.asarray(loaded.vertices).ravel().tolist()
            mesh.userface = np.asarray(loaded.faces).ravel().tolist()
            mesh.file = ""
