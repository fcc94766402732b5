# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of a resolved task to the planner's types."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from ... import geometry
from ..._core import fingertip, mechanics
from ...errors import TaskError
from ..obstacles import build_obstacles
from ..source import at
from .motions import build_motion

if TYPE_CHECKING:
    from ..source import Location, Source
    from . import model

LARGEST = 2.0  # [m]; nobody tumbles a larger object with fingertips
LARGEST_FINGER = 0.5  # radius of a fingertip [m]


def build(task: model.FingertipTask, source: Source) -> fingertip.Problem:
    """Returns the problem of a resolved task. Error messages name the place in `source`."""
    thing = build_object(task.object, source)
    planes = build_planes(task, source)
    with at(source, "gravity"):
        problem = fingertip.Problem(
            object=thing,
            fingers=build_fingers(task.fingers, source),
            planes=planes,
            friction=build_friction(task.friction),
            motion=build_motion(task.motion, thing, planes[0], source),
            obstacles=build_obstacles(task.obstacles, source),
            gravity_W=np.array(task.gravity),
        )
    try:
        fingertip.validate(problem)
    except ValueError as error:
        raise source.error(*_blamed(str(error), task)) from None
    return problem


def build_object(thing: model.Object, source: Source) -> fingertip.Object:
    """Returns the object with its mass, centre of mass and inertia."""
    mass = 1.0 if thing.mass is None else thing.mass
    if thing.box is not None:
        with at(source, "object", "box"):
            built = fingertip.Object.box(thing.name, np.array(thing.box), mass)
    else:
        field = "mesh" if thing.mesh is not None else "triangles"
        with at(source, "object", field):
            built = fingertip.Object.from_mesh(thing.name, _mesh(thing), mass)
    size = np.ptp(np.asarray(built.hull), axis=0)
    field = next(name for name in ("box", "mesh", "vertices") if getattr(thing, name) is not None)
    if size.max() > LARGEST:
        what = f"is {size[0]:.4g} x {size[1]:.4g} x {size[2]:.4g} m; lengths are in metres"
        hint = "; of a mesh in millimetres write 'unit: mm'" if field == "mesh" else ""
        source.warn(("object", field), what + hint)
    if thing.density is not None:
        with at(source, "object", "density"):
            built = _rebuilt(thing, thing.density * _volume(built))
    if thing.com is not None:
        with at(source, "object", "com"):
            built = built.with_com(np.array(thing.com))
    if thing.inertia is not None:
        with at(source, "object", "inertia"):
            inertia = np.array(thing.inertia, dtype=float)
            built = built.with_inertia(np.diag(inertia) if inertia.ndim == 1 else inertia)
    return built


def build_planes(task: model.FingertipTask, source: Source) -> list[fingertip.Plane]:
    """Returns the floor, then the walls."""
    friction = build_own_friction(task.floor.friction)
    planes = [fingertip.Plane("floor", np.array([0.0, 0.0, 1.0]), task.floor.height, friction)]
    for i, wall in enumerate(task.walls):
        normal = np.array(wall.normal)
        length = float(np.linalg.norm(normal))
        if length < 1e-9:
            raise source.error(("walls", i, "normal"), f"{wall.normal}: must not be zero")
        if abs(length - 1) > 1e-6:
            what = f"{wall.normal}: has length {length:.4g}, not 1; it is normalised"
            source.warn(("walls", i, "normal"), what)
        normal /= length
        # An offset is along the unit normal, as it says.
        offset = float(normal @ wall.point) if wall.point is not None else wall.offset or 0.0
        with at(source, "walls", i):
            friction = build_own_friction(wall.friction)
            planes.append(fingertip.Plane(wall.name, normal, offset, friction))
    return planes


def build_fingers(fingers: model.Fingers, source: Source) -> fingertip.Fingers:
    """Returns the fingertips."""
    if fingers.radius > LARGEST_FINGER:
        what = "is the radius of a fingertip; lengths are in metres"
        source.warn(("fingers", "radius"), what)
    span = {} if fingers.max_span is None else {"max_span": fingers.max_span}
    return fingertip.Fingers(
        **span,
        start=fingers.start,
        count=fingers.count,
        radius=fingers.radius,
        max_normal_force=fingers.max_normal_force,
        friction=build_friction(fingers.friction),
    )


