# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Obstacles that a pick is given beside those of its scene."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..tasks import scenes
from ..tasks.documents import in_plain_types
from ..tasks.obstacles import OF_SCENE, Obstacles, resolve_obstacles
from ..tasks.shapes import Fields
from ..tasks.source import Source
from .result import FILE

if TYPE_CHECKING:
    from ..tasks.shapes import Obstacle


class ObstaclesOnly(Fields):
    """A document with obstacles."""

    obstacles: Obstacles


def obstacles_of(given: Any, name: str) -> list[dict[str, Any]]:
    """Returns the field `obstacles` of a pick of an object, with absolute paths of meshes."""
    source = Source(FILE, {"obstacles": in_plain_types(given)})
    return resolved(source.validate(ObstaclesOnly).obstacles, name, source, Path.cwd())


def resolved(
    obstacles: list[Obstacle], name: str, source: Source, directory: Path
) -> list[dict[str, Any]]:
    """Returns obstacles as documents, with absolute paths of meshes.

    Raises TaskError for one that is called as a body of the scene; `name` is the object's.
    """
    for i, obstacle in enumerate(obstacles):
        is_taken = obstacle.name in ("object", "support", name)
        if is_taken or obstacle.name.startswith((OF_SCENE, scenes.UNSEEN)):
            what = "is the name of a body of the scene; choose another"
            raise source.error(("obstacles", i, "name"), what)
    return documents(resolve_obstacles(obstacles, source, directory))


def documents(obstacles: list[Any]) -> list[dict[str, Any]]:
    """Returns obstacles in the words of task files."""
    return [
        obstacle.model_dump(mode="json", exclude_none=True, exclude_defaults=True)
        for obstacle in obstacles
    ]
