# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Puts every file that a task names inline, so that a plan with its task stands alone."""

from __future__ import annotations

import hashlib
import warnings
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _data, frames
from . import model, shapes
from .clouds import read_cloud
from .source import Source, read_yaml
from .units import LARGEST, warn_of_units

if TYPE_CHECKING:
    from ..frames import Matrix


def resolve(
    task: model.SlideTask, source: Source, directory: Path
) -> tuple[model.SlideTask, Source]:
    """The same task with URDF, SRDF, hand and cloud inline and with absolute paths of meshes.

    Parameters
    ----------
    task : SlideTask
        As read from `source`.
    source : Source
        Where it stands; for errors.
    directory : Path
        What relative paths are relative to.

    Returns
    -------
    tuple of SlideTask and Source
        The task, and where its hand's fields stand.
    """
    warn_of_units(task, source)
    robot, hand_file = _resolve_robot(task.robot, source, directory)
    hand, hand_source = _resolve_hand(task.hand, hand_file, source, directory)
    obstacles = [
        _resolve_obstacle(obstacle, source, i, directory)
        for i, obstacle in enumerate(task.obstacles)
    ]
    resolved = task.model_copy(
        update={
            "robot": robot,
            "hand": hand,
            "object": _resolve_object(task.object, task.support, source, directory),
            "obstacles": obstacles,
        }
    )
    resolved.files = {str(path): checksum(path) for path in sorted(_meshes(resolved))}
    return resolved, hand_source


def checksum(path: Path) -> str:
    """sha256 of a file."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def check_files(task: model.SlideTask, source: Source) -> None:
    """Raises TaskError when a mesh is not what it was when the plan was made."""
    for name, expected in task.files.items():
        path = Path(name)
        if not path.is_file():
            raise source.error(("files",), f"{name}: no such file, and the plan was made with it")
        if checksum(path) != expected:
            raise source.error(("files",), f"{name}: has changed since the plan was made")


def _resolve_robot(
    robot: model.Robot, source: Source, directory: Path
) -> tuple[model.Robot, Path | None]:
    if robot.urdf is None:
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
    return resolved, path.with_name(f"{stem(path)}.hand.yaml")


def _find_srdf(robot: model.Robot, urdf: Path, source: Source, directory: Path) -> Path | None:
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
    """The name of a robot's file without .urdf, .xacro or both."""
    name = Path(path).name
    for suffix in (".xacro", ".urdf"):
        name = name.removesuffix(suffix)
    return name


def _read_xml(
    path: Path,
    robot: model.Robot,
    packages: dict[str, str],
    source: Source,
    location: tuple[str, ...],
) -> str:
    try:
        if path.suffix == ".xacro":
            return _expand_xacro(path, robot.xacro_args, packages)
        return path.read_text(encoding="utf-8")
    except OSError as error:
        raise source.error(location, f"cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise source.error(location, "is not a text file in UTF-8") from None
    except ValueError as error:
        raise source.error(location, str(error)) from None


def _expand_xacro(path: Path, arguments: dict[str, Any], packages: dict[str, str]) -> str:
    """The URDF that a xacro file stands for; $(find NAME) is looked up in `packages` first."""
    try:
        import xacro
        from xacro import substitution_args
    except ImportError:
        raise ValueError("needs xacro to be read: pip install xacro") from None
    words = {
        name: str(value).lower() if isinstance(value, bool) else str(value)
        for name, value in arguments.items()
    }
    find = substitution_args._eval_find
    substitution_args._eval_find = lambda name: packages.get(name) or find(name)
    try:
        return str(xacro.process_file(str(path), mappings=words).toprettyxml(indent="  "))
    except Exception as error:  # xacro raises many kinds, some of them private
        first = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise ValueError(f"xacro cannot expand it: {first}") from None
    finally:
        substitution_args._eval_find = find


def _resolve_hand(
    hand: model.Hand | str | None, beside: Path | None, source: Source, directory: Path
) -> tuple[model.Hand, Source]:
    if isinstance(hand, model.Hand):
        return hand, source
    path = beside
    if isinstance(hand, str):
        path = directory / hand
        if not path.is_file():
            raise source.error(("hand",), "no such file")
    if path is None or not path.is_file():
        return model.Hand(), source
    read = read_yaml(path)
    return read.validate(model.Hand), read


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
        warnings.warn(source.message(location, f"{what}; {hint}"), stacklevel=4)
    pose = thing.pose
    if thing.frame == "world":
        p_SP = _transform(np.linalg.inv(support_pose(support)), points)
        center = np.array([*p_SP[:, :2].mean(axis=0), 0.0])
        points, pose = p_SP - center, shapes.PlanarPose(x=center[0], y=center[1])
    return thing.model_copy(
        update={
            "cloud": None,
            "points": points.tolist(),
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


def pose_matrix(pose: shapes.Pose) -> Matrix:
    """The 4 x 4 matrix of a pose in a file."""
    if pose.quaternion is not None:
        return frames.translation(pose.position) @ frames.from_quaternion(pose.quaternion)
    return frames.translation(pose.position) @ frames.from_rpy(pose.rpy or [0.0, 0.0, 0.0])


def _transform(X_AB: Any, p_BP: Matrix) -> Matrix:
    return np.asarray(p_BP @ X_AB[:3, :3].T + X_AB[:3, 3])


def _resolve_obstacle(
    obstacle: shapes.Obstacle, source: Source, index: int, directory: Path
) -> shapes.Obstacle:
    if obstacle.mesh is None:
        return obstacle
    path = directory / obstacle.mesh.file
    if not path.is_file():
        raise source.error(("obstacles", index, "mesh", "file"), "no such file")
    mesh = obstacle.mesh.model_copy(update={"file": str(path.resolve())})
    return obstacle.model_copy(update={"mesh": mesh})


def _meshes(task: model.SlideTask) -> set[Path]:
    """The mesh files that a resolved task reads; those that exist."""
    found = {Path(obstacle.mesh.file) for obstacle in task.obstacles if obstacle.mesh}
    robot = task.robot
    try:
        names = [
            mesh.get("filename", "") for mesh in ET.fromstring(robot.urdf_text or "").iter("mesh")
        ]
    except ET.ParseError:
        return found  # the robot's reader says what is wrong
    for name in names:
        path = mesh_path(name, robot.packages, robot.directory)
        if path.is_file():
            found.add(path)
    return found


def mesh_path(name: str, packages: dict[str, str], directory: str | None) -> Path:
    """Where a URDF's mesh is: package://NAME/..., file://..., or relative to `directory`."""
    if name.startswith("package://"):
        package, _, rest = name.removeprefix("package://").partition("/")
        return Path(packages.get(package, package)) / rest
    return Path(directory or ".") / name.removeprefix("file://")


__all__ = ["check_files", "mesh_path", "pose_matrix", "resolve", "stem", "support_pose"]
