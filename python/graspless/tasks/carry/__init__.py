# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of carrying."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..clasp.cloud import resolve_object
from ..effective_values import in_force as _in_force
from ..effective_values import plain
from ..meshes import checksums
from ..obstacles import obstacle_meshes, resolve_obstacles
from ..robot_files import resolve_robot
from ..robots import require_text, robot_meshes
from ..statement import (
    obstacle_fields,
    part_fields,
    pose_fields,
    robot_fields,
    struct_fields,
)
from .build import build as build_problem
from .build import build_options
from .model import CarryTask

if TYPE_CHECKING:
    from pathlib import Path

    from ..._core import carry
    from ..source import Source

SEARCHES: tuple[str, ...] = ()
Fields = CarryTask


def resolve(named: CarryTask, source: Source, directory: Path) -> tuple[CarryTask, Source]:
    """Returns the fields with the content of robot and points, and absolute paths of meshes."""
    update: dict[str, Any] = {}
    meshes = set()
    if named.robot is not None:
        update["robot"] = resolve_robot(named.robot, source, directory)[0]
        meshes |= robot_meshes(update["robot"])
    if named.obstacles is not None:
        update["obstacles"] = resolve_obstacles(named.obstacles, source, directory)
        meshes |= obstacle_meshes(update["obstacles"])
    thing = named.object
    for kind in ("slide", "clasp"):
        if thing is not None and getattr(getattr(thing, kind), "scene", None) is not None:
            raise source.error(("object", kind, "scene"), "a carry takes outlines or points")
    if thing is not None and thing.slide is not None and thing.slide.cloud is not None:
        raise source.error(("object", "slide", "cloud"), "a carry takes outlines or points")
    if thing is not None and thing.clasp is not None:
        cloud = resolve_object(thing.clasp, source, directory)
        update["object"] = thing.model_copy(update={"clasp": cloud})
    return named.model_copy(update=update | {"files": checksums(meshes)}), source


def require_resolved(fields: CarryTask, source: Source) -> None:
    """Raises TaskError unless fields of a plan file name no file that is not beside it."""
    if fields.robot is not None:
        require_text(fields.robot, source)
    thing = fields.object
    if thing is not None and thing.clasp is not None and not isinstance(thing.clasp.points, list):
        raise source.error(("object", "clasp", "points"), "must be part of the plan file")


def build(fields: CarryTask, source: Source, other: Source) -> tuple[carry.Problem, None]:
    """Returns the problem of resolved fields."""
    return build_problem(fields, source), None


def options(fields: CarryTask, problem: carry.Problem, source: Source) -> carry.Options:
    """Returns the options of the search."""
    return build_options(fields, source)


def in_force(fields: CarryTask, problem: carry.Problem, options: carry.Options) -> dict[str, Any]:
    """Fields with every value that was in force."""
    return {"options": _in_force(fields.options, options)}


def _aim(problem: carry.Problem) -> dict[str, Any]:
    places = problem.places
    if places is None:
        assert problem.X_WO_goal is not None
        return {"goal": pose_fields(problem.X_WO_goal)}
    poses = [pose_fields(X_WO) for X_WO in places.X_WO]
    return {
        "place": {"on": places.on, "normal": plain(places.normal_W), "poses": poses},
        "open": plain(places.q_open),
        "way_out": plain(places.way_out) or None,
        "down": plain(places.down_O) if places.down_O.any() else None,
    }


def state(problem: carry.Problem, arm: None) -> dict[str, Any]:
    """Returns the task file of a problem, without options and budget."""
    held, X_WO_hanging = problem.object, problem.X_WO_hanging
    return {
        "robot": robot_fields(problem.robot, problem.q_start),
        **struct_fields(problem, ["arm", "frame"]),
        "object": {"name": held.name, "parts": part_fields(held.shapes)},
        "pose": pose_fields(held.X_WB),
        "hanging": None if X_WO_hanging is None else pose_fields(X_WO_hanging),
        **_aim(problem),
        "rests_on": list(problem.rests_on),
        "obstacles": obstacle_fields(problem.obstacles),
    }