def build_friction(friction: float | list[float]) -> tuple[float, float]:
    """Lower and upper bound of a coefficient."""
    lower, upper = friction if isinstance(friction, list) else (friction, friction)
    return lower, upper


def build_own_friction(friction: float | list[float] | None) -> tuple[float, float] | None:
    """Bounds of a plane's own coefficient; None: that of the task."""
    return None if friction is None else build_friction(friction)


def build_options(
    task: model.FingertipTask, problem: fingertip.Problem, source: Source
) -> fingertip.Options:
    """Returns the options of a task. Missing fields have the defaults of the library."""
    fields = task.options.model_dump(exclude_none=True)
    if "search" in fields:
        fields["search"] = fingertip.Search.__members__[fields["search"]]
    if "disturbance_directions" in fields:
        fields["disturbance_directions"] = np.array(fields["disturbance_directions"])
    fields["compliance"] = mechanics.Compliance(**fields["compliance"])
    with at(source, "options"):
        options = fingertip.Options(**fields)
        fingertip.validate(options)
    return options


def _mesh(thing: model.Object) -> geometry.Mesh:
    if thing.mesh is not None:
        scale = np.array(thing.mesh.scale) * (0.001 if thing.mesh.unit == "mm" else 1.0)
        return geometry.read_mesh(thing.mesh.file, scale)
    return geometry.Mesh(np.array(thing.vertices), np.array(thing.triangles))


def _rebuilt(thing: model.Object, mass: float) -> fingertip.Object:
    if thing.box is not None:
        return fingertip.Object.box(thing.name, np.array(thing.box), mass)
    return fingertip.Object.from_mesh(thing.name, _mesh(thing), mass)


def _volume(thing: fingertip.Object) -> float:
    """[m^3], by the divergence theorem."""
    corners = np.asarray(thing.mesh.vertices)[np.asarray(thing.mesh.triangles)]
    return float(np.linalg.det(corners).sum() / 6)


# What the core calls a part of a motion, and what it is called in a task file.
_ENDS = {"X_WO_start": "start", "X_WO_goal": "goal"}


def _blamed(message: str, task: model.FingertipTask) -> tuple[Location, str]:
    """Splits a message of fingertip.validate() into the field of the task file and the rest."""
    motion = next(iter(task.motion.model_fields_set))
    named = re.match(r"(?:motion\.)?(X_WO_start|X_WO_goal): (.*)", message, re.DOTALL)
    if named is not None:
        end = "pose" if motion == "goal" and named[1] == "X_WO_goal" else _ENDS[named[1]]
        return ("motion", motion, end), named[2]
    named = re.match(r"motion\.X_WO\[(\d+)\]( to the next)?: (.*)", message, re.DOTALL)
    if named is not None:
        where = ("motion", "path", int(named[1])) if motion == "path" else ("motion", motion)
        return where, f"at pose {named[1]}{named[2] or ''}: {named[3]}"
    named = re.match(r"motion\.(\w+): (.*)", message, re.DOTALL)
    if named is not None and named[1] in type(getattr(task.motion, motion)).model_fields:
        return ("motion", motion, named[1]), named[2]
    plane = re.match(r"planes\[(\d+)\]", message)
    if plane is not None:
        index = int(plane[1])
        return (("walls", index - 1) if index else ("floor",)), message
    named = re.match(r"([a-z]+)(?:\.([a-z_]+))?", message)
    if named is not None and named[1] in type(task).model_fields and named[1] != "motion":
        fields = getattr(type(getattr(task, named[1])), "model_fields", {})
        return ((named[1], named[2]) if named[2] in fields else (named[1],)), message
    return ("motion", motion), message.removeprefix("motion: ")


__all__ = ["TaskError", "build", "build_options"]
