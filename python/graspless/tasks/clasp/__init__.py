# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of the clasp planner."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import scenes
from ..documents import rows_of
from ..effective_values import in_force as _in_force
from ..effective_values import plain
from ..grip import ends_of_curves, warn_of_grip
from ..meshes import checksums
from ..obstacles import obstacle_meshes, resolve_obstacles
from ..proposals import with_proposal
from ..rays import Rays, rays_fields
from ..robot_files import resolve_robot
from ..robots import require_text, robot_meshes
from ..statement import obstacle_fields, pose_fields, pose_of, robot_fields, struct_fields
from .build import build as build_problem
from .build import build_options
from .cloud import resolve_object
from .hand import Hand, hand_in_force, resolve_hand
from .model import ClaspTask, LoopOptions

if TYPE_CHECKING:
    from pathlib import Path

    from ..._core import clasp
    from ..source import Source

SEARCHES = ()
Fields = ClaspTask


def resolve(named: ClaspTask, source: Source, directory: Path) -> tuple[ClaspTask, Source]:
    """Returns the fields with the content of robot, hand and points, and absolute paths of
    meshes; and the source of the hand's fields.
    """
    named = _with_scene(named, source, directory)
    robot, urdf = resolve_robot(named.robot, source, directory)
    given, hand_source = resolve_hand(named.hand, urdf, source, directory)
    robot, hand, note = with_proposal(robot, given, Hand, source)
    obstacles = resolve_obstacles(named.obstacles, source, directory)
    update = {
        "robot": robot,
        "hand": hand,
        "proposed": note,
        "object": resolve_object(named.object, source, directory),
        "obstacles": obstacles,
        "files": checksums(obstacle_meshes(obstacles) | robot_meshes(robot)),
    }
    return named.model_copy(update=update), hand_source


def _with_scene(fields: ClaspTask, source: Source, directory: Path) -> ClaspTask:
    """Returns the task with the points, the pose and the obstacles of its scene."""
    if fields.object.scene is None:
        return fields
    scene = scenes.load(fields.object.scene, source, ("object", "scene"), directory)
    thing = scenes.named(scene.objects, fields.object.name, source, ("object", "name"))
    for warning in thing.warnings:
        source.warn(("object", "name"), warning)
    update = {
        "scene": None,
        "points": rows_of(thing.points),
        "pose": pose_of(thing.X_WO),
        "rays": [Rays.model_validate(rays_fields(image)) for image in thing.rays],
    }
    seen = scenes.obstacles(
        scene, thing, fields.object.respect, has_support=True, padding=fields.object.padding
    )
    return fields.model_copy(
        update={
            "object": fields.object.model_copy(update=update),
            "obstacles": [*fields.obstacles, *seen],
        }
    )


def require_resolved(fields: ClaspTask, source: Source) -> None:
    """Raises TaskError unless fields of a plan file name no file that is not beside it."""
    require_text(fields.robot, source)
    if not isinstance(fields.hand, Hand):
        raise source.error(("hand",), "must be part of the plan file")
    if not isinstance(fields.object.points, list):
        raise source.error(("object", "points"), "must be part of the plan file")


def build(fields: ClaspTask, source: Source, other: Source) -> tuple[clasp.Problem, None]:
    """Returns the problem of resolved fields. `other` is the source of the hand."""
    problem = build_problem(fields, source, other)
    pairs = [ends_of_curves(problem.hand, finger) for finger in problem.hand.fingers]
    warn_of_grip(problem.robot, problem.hand, pairs, source)
    return problem, None


def options(fields: ClaspTask, problem: clasp.Problem, source: Source) -> clasp.Options:
    """Returns the options of the search."""
    return build_options(fields, source)


def in_force(fields: ClaspTask, problem: clasp.Problem, options: clasp.Options) -> dict[str, Any]:
    """Returns the fields with all values in force. The planner derives values given as 0."""
    loops = _in_force(fields.object.loops, problem.object.loop_options)
    stability = _in_force(fields.options.stability, options.stability)
    certificate = _in_force(fields.options.certificate, options.certificate)
    nested = ("stability", "certificate")
    names = [field.name for field in type(options).fields() if field.name not in nested]
    values = {name: getattr(options, name) for name in names}
    return {
        "hand": hand_in_force(problem.hand),
        "object": fields.object.model_copy(update={"loops": loops}),
        "options": type(fields.options)(**values, stability=stability, certificate=certificate),
    }


def state(problem: clasp.Problem, arm: None) -> dict[str, Any]:
    """Returns the task file of a problem, without options and budget."""
    thing = problem.object
    loops = [name for name in LoopOptions.model_fields if name != "threads"]  # changes no loop
    return {
        "robot": robot_fields(problem.robot, problem.q_start),
        "hand": hand_in_force(problem.hand).model_dump(),
        "object": {
            **struct_fields(thing, ["name", "points"]),
            "pose": pose_fields(problem.X_WO),
            "rays": [rays_fields(image) for image in thing.rays],
            "loops": struct_fields(thing.loop_options, loops),
        },
        "clasp": {
            **struct_fields(problem, ["loops", "marks"]),
            "pull": plain(problem.pull_W),
        },
        "obstacles": obstacle_fields(problem.obstacles),
    }
