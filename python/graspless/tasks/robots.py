# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robot of a task: its fields, its files, and the robot itself."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any
from xml.parsers import expat

import numpy as np
from pydantic import Discriminator, Field, Tag, model_validator

from .. import _data
from .meshes import is_mesh
from .shapes import Fields, Pose, pose_matrix
from .source import Source, at

if TYPE_CHECKING:
    from .. import robot as robots
    from ..frames import Matrix


def _kind_of_home(value: Any) -> str:
    return "joints" if isinstance(value, dict) else "all" if isinstance(value, list) else "state"


Home = Annotated[
    Annotated[str, Tag("state")]
    | Annotated[dict[str, float], Tag("joints")]
    | Annotated[list[float], Tag("all")],
    Discriminator(_kind_of_home),
]


class Robot(Fields):
    """Robot of a task, with its pose and start configuration."""

    urdf: str | None = Field(
        default=None,
        description=".urdf or .xacro file, or the name of a robot that comes with graspless",
    )
    urdf_text: str | None = Field(default=None, description="text of the URDF")
    srdf: str | None = Field(
        default=None, description="SRDF file; default: the file of the same name beside the URDF"
    )
    srdf_text: str | None = Field(default=None, description="text of the SRDF")
    packages: dict[str, str] = Field(default={}, description="folder of each package://NAME/")
    directory: str | None = Field(
        default=None,
        description="folder to which relative mesh paths are relative; default: that of the URDF",
    )
    xacro_args: dict[str, str | float | int | bool] = Field(
        default={}, description="arguments of a .xacro file"
    )
    pose: Pose = Field(
        default=Pose.model_construct(), description="pose of the root link in the world"
    )
    home: Home = Field(
        default="home",
        description="configuration at the start: a state of the SRDF, {joint: value} or all joints",
    )

    @model_validator(mode="after")
    def _check(self) -> Robot:
        self.one_of("urdf", "urdf_text")
        self.one_of("srdf", "srdf_text", needed=False)
        return self


def resolve_robot(robot: Robot, source: Source, directory: Path) -> tuple[Robot, Path | None]:
    """Returns the robot with the content of its files, and the folder of its URDF."""
    if robot.urdf is None:
        with at(source, "robot", "urdf_text"):
            robot_meshes(robot)
        return robot, None
    path = directory / robot.urdf
    if not path.is_file():
        built_in = _data.robot(robot.urdf)
        if built_in is None:
            names = ", ".join(_data.robots())
            what = f"no such file, nor a robot that comes with graspless (one of: {names})"
            raise source.error(("robot", "urdf"), what)
        path = built_in
    packages = {name: str((directory / place).resolve()) for name, place in robot.packages.items()}
    for name, place in packages.items():
        if not Path(place).is_dir():
            raise source.error(("robot", "packages", name), "no such folder")
    meshes = directory / robot.directory if robot.directory else path.parent
    if robot.directory and not meshes.is_dir():
        raise source.error(("robot", "directory"), "no such folder")
    srdf = _find_srdf(robot, path, source, directory)
    resolved = robot.model_copy(
        update={
            "urdf": None,
            "urdf_text": _read_xml(path, robot, packages, source, ("robot", "urdf")),
            "srdf": None,
            "srdf_text": robot.srdf_text
            or (srdf and _read_xml(srdf, robot, packages, source, ("robot", "srdf"))),
            "packages": packages,
            "directory": str(meshes.resolve()),
            "xacro_args": {},
        }
    )
    with at(source, "robot", "urdf"):
        robot_meshes(resolved)
    return resolved, path


def _find_srdf(robot: Robot, urdf: Path, source: Source, directory: Path) -> Path | None:
    if robot.srdf_text is not None:
        return None
    if robot.srdf is None:
        beside = (urdf.with_name(f"{stem(urdf)}{end}") for end in (".srdf", ".srdf.xacro"))
        return next((path for path in beside if path.is_file()), None)
    path = directory / robot.srdf
    if not path.is_file():
        raise source.error(("robot", "srdf"), "no such file")
    return path


def stem(path: str | Path) -> str:
    """Returns the name of a robot's file without .urdf, .xacro or both."""
    name = Path(path).name
    for suffix in (".xacro", ".urdf"):
        name = name.removesuffix(suffix)
    return name


def _read_xml(
    path: Path,
    robot: Robot,
    packages: dict[str, str],
    source: Source,
    location: tuple[str, ...],
) -> str:
    try:
        if path.suffix == ".xacro":
            return _expand_xacro(path, robot.xacro_args, packages, source.is_trusted)
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise source.error(location, f"cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise source.error(location, "is not a text file in UTF-8") from None
    except ValueError as error:
        raise source.error(location, str(error)) from None


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


def build_robot(robot: Robot, source: Source) -> robots.Robot:
    from .. import robot as robots

    with at(source, "robot", "urdf" if "urdf" in source.given("robot") else "urdf_text"):
        return robots.Robot.from_urdf(
            robot.urdf_text or "",
            srdf=robot.srdf_text or "",
            packages=robot.packages,
            directory=robot.directory or "",
            X_WB=pose_matrix(robot.pose),
        )


def require_srdf(robot: Robot, source: Source) -> None:
    """Raises TaskError if a resolved robot has no groups and states."""
    if robot.srdf_text is not None:
        return
    name = Path(str(source.data["robot"].get("urdf", ""))).name
    looked = f": looked for {stem(name)}.srdf beside the URDF" if name else ""
    raise source.error(("robot",), f"no SRDF{looked}; it has the groups and states of the hand")


def build_home(
    robot: Robot, built: robots.Robot, source: Source, others: str | None = None
) -> Matrix:
    """[dof] joints of robot.home; those that it leaves out are as in the state `others`, or 0."""
    location = ("robot", "home")
    with at(source, *location):
        if isinstance(robot.home, str):
            return np.array(built.state(robot.home))
    names = list(built.joint_names)
    if isinstance(robot.home, list):
        if len(robot.home) != len(names):
            what = f"has {len(robot.home)} values, not one for each of: {', '.join(names)}"
            raise source.error(location, what)
        return np.array(robot.home)
    with at(source, *location):
        q_home = np.zeros(len(names)) if others is None else np.array(built.state(others))
    for name, value in robot.home.items():
        if name not in names:
            raise source.error((*location, name), f"no such joint (one of: {', '.join(names)})")
        q_home[names.index(name)] = value
    return q_home


def robot_meshes(robot: Robot) -> set[Path]:
    """Returns the existing mesh files of a resolved robot."""
    paths = mesh_files(robot.urdf_text or "", robot.packages, robot.directory)
    return {path for path in paths if is_mesh(path) and path.is_file()}


def mesh_files(urdf: str, packages: dict[str, str], directory: str | None) -> set[Path]:
    """Returns the paths of a URDF's meshes, whether they exist or not.

    Raises
    ------
    ValueError
        The text is one that other readers of XML may understand in another way.
    """
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
    return {mesh_path(name, packages, directory) for name in names}


def mesh_path(name: str, packages: dict[str, str], directory: str | None) -> Path:
    """Returns the path of a URDF's mesh: package://, file://, or relative to `directory`."""
    if name.startswith("package://"):
        package, _, rest = name.removeprefix("package://").partition("/")
        return Path(packages.get(package, package)) / rest.lstrip("/")
    if name.startswith("file://"):
        return Path(name.removeprefix("file://"))
    return Path(directory or ".") / name
