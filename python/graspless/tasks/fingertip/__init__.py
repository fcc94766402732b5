# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of the fingertip planner."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..force import in_force as _in_force
from .arm import Arm, build_arm
from .build import build as build_problem
from .build import build_options
from .model import FingertipTask
from .resolve import resolve as resolve_files

if TYPE_CHECKING:
    from pathlib import Path

    from ... import fingertip
    from ..source import Source

SEARCHES = ("dijkstra", "paper", "fast")
Fields = FingertipTask


def resolve(named: FingertipTask, source: Source, directory: Path) -> tuple[FingertipTask, Source]:
    """The fields with the robot's files put inline and absolute paths of meshes."""
    return resolve_files(named, source, directory), source


def require_resolved(fields: FingertipTask, source: Source) -> None:
    """Raises TaskError unless fields of a plan file name no file that is not beside it."""
    if fields.robot is not None and fields.robot.urdf is not None:
        raise source.error(("robot", "urdf"), "must stand in the plan file itself")


def build(
    fields: FingertipTask, source: Source, other: Source
) -> tuple[fingertip.Problem, Arm | None]:
    """The problem of resolved fields, and the robot that carries the fingertips."""
    return build_problem(fields, source), build_arm(fields, source)


def options(fields: FingertipTask, problem: fingertip.Problem, source: Source) -> fingertip.Options:
    """How to search; raises TaskError where that would take more memory than it may."""
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


__all__ = [
    "SEARCHES",
    "Arm",
    "Fields",
    "build",
    "in_force",
    "options",
    "require_resolved",
    "resolve",
]
