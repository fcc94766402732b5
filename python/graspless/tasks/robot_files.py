# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of a task's robot: URDF, SRDF, xacro and packages, of an arm and of its gripper."""

from __future__ import annotations

import math
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import _data
from .._core import robot as robots
from .._descriptions import Described, described
from .._xml import parse
from ..errors import one_of
from ..files import absence
from ..limits import uncounted
from . import units
from .meshes import FOREIGN, prepare_meshes, require_fetched
from .robots import Gripper, Robot, collision_meshes, robot_meshes, stem
from .shapes import pose_matrix
from .source import Source, at

if TYPE_CHECKING:
    from .source import Location

FARTHEST = 2.0  # of a gripper from the link that carries it [m]


def resolve_robot(robot: Robot, source: Source, directory: Path) -> tuple[Robot, Path | None]:
    """Returns the robot with the content of its files, and the path of its URDF.

    With a gripper it is the path of the gripper's URDF; None if links of it were renamed or left
    out, because the files beside it have the old names.
    """
    if robot.urdf_text is not None:
        with at(source, "robot", "urdf_text"):
            robot_meshes(robot)
        return robot, None
    field = next(name for name in ("urdf", "name", "arm") if getattr(robot, name) is not None)
    path: Path | None
    description, path, srdf = _read(robot, field, ("robot", field), source, directory)
    of_gripper: frozenset[str] = frozenset()
    if robot.gripper is not None:
        arm = description
        description, path = _with_gripper(arm, robot.gripper, source, directory)
        of_gripper = frozenset(_names(description) - _names(arm))
        srdf = None  # joined from two, as lines of no file
    elif srdf is not None and srdf.suffix == ".xacro":
        srdf = None
    emptied = dict.fromkeys(("urdf", "name", "arm", "gripper", "srdf"))
    resolved = robot.model_copy(
        update=emptied
        | {
            "urdf_text": description.urdf,
            "srdf_text": description.srdf or None,
            "packages": description.packages,
            "directory": description.directory or None,
            "xacro_args": {},
        }
    )
    resolved._of_gripper, resolved._srdf_file = of_gripper, srdf
    with at(source, "robot", field):
        meshes = robot_meshes(resolved)
        require_fetched(meshes & collision_meshes(resolved))
    if any(path.suffix.lower() in FOREIGN for path in meshes):
        prepare_meshes(collision_meshes(resolved))
    return resolved, path


def _with_gripper(
    arm: robots.Description, gripper: Gripper, source: Source, directory: Path
) -> tuple[robots.Description, Path | None]:
    away = math.hypot(*gripper.pose.position)
    if FARTHEST < away <= units.FARTHEST:  # what is farther was warned of
        what = f"is {away:.4g} m away; lengths are in metres"
        source.warn(("robot", "gripper", "pose", "position"), what)
    field = "file" if gripper.file is not None else "name"
    description, path, _ = _read(gripper, field, ("robot", "gripper", field), source, directory)
    with at(source, "robot", "gripper"):
        X_MG = pose_matrix(gripper.pose)
        joined = robots.join(
            arm, description, gripper.mount, X_MG=X_MG, prefix=gripper.prefix, root=gripper.root
        )
        is_whole = not gripper.prefix and not gripper.root
        is_whole = is_whole and not _links(arm) & _links(description)
    return joined, path if is_whole else None


def _links(description: robots.Description) -> set[str]:
    return {link.get("name", "") for link in parse(description.urdf).iterfind("link")}


def _names(description: robots.Description) -> set[str]:
    """Returns the names in the URDF and the SRDF of a robot."""
    texts = [text for text in (description.urdf, description.srdf) if text]
    return {element.get("name", "") for text in texts for element in parse(text).iter()}


