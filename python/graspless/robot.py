# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots read from URDF, and their inverse kinematics."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from ._core.robot import (
    Description,
    Ik,
    Robot,
    find_packages,
    join,
)

if TYPE_CHECKING:
    from ._descriptions import Described
    from .inspection import Proposal


def builtin(name: str) -> Path:
    """Returns the URDF or xacro file of a robot that comes with graspless.

    Parameters
    ----------
    name : str
        wam_t42, wam_t42_tips, kr5_t42, kr5_sdh, kr5_dlr, kr5_icub or kr5_armar.

    Returns
    -------
    pathlib.Path
        The file, for the `robot.urdf` of a task.

    Raises
    ------
    ValueError
        Lists the robots that exist, if `name` is none of them.
    """
    from . import _data
    from .errors import one_of

    path = _data.robot(name)
    if path is None:
        names = one_of(name, _data.robots())
        raise ValueError(f"{name}: no such robot comes with graspless{names}")
    return path


def described(name: str) -> Described:
    """Returns the files of a robot of the package robot_descriptions (extra `robots`).

    Its first use downloads the robot to a cache, `~/.cache/robot_descriptions` or the folder in the
    environment variable ROBOT_DESCRIPTIONS_CACHE. A cache that was filled before works offline.

    Parameters
    ----------
    name : str
        Name of the description, for instance panda_description.

    Returns
    -------
    Described
        Paths of the URDF or xacro file and of the SRDF, and the folders of packages.

    Raises
    ------
    ValueError
        The name is unknown, the robot has no URDF, or cannot be downloaded.
    TaskError
        robot_descriptions is not installed.
    """
    from . import _descriptions
    from .errors import TaskError

    try:
        return _descriptions.described(name)
    except TaskError:
        raise
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None


def inspect(
    robot: Robot | str | Path, *, palm: str | None = None, name: str | None = None
) -> Proposal:
    """Proposes what the planners need besides a URDF: groups, states, frames, hand and pairs.

    Parameters
    ----------
    robot : Robot, str or Path
        A robot, or its .urdf file. What its SRDF defines stays.
    palm : str, optional
        A link of the palm, for a robot with several hands.
    name : str, optional
        Name of the files; that of the URDF by default.

    Returns
    -------
    inspection.Proposal
        Values with their reasons, and the text of the files.

    Raises
    ------
    ValueError
        There is no hand, or there are several and `palm` is not given; or the file cannot be read.
    """
    from .inspection.build import propose
    from .tasks.robots import stem

    if not isinstance(robot, Robot):
        name = stem(robot) if name is None else name
        robot = Robot.from_urdf_file(str(robot))
    return propose(robot, palm, name or robot.name)


__all__ = [
    "Description",
    "Ik",
    "Robot",
    "builtin",
    "described",
    "find_packages",
    "inspect",
    "join",
]


def __dir__() -> list[str]:
    return __all__
