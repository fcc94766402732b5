# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Task file of a problem that was made in Python."""

from __future__ import annotations

from enum import Enum
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from ..errors import TaskError
from ..kinds import part
from .effective_values import in_force, plain
from .meshes import checksums
from .robots import robot_meshes
from .shapes import Pose
from .source import Source

if TYPE_CHECKING:
    from collections.abc import Sequence

    from .. import planning
    from ..frames import Matrix

SAME = 1e-9  # [m, rad, N]; poses are written as quaternions


def stated(name: str, problem: Any, options: Any, budget: planning.Budget, arm: Any) -> Any:
    """Returns the fields of a task of kind `name` that was made of a problem.

    Raises
    ------
    TaskError
        A task file cannot state the problem; names the part that it would change.
    """
    kind = part("tasks", name)
    if not hasattr(kind, "state"):
        raise TaskError(f"a problem of kind {name} must come from a task file")
    document = {"kind": name, **kind.state(problem, arm)}
    source = Source("problem", document)
    fields = source.validate(kind.Fields)
    rebuilt, _ = kind.build(fields, source, source)
    if wrong := difference(problem, rebuilt, "problem"):
        raise TaskError(f"{wrong}: no task file can express it, so it cannot be saved or pickled")
    update = kind.in_force(fields, problem, options)
    update["budget"] = in_force(fields.budget, budget)
    if getattr(fields, "robot", None) is not None:
        update["files"] = checksums(robot_meshes(fields.robot))
    return fields.model_copy(update=update)


def robot_fields(robot: Any, q_home: Matrix) -> dict[str, Any]:
    """Returns the robot of a task file: URDF, SRDF, pose and joints."""
    directory = str(Path(robot.directory).resolve()) if robot.directory else None
    return {
        "urdf_text": robot.urdf,
        "srdf_text": robot.srdf or None,
        "packages": dict(robot.packages),
        "directory": directory,
        "pose": pose_fields(robot.X_WB),
        "home": np.asarray(q_home).tolist(),
    }


def pose_fields(X: Matrix) -> dict[str, Any]:
    """Returns a pose as task files write it."""
    row = frames.to_row(X)
    return {"position": row[:3], "quaternion": row[3:]}


def pose_of(X: Matrix) -> Pose:
    """Returns a pose as the field of a task."""
    return Pose(**pose_fields(X))


def obstacle_fields(obstacles: Sequence[Any]) -> list[dict[str, Any]]:
    """Returns obstacles, each of one shape or of several."""
    return [
        {"name": body.name, "pose": pose_fields(body.X_WB)}
        | _shapes(body.shapes)
        | ({"padding": body.padding} if body.padding else {})
        for body in obstacles
    ]


def part_fields(shapes: Sequence[Any]) -> list[dict[str, Any]]:
    """Returns shapes, each with its pose in the frame of the body."""
    return [_shape(placed.shape) | {"pose": pose_fields(placed.X_BG)} for placed in shapes]


def struct_fields(struct: Any, names: Sequence[str]) -> dict[str, Any]:
    """Returns members of a struct of the core in plain types, without infinite values."""
    values = {name: plain(getattr(struct, name)) for name in names}
    return {name: value for name, value in values.items() if value != np.inf}


def _shapes(shapes: Sequence[Any]) -> dict[str, Any]:
    if len(shapes) == 1 and np.array_equal(shapes[0].X_BG, np.eye(4)):
        return _shape(shapes[0].shape)
    return {"parts": part_fields(shapes)}


def _shape(shape: Any) -> dict[str, Any]:
    kind = type(shape).__name__
    if kind == "Box":
        return {"box": plain(shape.size)}
    if kind == "Sphere":
        return {"sphere": {"radius": shape.radius}}
    if kind == "Capsule":
        return {"capsule": {"radius": shape.radius, "length": shape.length}}
    if kind == "Mesh":
        return {"vertices": plain(shape.vertices), "triangles": plain(shape.triangles)}
    return {"convex": plain(shape.vertices)}


def difference(a: Any, b: Any, place: str) -> str | None:
    """Returns the first place where two values of the core differ, or None."""
    if isinstance(a, np.ndarray):
        same = a.shape == np.shape(b) and (np.array_equal(a, b) or _is_near(a, b))
        return None if same else place
    if isinstance(a, float):
        return None if a == b or _is_near(a, b) else place
    if isinstance(a, dict):
        return _first(a, b, place, a) if a.keys() == b.keys() else place
    if isinstance(a, (list, tuple)):
        return _first(a, b, place, range(len(a))) if len(a) == len(b) else place
    if isinstance(a, (str, int, set, Enum, type(None))):
        return None if a == b else place
    if type(a) is not type(b):
        return place
    kind: Any = type(a)
    for name in _properties(kind):
        if wrong := difference(getattr(a, name), getattr(b, name), f"{place}.{name}"):
            return wrong
    return None


def _is_near(a: Any, b: Any) -> bool:
    return bool(np.allclose(a, b, rtol=1e-9, atol=SAME, equal_nan=True))


@cache
def _properties(kind: Any) -> list[str]:
    """Returns the names of a type's properties that tell its values apart."""
    bases = reversed(kind.__mro__)
    named = (pair for base in bases for pair in vars(base).items())
    return [name for name, value in named if isinstance(value, property) and name != "directory"]


def _first(a: Any, b: Any, place: str, keys: Any) -> str | None:
    found = (difference(a[key], b[key], f"{place}[{key!r}]") for key in keys)
    return next((wrong for wrong in found if wrong), None)
