# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robot of a task: its fields, its files, and the robot itself."""

from __future__ import annotations

import re
import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import numpy as np
from pydantic import Discriminator, Field, PrivateAttr, Tag, model_validator

from .._core import robot as robots
from .._xml import parse
from .meshes import is_mesh, mesh_files, mesh_path
from .shapes import Fields, Pose, pose_matrix
from .source import Source, at
from .units import require_limits, warn_of_limits

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ..frames import Matrix


def _kind_of_home(value: Any) -> str:
    return "joints" if isinstance(value, dict) else "all" if isinstance(value, list) else "state"


Home = Annotated[
    Annotated[str, Tag("state")]
    | Annotated[dict[str, float], Tag("joints")]
    | Annotated[list[float], Tag("all")],
    Discriminator(_kind_of_home),
]


class Gripper(Fields):
    """Gripper or hand that is mounted on the robot of a task."""

    file: str | None = Field(default=None, description=".urdf or .xacro file of the gripper")
    name: str | None = Field(
        default=None, description="name of the gripper in the package robot_descriptions"
    )
    mount: str = Field(description="link of the arm that carries the gripper's root link")
    pose: Pose = Field(
        default=Pose.model_construct(), description="pose of the gripper's root link in the mount"
    )
    root: str = Field(
        default="",
        description="link of the gripper's file to mount, with all that it carries; default: all",
    )
    prefix: str = Field(
        default="",
        description="prefix of all names of the gripper; default: gripper_, only for names that "
        "the arm also has",
    )
    srdf: str | None = Field(
        default=None, description="SRDF file; default: the file of the same name beside the URDF"
    )
    packages: dict[str, str] = Field(default={}, description="folder of each package://NAME/")
    xacro_args: dict[str, str | float | int | bool] = Field(
        default={}, description="arguments of a .xacro file"
    )

    @model_validator(mode="after")
    def _check(self) -> Gripper:
        self.one_of("file", "name")
        return self


class Robot(Fields):
    """Robot of a task, with its pose and start configuration."""

    urdf: str | None = Field(
        default=None,
        description=".urdf or .xacro file, or the name of a robot that comes with graspless",
    )
    name: str | None = Field(
        default=None,
        description="name of a robot in the package robot_descriptions, like panda_description",
    )
    arm: str | None = Field(default=None, description="as urdf, of an arm that gets a gripper")
    gripper: Gripper | None = Field(default=None, description="gripper to mount on the arm")
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

    _of_gripper: frozenset[str] = PrivateAttr(default=frozenset())  # names in its files alone
    _srdf_file: Path | None = PrivateAttr(default=None)  # None: its lines are not those of the text

    @model_validator(mode="after")
    def _check(self) -> Robot:
        self.one_of("urdf", "name", "arm", "urdf_text")
        self.one_of("srdf", "srdf_text", needed=False)
        if self.arm is not None and self.gripper is None:
            raise ValueError("arm needs a gripper; write urdf for a robot that has one")
        if self.urdf_text is not None and self.gripper is not None:
            raise ValueError("gripper cannot be mounted on a urdf_text; write arm")
        return self


def stem(path: str | Path) -> str:
    """Returns the name of a robot's file without .urdf, .xacro or both."""
    name = Path(path).name
    for suffix in (".xacro", ".urdf"):
        name = name.removesuffix(suffix)
    return name


def build_robot(robot: Robot, source: Source, *, warn: bool = True) -> robots.Robot:
    """Returns the robot of resolved fields; warns of what was ignored in its files."""
    field = given_field(source)
    with at(source, "robot", field):
        try:
            built = _built(robot)
        except ValueError as error:
            text = _with_srdf(str(error).removeprefix("X_WB "), robot)
            raise source.error(_place(str(error), robot, source), text) from None
    require_limits(built, lambda what: _place(what, robot, source), source)
    if warn and field != "urdf_text":  # a plan was made in spite of them
        _warn_of_what_was_ignored(built, robot, source)
        warn_of_limits(built, lambda what: _place(what, robot, source), source)
    return built


def _warn_of_what_was_ignored(built: robots.Robot, robot: Robot, source: Source) -> None:
    if not built.warnings:
        return
    first, *others = built.warnings
    more = f". Robot.warnings has {len(others)} more" if others else ""
    source.warn(_place(first, robot, source), f"{_with_srdf(first, robot)}{more}")


def _with_srdf(fault: str, robot: Robot) -> str:
    """Returns a fault with the SRDF's file instead of the word SRDF before the line."""
    file = robot._srdf_file
    return fault if file is None else re.sub(r"\bSRDF(?= line \d)", lambda _: str(file), fault)


