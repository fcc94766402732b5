# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading of all files that a task names, so that a plan file needs no other files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from ... import frames
from ...files import absence
from .. import scenes, shapes
from ..clouds import read_cloud
from ..documents import rows_of
from ..meshes import checksums
from ..obstacles import obstacle_meshes, resolve_obstacles
from ..proposals import with_proposal
from ..reading import read_yaml
from ..robot_files import resolve_robot
from ..robots import robot_meshes, stem
from ..shapes import pose_matrix
from ..source import Source
from ..statement import pose_of
from . import model
from .units import LARGEST, warn_of_sizes

if TYPE_CHECKING:
    from ...frames import Matrix


TaskT = TypeVar("TaskT", bound=model.OnSupport)


def resolve(task: TaskT, source: Source, directory: Path) -> tuple[TaskT, Source]:
    """Returns the task with the content of all its files, and absolute paths of meshes.

    Parameters
    ----------
    task : SlideTask or PinchTask
        Task read from `source`.
    source : Source
        Source of the task, for error messages.
    directory : Path
        Folder to which its paths are relative.

    Returns
    -------
    tuple
        The task, and the source of its hand's fields.
    """
    warn_of_sizes(task, source)
    task = _with_scene(task, source, directory)
    robot, urdf = resolve_robot(task.robot, source, directory)
    given, hand_source = _resolve_hand(task.hand, urdf, source, directory)
    robot, hand, note = with_proposal(robot, given, model.Hand, source)
    resolved = task.model_copy(
        update={
            "robot": robot,
            "hand": hand,
            "proposed": note,
            "options": _with_pitch(task.options, hand),
            "object": _resolve_object(task.object, task.support, source, directory),
            "obstacles": resolve_obstacles(task.obstacles, source, directory),
        }
    )
    resolved.files = checksums(obstacle_meshes(resolved.obstacles) | robot_meshes(robot))
    return resolved, hand_source


def _with_scene(task: TaskT, source: Source, directory: Path) -> TaskT:
    """Returns the task with the object, the support and the obstacles of its scene."""
    if task.object.scene is None:
        return task
    scene = scenes.load(task.object.scene, source, ("object", "scene"), directory)
    thing = scenes.named(scene.objects, task.object.name, source, ("object", "name"))
    support = scenes.named(scene.supports, thing.support, source, ("object", "scene"))
    for warning in thing.warnings:
        source.warn(("object", "name"), warning)
    edges = task.support.usable_edges
    if edges is None:
        edges = scenes.real_edges(support, source, ("object", "scene"))
    of_object = {
        "scene": None,
        "polygon": rows_of(thing.outline),
        "thickness": task.object.thickness or thing.thickness,
        "hollow": task.object.hollow is not False,
        "pose": shapes.PlanarPose(**scenes.planar_pose(support.X_WS, thing.X_WO)),
    }
    of_support = {
        "scene": None,
        "polygon": rows_of(support.polygon),
        "pose": pose_of(support.X_WS),
        "usable_edges": edges,
    }
    seen = scenes.obstacles(
        scene, thing, task.object.respect, has_support=False, padding=task.object.padding
    )
    return task.model_copy(
        update={
            "object": task.object.model_copy(update=of_object),
            "support": task.support.model_copy(update=of_support),
            "obstacles": [*task.obstacles, *seen],
        }
    )


def _resolve_hand(
    hand: model.Hand | str | None, urdf: Path | None, source: Source, directory: Path
) -> tuple[model.Hand | None, Source]:
    """The fields of the hand and their source: of its file, but with those in the task."""
    path = urdf and urdf.with_name(f"{stem(urdf)}.hand.yaml")
    if isinstance(hand, str):
        path = directory / hand
        if not path.is_file():
            raise source.error(("hand",), absence(path))
    if path is None or not path.is_file():
        return hand if isinstance(hand, model.Hand) else None, source
    read = read_yaml(path)
    of_file = read.validate(model.Hand)
    if not isinstance(hand, model.Hand):
        return of_file, read
    given = {name: getattr(hand, name) for name in hand.model_fields_set}
    return of_file.model_copy(update=given), read


def _with_pitch(options: Any, hand: model.Hand) -> Any:
    """Returns the options of a slide with the pitch of the hand, unless they have their own."""
    if hand.pitch is None or getattr(options, "pitch", 0.0) is not None:
        return options
    return options.model_copy(update={"pitch": hand.pitch})


def _resolve_object(
    thing: model.Object, support: model.Support, source: Source, directory: Path
) -> model.Object:
    if thing.cloud is None:
        return thing
    location = ("object", "cloud")
    try:
        points = read_cloud(directory / thing.cloud)
    except ValueError as error:
        raise source.error(location, str(error)) from None
    if thing.unit == "mm":
        points = points / 1000
    size = np.ptp(points, axis=0)
    if size.max() > LARGEST:
        what = f"is {size[0]:.4g} x {size[1]:.4g} x {size[2]:.4g} m"
        hint = "if it is in millimetres, write 'unit: mm' beside it; taken as metres"
        source.warn(location, f"{what}; {hint}")
    pose = thing.pose
    if thing.frame == "world":
        p_SP = frames.transform(
            np.asarray(np.linalg.inv(support_pose(support)), dtype=float), points
        )
        center = np.array([*p_SP[:, :2].mean(axis=0), 0.0])
        points, pose = p_SP - center, shapes.PlanarPose(x=center[0], y=center[1])
    return thing.model_copy(
        update={
            "cloud": None,
            "points": rows_of(points),
            "frame": "object",
            "unit": "m",
            "pose": pose,
        }
    )


def support_pose(support: model.Support) -> Matrix:
    """X_WS of a support."""
    if support.pose is not None:
        return pose_matrix(support.pose)
    return frames.translation([0.0, 0.0, support.height or 0.0])
