# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mesh files of a task: their names in a URDF, and their checksums for a plan file."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.parsers import expat

from .._xml import parse
from .source import dotted

if TYPE_CHECKING:
    from collections.abc import Iterable

    from .source import Location, Source


FOREIGN = (".dae", ".glb", ".gltf")  # read with the extra `robots`
SUFFIXES = (".stl", ".obj", ".off", ".ply", *FOREIGN)
_POINTER = b"version https://git-lfs.github.com/"


def is_mesh(path: Path) -> bool:
    """Returns True if the file's ending is that of a mesh; other files are never opened as one."""
    return path.suffix.lower() in SUFFIXES


def prepare_meshes(paths: Iterable[Path]) -> None:
    """Converts the meshes that the core does not read itself by one process, not by one each."""
    if foreign := [path for path in paths if path.suffix.lower() in FOREIGN]:
        from .._mesh_reader import prepare

        prepare(foreign)


def require_fetched(paths: Iterable[Path]) -> None:
    """Raises ValueError if one of the files only points to the mesh in Git LFS."""
    for path in sorted(paths):
        if is_mesh(path) and path.is_file():
            with path.open("rb") as file:
                if file.read(len(_POINTER)) == _POINTER:
                    what = "is a Git LFS pointer, not the mesh itself: get that by 'git lfs pull'"
                    raise ValueError(f"mesh '{path}' {what}")


def stated_triangles(path: Path) -> int:
    """Returns the number of triangles that a binary .stl file states; 0 of any other file."""
    if path.suffix.lower() != ".stl" or not path.is_file():
        return 0
    with path.open("rb") as file:
        count = int.from_bytes(file.read(84)[80:], "little")
    return count if path.stat().st_size == 84 + 50 * count else 0


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
    """Raises TaskError if a mesh has changed since the plan was made, or has no checksum.

    Opens the meshes of the task's own robots and shapes only: a plan file may come from anybody.
    """
    named = _named(fields.model_dump(exclude_none=True))
    unlisted = named.keys() - {Path(name) for name in fields.files}
    if unknown := sorted(path for path in unlisted if is_mesh(path) and path.is_file()):
        what = "was not there when the plan was made: its checksum is missing"
        raise source.error(("files",), f"{unknown[0]}: {what}")
    for path in sorted(unlisted):
        if named[path][-2:] == ("mesh", "file"):  # meshes of a URDF may be missing
            raise source.error(named[path], "is not in task.files")
    for name, expected in fields.files.items():
        path = Path(name)
        if path not in named or not is_mesh(path):
            kinds = ", ".join(SUFFIXES)
            what = f"should be a mesh ({kinds}) of the task's robot, object or obstacles"
            raise source.error(("files",), f"{name}: {what}")
        if not path.is_file():
            raise source.error(("files",), f"{name}: no such file, and the plan was made with it")
        if checksum(path) != expected:
            raise source.error(("files",), f"{name}: has changed since the plan was made")


def mesh_files(urdf: str, packages: dict[str, str], directory: str | None) -> set[Path]:
    """Returns the paths of a URDF's meshes, whether they exist or not.

    Raises
    ------
    ValueError
        The text is one that other readers of XML may understand in another way.
    """
    return {mesh_path(name, packages, directory) for name in _mesh_names(urdf)}


@lru_cache(maxsize=8)
def _mesh_names(urdf: str) -> tuple[str, ...]:
    """Returns the names of a URDF's meshes; raises ValueError as `mesh_files` does."""
    names: list[str] = []

    def start(name: str, attributes: dict[str, str]) -> None:
        if name == "mesh":
            names.append(attributes.get("filename", ""))

    def instruct(_: str, data: str) -> None:
        if "<" in data or ">" in data:
            refuse()

    def refuse(*_: Any) -> None:
        raise ValueError("should have neither a DOCTYPE nor elements in <? ?>")

    reader = expat.ParserCreate()  # without namespaces, which urdfdom does not know
    reader.StartElementHandler = start
    reader.ProcessingInstructionHandler, reader.StartDoctypeDeclHandler = instruct, refuse
    try:
        reader.Parse(urdf, True)
    except expat.ExpatError as error:
        raise ValueError(f"is not well-formed XML: {error}") from None
    return tuple(names)


def package_of(name: str) -> str | None:
    """Returns the package of a mesh's name; None unless that begins with package://."""
    if not name.startswith("package://"):
        return None
    return name.removeprefix("package://").lstrip("/").partition("/")[0]


def packages_of(urdf: str) -> set[str]:
    """Returns the packages of the meshes and textures of a URDF."""
    names = (element.get("filename", "") for element in parse(urdf).iter())
    return {package for name in names if (package := package_of(name))}


def mesh_path(name: str, packages: dict[str, str], directory: str | None) -> Path:
    """Returns the path of a URDF's mesh: package://, file://, or relative to `directory`."""
    if name.startswith("package://"):
        package, _, rest = name.removeprefix("package://").lstrip("/").partition("/")
        return Path(packages.get(package, package)) / rest.lstrip("/")
    if name.startswith("file://"):
        return Path(name.removeprefix("file://"))
    return Path(directory or ".") / name


def _named(value: Any, place: Location = ()) -> dict[Path, Location]:
    """Returns the mesh files that the fields of a task name, and the field of each."""
    found: dict[Path, Location] = {}
    if isinstance(value, list):
        if value and isinstance(value[0], (int, float)):
            return found
        for i, item in enumerate(value):
            found |= _named(item, (*place, i))
        return found
    if not isinstance(value, dict):
        return found
    for key, item in value.items():
        found |= _named(item, (*place, key))
    if isinstance(value.get("urdf_text"), str):
        packages, folder = value.get("packages", {}), value.get("directory")
        try:
            meshes = mesh_files(value["urdf_text"], packages, folder)
        except ValueError as error:
            raise ValueError(f"{dotted((*place, 'urdf_text'))}{error}") from None
        found |= dict.fromkeys(meshes, (*place, "urdf_text"))
    mesh = value.get("mesh")
    if isinstance(mesh, dict) and isinstance(mesh.get("file"), str):
        found[Path(mesh["file"])] = (*place, "mesh", "file")
    return found
