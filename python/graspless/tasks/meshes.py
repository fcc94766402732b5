# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checksums of mesh files, which are not part of a plan file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable

    from .source import Source


SUFFIXES = (".stl", ".obj", ".off", ".ply")  # that graspless reads


def checksum(path: Path) -> str:
    """sha256 of a file."""
    import hashlib

    sha256 = hashlib.sha256()
    with path.open("rb") as file:
        while block := file.read(2**20):
            sha256.update(block)
    return sha256.hexdigest()


def checksums(paths: Iterable[Path]) -> dict[str, str]:
    """Returns the checksums of meshes by path, for a plan file."""
    return {str(path): checksum(path) for path in sorted(paths)}


def check_files(fields: Any, source: Source) -> None:
    """Raises TaskError if a mesh has changed since the plan was made.

    Opens the meshes of the task's own robots and shapes only: a plan file may come from anybody.
    """
    named = _named(fields.model_dump(exclude_none=True))
    for name, expected in fields.files.items():
        path = Path(name)
        if path not in named or path.suffix.lower() not in SUFFIXES:
            kinds = ", ".join(SUFFIXES)
            what = f"should be a mesh ({kinds}) of the task's robot, object or obstacles"
            raise source.error(("files",), f"{name}: {what}")
        if not path.is_file():
            raise source.error(("files",), f"{name}: no such file, and the plan was made with it")
        if checksum(path) != expected:
            raise source.error(("files",), f"{name}: has changed since the plan was made")


def _named(value: Any) -> set[Path]:
    """Returns the mesh files that the fields of a task name."""
    from .robots import mesh_files

    if isinstance(value, list):
        return set().union(*map(_named, value))
    if not isinstance(value, dict):
        return set()
    found = set().union(*map(_named, value.values()))
    if isinstance(value.get("urdf_text"), str):
        packages, folder = value.get("packages", {}), value.get("directory")
        found |= mesh_files(value["urdf_text"], packages, folder)
    mesh = value.get("mesh")
    if isinstance(mesh, dict) and isinstance(mesh.get("file"), str):
        found.add(Path(mesh["file"]))
    return found
