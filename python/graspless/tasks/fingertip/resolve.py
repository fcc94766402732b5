# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts every file that a task names inline or, meshes, by absolute path and checksum."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...files import absence
from ..meshes import checksums
from ..obstacles import obstacle_meshes, resolve_obstacles
from ..robot_files import resolve_robot
from ..robots import robot_meshes

if TYPE_CHECKING:
    from pathlib import Path

    from ..source import Source
    from . import model


def resolve(task: model.FingertipTask, source: Source, directory: Path) -> model.FingertipTask:
    """Returns the task with the content of the robot's files, and absolute paths of meshes.

    Parameters
    ----------
    task : FingertipTask
        Task read from `source`.
    source : Source
        Source of the task, for error messages.
    directory : Path
        Folder to which its paths are relative.
    """
    thing, robot = task.object, task.robot
    meshes: set[Path] = set()
    if thing.mesh is not None:
        path = (directory / thing.mesh.file).resolve()
        if not path.is_file():
            raise source.error(("object", "mesh", "file"), absence(path))
        meshes.add(path)
        mesh = thing.mesh.model_copy(update={"file": str(path)})
        thing = thing.model_copy(update={"mesh": mesh})
    if robot is not None:
        robot = resolve_robot(robot, source, directory)[0]
        meshes |= robot_meshes(robot)
    obstacles = resolve_obstacles(task.obstacles, source, directory)
    meshes |= obstacle_meshes(obstacles)
    update = {"object": thing, "robot": robot, "obstacles": obstacles, "files": checksums(meshes)}
    return task.model_copy(update=update)
