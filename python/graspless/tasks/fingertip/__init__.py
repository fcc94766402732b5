# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of the fingertip planner."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...errors import TaskError
from ..effective_values import in_force as _in_force
from ..effective_values import plain
from ..robots import require_text
from ..statement import obstacle_fields, robot_fields, struct_fields
from .arm import Arm, build_arm
from .build import build as build_problem
from .build import build_options
from .model import Carrier, Fingers, FingertipTask, Realize
from .motions import motion_fields
from .resolve import resolve as resolve_files

if TYPE_CHECKING:
    from pathlib import Path

    from ..._core import fingertip
    from ..source import Source

SEARCHES = ("dijkstra", "paper", "fast")
Fields = FingertipTask


def resolve(named: FingertipTask, source: Source, directory: Path) -> tuple[FingertipTask, Source]:
    """Returns the fields with the content of the robot's files, and absolute paths of meshes."""
    return resolve_files(named, source, directory), source


def require_resolved(fields: FingertipTask, source: Source) -> None:
    """Raises TaskError unless fields of a plan file name no file that is not beside it."""
    if fields.robot is not None:
        require_text(fields.robot, source)


def build(
    fields: FingertipTask, source: Source, other: Source
) -> tuple[fingertip.Problem, Arm | None]:
    """Returns the problem of resolved fields, and the robot that carries the fingertips."""
    return build_problem(fields, source), build_arm(fields, source)


def options(fields: FingertipTask, problem: fingertip.Problem, source: Source) -> fingertip.Options:
    """Returns the options. Raises TaskError if the search would need more memory than allowed."""
    return build_options(fields, problem, source)


def in_force(
    fields: FingertipTask, problem: fingertip.Problem, options: fingertip.Options
) -> dict[str, Any]:
    """Fields with every value that was in force; no directions are the paper's."""
    compliance = _in_force(fields.options.compliance, options.compliance)
    given = {"compliance": compliance, "disturbance_directions": None}
    names = [name for name in type(fields.options).model_fields if name not in given]
    values = {name: getattr(options, name) for name in names}
    values |= {"search": options.search.name}
    update = values | {
        "compliance": compliance,
        "disturbance_directions": fields.options.disturbance_directions,
    }
    return {"options": type(fields.options)(**update)}


def state(problem: fingertip.Problem, arm: Arm | None) -> dict[str, Any]:
    """Returns the task file of a problem, without options and budget."""
    thing = problem.object
    if not problem.planes:
        raise TaskError("problem.planes: must hold the floor at least, but is empty")
    floor, *walls = problem.planes
    stated = {
        "object": {
            **struct_fields(thing, ["name", "mass", "com", "inertia"]),
            **struct_fields(thing.mesh, ["vertices", "triangles"]),
        },
        "fingers": struct_fields(problem.fingers, list(Fingers.model_fields)),
        "floor": {"height": floor.offset, **_own_friction(floor)},
        "walls": [
            {"normal": plain(w.n_W), "name": w.name, "offset": w.offset, **_own_friction(w)}
            for w in walls
        ],
        "friction": list(problem.friction),
        "gravity": plain(problem.gravity_W),
        "motion": motion_fields(problem.motion),
        "obstacles": obstacle_fields(problem.obstacles),
    }
    if arm is not None:
        stated["robot"] = robot_fields(arm.robot, arm.q_home)
        stated["carrier"] = struct_fields(arm.carrier, list(Carrier.model_fields))
        stated["realize"] = struct_fields(arm.options, list(Realize.model_fields))
    return stated


def _own_friction(plane: fingertip.Plane) -> dict[str, Any]:
    return {} if plane.friction is None else {"friction": list(plane.friction)}