def _place(fault: str, robot: Robot, source: Source) -> tuple[str, ...]:
    """Returns the field that has a fault, or names the file that has it."""
    if fault.startswith("X_WB"):
        return "robot", "pose"
    place: tuple[str, ...] = ("robot",)
    field = given_field(source)
    named = re.search(r"'(.*?)'", fault)
    if named and named[1] in robot._of_gripper:
        given = source.given("robot", "gripper")
        place, field = ("robot", "gripper"), "file" if "file" in given else "name"
    is_srdf = fault.startswith("SRDF") and "srdf" in source.given(*place)
    return *place, "srdf" if is_srdf else field


def _built(robot: Robot) -> robots.Robot:
    """Returns a known robot, if its mesh files have not changed since, or builds it."""
    X_WB = pose_matrix(robot.pose)
    texts = (robot.urdf_text or "", robot.srdf_text or "", robot.directory or "")
    key = (*texts, tuple(robot.packages.items()), X_WB.tobytes())
    known = _known.get(key)
    if known and known.files == _stamps(known.files):
        return known.robot
    began = time.time_ns()
    built = robots.Robot.from_urdf(
        texts[0], srdf=texts[1], packages=robot.packages, directory=texts[2], X_WB=X_WB
    )
    files = _stamps(collision_meshes(robot))
    if all(stamp and stamp.changed < began - SURE for stamp in files.values()):
        with _lock:
            _known[key] = _Known(built, files)
            while len(_known) > MOST_KNOWN:
                del _known[next(iter(_known))]
    return built


class _Stamp(NamedTuple):
    """A file that is replaced or written to gets another one, whatever its time is set to."""

    device: int
    number: int
    size: int
    changed: int  # content or inode [ns]


class _Known(NamedTuple):
    robot: robots.Robot
    files: dict[Path, _Stamp | None]  # of its collision meshes


MOST_KNOWN = 8  # robots that are kept
SURE = 2_000_000_000  # age above which a file was not written to while it was read [ns]
_known: dict[tuple[Any, ...], _Known] = {}
_lock = threading.Lock()  # of changes


def _stamps(paths: Iterable[Path]) -> dict[Path, _Stamp | None]:
    stamps: dict[Path, _Stamp | None] = {}
    for path in paths:
        try:
            found = path.stat()
        except OSError:
            stamps[path] = None
        else:
            stamps[path] = _Stamp(found.st_dev, found.st_ino, found.st_size, found.st_ctime_ns)
    return stamps


def given_field(source: Source) -> str:
    """Returns the field of `robot` that says which robot it is."""
    given = source.given("robot")
    return next((name for name in ("urdf", "name", "arm") if name in given), "urdf_text")


def require_text(robot: Robot, source: Source) -> None:
    """Raises TaskError if a robot in a plan file names files."""
    if robot.urdf_text is None:
        raise source.error(("robot", given_field(source)), "must be part of the plan file")


def require_srdf(robot: Robot, source: Source) -> None:
    """Raises TaskError if a resolved robot has no groups and states."""
    if robot.srdf_text is not None:
        return
    name = Path(str(source.data["robot"].get(given_field(source), ""))).name
    looked = f": looked for {stem(name)}.srdf beside the URDF" if name else ""
    raise source.error(("robot",), f"no SRDF{looked}; it has the groups and states of the hand")


def build_home(
    robot: Robot, built: robots.Robot, source: Source, others: str | None = None
) -> Matrix:
    """[dof] joints of robot.home; those that it leaves out are as in the state `others`, or 0."""
    location = ("robot", "home")
    with at(source, *location):
        rest = None if others is None else built.state(others)
        if isinstance(robot.home, str):
            try:
                return np.array(built.state(robot.home, rest))
            except ValueError as error:
                raise ValueError(_with_srdf(str(error), robot)) from None
    if isinstance(robot.home, list):
        if len(robot.home) != built.dof:
            names = ", ".join(built.joint_names)
            what = f"has {len(robot.home)} values, not one for each of: {names}"
            raise source.error(location, what)
        return np.array(robot.home)
    q_home = np.zeros(built.dof) if rest is None else np.array(rest)
    for name, value in robot.home.items():
        with at(source, *location, name):
            q_home[built.joint(name)] = value
    return q_home


def robot_meshes(robot: Robot) -> set[Path]:
    """Returns the existing mesh files of a resolved robot."""
    paths = mesh_files(robot.urdf_text or "", robot.packages, robot.directory)
    return {path for path in paths if is_mesh(path) and path.is_file()}


def collision_meshes(robot: Robot) -> set[Path]:
    """Returns the mesh files of the collision shapes of a robot whose XML `mesh_files` accepts."""
    names = [
        mesh.get("filename", "")
        for mesh in parse(robot.urdf_text or "").iterfind(".//collision//mesh")
    ]
    return {mesh_path(name, robot.packages, robot.directory) for name in names}
