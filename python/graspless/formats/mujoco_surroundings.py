# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surroundings in a task, or in all stages of a chain, as bodies with the names of the task."""

from __future__ import annotations

from itertools import count
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from ..simulation.chain import obstacles_of
from ..simulation.shapes import add_plane
from .mujoco_shapes import add_shape

if TYPE_CHECKING:
    from .._plan import Plan
    from ..frames import Matrix

TABLE = "table"
_SAME = 1e-6  # planes so near are one [m]


def add_surroundings(spec: Any, stages: list[Plan]) -> None:
    """Tables, planes and obstacles of all stages, each once.

    A plane that is a table's top is left out: it has no end, and the hand is to reach below the
    table's edge.
    """
    tables = _tables(stages)
    for X_WS, shapes in tables:
        _add_fixed(spec, TABLE, shapes, X_WS)
    tops = [(X_WS[:3, 2], float(X_WS[:3, 2] @ X_WS[:3, 3])) for X_WS, _ in tables]
    for plane, friction in _planes(stages, tops):
        given: dict[str, Any] = {"friction": [friction, 0.005, 0.0001]}
        if plane.friction is not None:
            given["priority"] = 1  # else MuJoCo takes the larger friction of plane and object
        add_plane(spec, plane, _free_name(spec.geoms, plane.name), **given)
    for obstacle in obstacles_of(stages):
        _add_fixed(spec, obstacle.name, obstacle.shapes, obstacle.X_WB)


def _tables(stages: list[Plan]) -> list[tuple[Matrix, Any]]:
    """Returns pose and shapes of each support. A carry has the support of the stage before it."""
    found: list[tuple[Matrix, Any]] = []
    known: list[Any] = []
    for stage in stages:
        fields = getattr(stage.task.fields, "support", None)
        if fields is None or fields in known:
            continue
        known.append(fields)
        if hasattr(stage.task.problem, "support"):
            support = stage.task.problem.support
            found.append((np.asarray(support.X_WS), support.shapes))
        else:
            last = stage.task.problem.obstacles[-1]
            found.append((np.asarray(last.X_WB), last.shapes))
    return found


def _planes(stages: list[Plan], known: list[tuple[Matrix, float]]) -> list[tuple[Any, float]]:
    """Returns the new planes of fingertip stages, by normal and offset [m], with friction."""
    found, known = [], list(known)
    for stage in stages:
        problem = stage.task.problem
        for plane in getattr(problem, "planes", ()):
            normal = np.asarray(plane.n_W)
            if not any(
                np.abs(normal - n).max() < _SAME and abs(plane.offset - offset) < _SAME
                for n, offset in known
            ):
                known.append((normal, plane.offset))
                found.append((plane, float(np.mean(plane.friction or problem.friction))))
    return found


def _add_fixed(spec: Any, name: str, shapes: Any, X_WB: Matrix) -> None:
    X, name = np.asarray(X_WB), _free_name(spec.bodies, name)
    body = spec.worldbody.add_body(name=name, pos=X[:3, 3], quat=frames.to_quaternion(X))
    for i, placed in enumerate(shapes):
        add_shape(spec, body, f"{name}_{i}", placed)


def _free_name(taken: Any, name: str) -> str:
    """Stages may have things of one name; the second is NAME_2."""
    names = {thing.name for thing in taken}
    if name not in names:
        return name
    return next(f"{name}_{k}" for k in count(2) if f"{name}_{k}" not in names)
