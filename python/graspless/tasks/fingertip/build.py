# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of a resolved task to the planner's types."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ... import geometry
from ..._core import fingertip, mechanics
from ..blame import blamed
from ..meshes import require_fetched, stated_triangles
from ..obstacles import build_obstacles
from ..source import at
from .motions import build_motion

if TYPE_CHECKING:
    from ..source import Location, Source
    from . import model

LARGEST = 2.0  # [m]; nobody tumbles a larger object with fingertips
LARGEST_FINGER = 0.5  # radius of a fingertip [m]
MOST_TRIANGLES = 200_000  # of an object


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
        raise blamed(source, _with_pose(str(error)), _places(task)) from None
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
    field = thing.first_of("box", "mesh", "vertices")
    if size.max() > LARGEST:
        what = f"is {size[0]:.4g} x {size[1]:.4g} x {size[2]:.4g} m; lengths are in metres"
        hint = "; of a mesh in millimetres write 'unit: mm'" if field == "mesh" else ""
        source.warn(("object", field), what + hint)
    if (count := _pieces(built.mesh)) > 1:
        what = f"is not one piece: has {count} that share no corner"
        how = "they move as one rigid body, and where they overlap, mass counts twice"
        source.warn(("object", field), f"{what}; {how}")
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
        path = Path(thing.mesh.file)
        require_fetched([path])
        if (count := stated_triangles(path)) > MOST_TRIANGLES:  # reading them takes seconds
            what = f"must have at most {MOST_TRIANGLES} triangles, not {count}"
            raise ValueError(f"mesh '{path}' {what}")
        return geometry.read_mesh(thing.mesh.file, thing.mesh.factors)
    return geometry.Mesh(np.array(thing.vertices), np.array(thing.triangles))


def _rebuilt(thing: model.Object, mass: float) -> fingertip.Object:
    if thing.box is not None:
        return fingertip.Object.box(thing.name, np.array(thing.box), mass)
    return fingertip.Object.from_mesh(thing.name, _mesh(thing), mass)


def _volume(thing: fingertip.Object) -> float:
    """[m^3], by the divergence theorem."""
    corners = np.asarray(thing.mesh.vertices)[np.asarray(thing.mesh.triangles)]
    return float(np.linalg.det(corners).sum() / 6)


def _pieces(mesh: geometry.Mesh) -> int:
    """Returns the number of parts of a closed mesh that share no vertex; cavities are none."""
    triangles = np.asarray(mesh.triangles)
    least = np.arange(len(mesh.vertices))  # number of a vertex of the same part
    while True:
        before = least.copy()
        np.minimum.at(least, triangles, before[triangles].min(axis=1, keepdims=True))
        least = least[least]
        if (least == before).all():
            break
    volumes = np.linalg.det(np.asarray(mesh.vertices)[triangles])
    return int((np.bincount(least[triangles[:, 0]], volumes) > 0).sum())


def _places(task: model.FingertipTask) -> dict[str, Location]:
    """Returns the field of the task file for each part of a problem of the core."""
    motion = task.motion.first_of()
    end = "pose" if motion == "goal" else "goal"
    fields = ("fingers", "friction", "object", "obstacles")
    return {
        **{name: (name,) for name in fields},
        "friction and planes[i].friction": ("friction",),
        "gravity_W": ("gravity",),
        "weight of the object, object.mass times gravity_W": ("object", "mass"),
        "planes": ("floor",),
        **{f"planes[{i}]": ("walls", i - 1) for i in range(1, len(task.walls) + 1)},
        "motion.X_WO": ("motion", motion),
        "X_WO_start": ("motion", motion, "start"),
        "motion.X_WO_start": ("motion", motion, "start"),
        "motion.X_WO_goal": ("motion", motion, end),
        "motion": ("motion", motion),
        "": ("motion", motion),
    }


def _with_pose(message: str) -> str:
    """Returns a message that says the number of the pose in words too: a motion has no poses."""
    return re.sub(r"^(motion\.X_WO\[(\d+)\])( to the next)?:", r"\1: at pose \2\3:", message)