def _read(
    given: Robot | Gripper, field: str, place: Location, source: Source, directory: Path
) -> tuple[robots.Description, Path, Path | None]:
    """Returns the texts of a robot, and the paths of its URDF and SRDF."""
    known = find_urdf(getattr(given, field), field, place, source, directory)
    packages = known.packages | _find_packages(given, place[:-1], source, directory)
    meshes = _find_folder(given, place[:-1], source, directory) or known.directory
    arguments = known.xacro_args | given.xacro_args

    def read(file: Path, location: Location) -> str:
        return _read_xml(file, arguments, packages, source, location)

    place_srdf = (*place[:-1], "srdf")
    srdf = _find_srdf(given, known, place_srdf, source, directory)
    description = robots.Description(
        read(known.urdf, place),
        srdf=getattr(given, "srdf_text", None) or (read(srdf, place_srdf) if srdf else ""),
        packages=packages,
        directory=str(meshes.resolve()),
    )
    with at(source, *place):
        description.packages = robots.find_packages(description)
    return description, known.urdf, srdf


def find_urdf(name: str, field: str, place: Location, source: Source, directory: Path) -> Described:
    """Returns the files of the robot in a field of a task: urdf, arm, file or name.

    Raises TaskError that names the place if there is no such robot.
    """
    path = directory / name
    if field != "name" and path.is_file():
        return Described(path, path.parent)
    built_in = _data.robot(name)
    if built_in is not None:
        return Described(built_in, built_in.parent)
    if field == "name":
        with at(source, *place), uncounted():  # it may download
            return described(name)
    if path.is_dir():
        inside = list(path.glob("*.urdf"))
        hint = f"; did you mean {Path(name, inside[0].name)}?" if len(inside) == 1 else ""
        raise source.error(place, f"{absence(path)}{hint}")
    names = _data.robots()
    what = f"no such file, nor a robot that comes with graspless{one_of(Path(name).name, names)}"
    raise source.error(place, what)


def _find_packages(
    given: Robot | Gripper, place: Location, source: Source, directory: Path
) -> dict[str, str]:
    packages = {name: str((directory / path).resolve()) for name, path in given.packages.items()}
    for name, path in packages.items():
        if not Path(path).is_dir():
            raise source.error((*place, "packages", name), "no such folder")
    return packages


def _find_folder(
    given: Robot | Gripper, place: Location, source: Source, directory: Path
) -> Path | None:
    """Returns the folder that `directory` names."""
    if not isinstance(given, Robot) or not given.directory:
        return None
    path = directory / given.directory
    if not path.is_dir():
        raise source.error((*place, "directory"), "no such folder")
    return path


def _find_srdf(
    given: Robot | Gripper, known: Described, place: Location, source: Source, directory: Path
) -> Path | None:
    if getattr(given, "srdf_text", None) is not None:
        return None
    if given.srdf is None:
        if known.srdf is not None:
            return known.srdf
        name = stem(known.urdf)
        beside = (known.urdf.with_name(f"{name}{end}") for end in (".srdf", ".srdf.xacro"))
        return next((path for path in beside if path.is_file()), None)
    path = directory / given.srdf
    if not path.is_file():
        raise source.error(place, absence(path))
    return path


def _read_xml(
    path: Path,
    arguments: dict[str, Any],
    packages: dict[str, str],
    source: Source,
    location: Location,
) -> str:
    try:
        if path.suffix == ".xacro":
            return _expand_xacro(path, arguments, packages, source.is_trusted)
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        if error.errno is None:  # a TimeoutError of the program
            raise
        raise source.error(location, f"cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise source.error(location, "is not a text file in UTF-8") from None
    except ValueError as error:
        raise source.error(location, str(error)) from None
    if not text.strip():
        raise source.error(location, f"{path.name} is empty")
    return text


def _expand_xacro(
    path: Path, arguments: dict[str, Any], packages: dict[str, str], trust: bool
) -> str:
    """Returns the URDF of a xacro file."""
    from .xacro_process import expand

    if find_spec("xacro") is None:
        raise ValueError("needs xacro to be read: pip install xacro")
    words = {
        name: str(value).lower() if isinstance(value, bool) else str(value)
        for name, value in arguments.items()
    }
    return expand(path, words, packages, trust)
