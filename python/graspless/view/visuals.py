# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading the meshes that a robot looks like; without them its collision shapes are drawn."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

from ..tasks.robots import mesh_path

if TYPE_CHECKING:
    from ..tasks.robots import Robot


class UnreadableError(Exception):
    """A visual mesh that cannot be drawn, and why."""


def read_visual(name: str, robot: Robot) -> Any:
    """The trimesh of a URDF's visual mesh; raises UnreadableError."""
    import trimesh

    package = name.removeprefix("package://").partition("/")[0]
    path = mesh_path(name, robot.packages, robot.directory)
    if not path.is_file():
        known = not name.startswith("package://") or package in robot.packages
        why = "no such file" if known else f"robot.packages has no {package}"
        raise UnreadableError(f"{name}: {why}")
    try:
        mesh: Any = trimesh.load(path, force="mesh")
        if len(mesh.faces):
            return mesh
    except Exception as error:  # its readers raise whatever they stumble over
        first = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise UnreadableError(f"{name}: cannot be read: {first}") from None
    raise UnreadableError(f"{name}: has no triangles")


_warned: set[str] = set()


def warn_once(text: str) -> None:
    """A picture and a replay build the same bodies several times over."""
    if text not in _warned:
        _warned.add(text)
        warnings.warn(text, stacklevel=3)
