# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a robot's visual meshes; without them, its collision shapes are drawn."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any

from .. import _mesh_reader
from ..errors import warn
from ..tasks.meshes import FOREIGN, SUFFIXES, is_mesh, mesh_path, package_of

if TYPE_CHECKING:
    from pathlib import Path

    from ..tasks.robots import Robot


class UnreadableError(Exception):
    """A visual mesh cannot be drawn; the message says why."""


def read_visual(name: str, robot: Robot) -> Any:
    """Returns the trimesh of a URDF's visual mesh; raises UnreadableError."""
    package = package_of(name)
    path = mesh_path(name, robot.packages, robot.directory)
    if not is_mesh(path):
        raise UnreadableError(f"{name}: unknown kind of mesh (one of: {', '.join(SUFFIXES)})")
    if not path.is_file():
        known = package is None or package in robot.packages
        why = "no such file" if known else f"robot.packages has no {package}"
        raise UnreadableError(f"{name}: {why}")
    return _read(path, path.stat().st_mtime_ns, name).copy()


@functools.lru_cache(maxsize=128)  # each stage of a chain builds the robot anew
def _read(path: Path, _changed: int, name: str) -> Any:
    import trimesh

    if path.suffix.lower() in FOREIGN:
        try:
            read = _mesh_reader.read(str(path))
        except ValueError as error:
            why = str(error).removeprefix(f"mesh '{path}' ")
            raise UnreadableError(f"{name}: {why}") from None
        return trimesh.Trimesh(read.vertices, read.triangles, process=False)
    try:
        mesh: Any = trimesh.load(path, force="mesh")
        if len(mesh.faces):
            return mesh
    except Exception as error:  # its readers raise exceptions of many types
        first = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise UnreadableError(f"{name}: cannot be read: {first}") from None
    raise UnreadableError(f"{name}: has no triangles")


_warned: set[str] = set()


def warn_once(text: str) -> None:
    """Warns once: a picture and a replay build the same bodies several times."""
    if text not in _warned:
        _warned.add(text)
        warn(text)
