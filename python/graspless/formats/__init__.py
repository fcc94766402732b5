# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans in the files of other programs."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from .. import files
from .._arguments import require_choice
from ..errors import TaskError, missing
from ..simulation import require_mujoco
from ..timing import Trajectory, time
from ..timing.rates import MOST_MOMENTS
from ..timing.settings import LONGEST

if TYPE_CHECKING:
    from .._plan import Plan
    from ..robot import Robot

FORMATS = {
    "ros": "trajectory_msgs/JointTrajectory as YAML, for ros2 topic pub --yaml-file",
    "mcap": "ROS 2 messages in an MCAP file, or a rosbag2 folder",
    "csv": "a table, one row a moment",
    "mujoco": "MJCF of the task with keyframes",
    "json": "the trajectory, by trajectory.schema.json",
    "drake": "a folder: model directives and PiecewisePolynomials",
    "rrd": "a recording for rerun",
}
ENDINGS = {  # of files; any that is no other format's will do, too
    "ros": (".yaml", ".yml"),
    "mcap": (".mcap",),
    "csv": (".csv",),
    "mujoco": (".xml", ".mjcf"),
    "json": (".json",),
    "drake": (),  # a folder
    "rrd": (".rrd",),
}
EXTRAS = {"mcap": "ros", "mujoco": "sim", "drake": "sim", "rrd": "rerun"}  # the others: timing
SCENES = ("mujoco", "drake", "rrd")  # hold the whole robot, object and surroundings
NOT_TEXT = ("mcap", "drake", "rrd")


class Format(Protocol):
    """Interface of the modules of this package, which have one of the two."""

    def text(self, trajectory: Trajectory) -> str:
        """Returns the content of a text file."""

    def write(self, trajectory: Trajectory, path: Path | str) -> None:
        """Writes a format of NOT_TEXT, whole or not at all."""


def export(
    plan: Plan | Trajectory | str | Path,
    path: str | Path,
    to: str,
    *,
    rate: float | None = None,
    robot: Robot | None = None,
    group: str | None = None,
    **limits: Any,
) -> Trajectory:
    """Times a plan and writes it for other programs.

    Parameters
    ----------
    plan : Plan, Trajectory, str or Path
        A solved plan, or the path of its file. It is not checked: `check` does that. Or a result of
        `time`, which is written as it is: rate, robot and limits must not be given with it.
    path : str or Path
        The file; written whole or not at all. `mcap`: without the ending .mcap, a new folder.
        `drake`: a new folder. An ending of another format is refused.
    to : str
        ros, mcap, csv, mujoco, json, drake or rrd: see docs/export.md.
    rate : float, optional
        Samples per second. Default 100.
    robot : Robot, optional
        As in `time`.
    group : str, optional
        Group of the SRDF, such as arm or hand: only its joints are written, for a controller of
        their own. Default: all joints. Not of `mujoco`, `drake` and `rrd`.
    **limits
        As in `time`: max_velocity, max_acceleration, max_jerk, contact_speed, pause, fingers.

    Returns
    -------
    Trajectory
        The trajectory that was written.

    Raises
    ------
    TaskError
        The format is unknown, the file has the ending of another format, the plan cannot be
        timed or lacks data that the format needs, or the file cannot be written.
    """
    writer = _writer(to)
    files.check_writable(path)
    _check_ending(path, to)
    trajectory = _timed(plan, to, group, robot=robot, rate=rate, **limits)
    if to in NOT_TEXT:
        writer.write(trajectory, path)
    else:
        files.write(path, writer.text(trajectory))
    return trajectory


def text(
    plan: Plan | Trajectory | str | Path,
    to: str,
    *,
    rate: float | None = None,
    robot: Robot | None = None,
    group: str | None = None,
    **limits: Any,
) -> tuple[Trajectory, str]:
    """Returns the trajectory and the content of the file that `export` writes in a text format."""
    if to in NOT_TEXT:
        raise TaskError(
            f"to: {to}: is not text: should have a {'folder' if to == 'drake' else 'file'}"
        )
    writer = _writer(to)
    trajectory = _timed(plan, to, group, robot=robot, rate=rate, **limits)
    return trajectory, writer.text(trajectory)


def _timed(
    plan: Plan | Trajectory | str | Path, to: str, group: str | None, **settings: Any
) -> Trajectory:
    """Returns the timed plan, for all joints or those of a group."""
    if group is not None and to in SCENES:
        raise TaskError(f"group: {group}: {to} holds the whole robot")
    if isinstance(plan, Trajectory):
        _require_timed(plan, to, settings)
        trajectory = plan
    else:
        trajectory = time(plan, **settings)
    return trajectory if group is None else trajectory.of_group(group)


def _require_timed(trajectory: Trajectory, to: str, settings: dict[str, Any]) -> None:
    """Raises TaskError if a format cannot hold a trajectory, or settings of `time` are given."""
    if given := [name for name, value in settings.items() if value is not None]:
        raise TaskError(f"{given[0]}: must not be given with a Trajectory, which is timed already")
    times = trajectory.times
    if len(times) > MOST_MOMENTS or times[-1] > LONGEST:
        what = f"{len(times)} samples and {times[-1]:.3g} s"
        raise TaskError(f"plan: has {what}: at most {MOST_MOMENTS} and {LONGEST} s can be written")
    if times[0] < 0 or (np.diff(times) <= 0).any():
        raise TaskError("plan: its times should begin at 0 or later, and increase")
    if to in SCENES and trajectory.is_of_group:
        raise TaskError(f"plan: a Trajectory of a group; {to} holds the whole robot")


def _check_ending(path: str | Path, to: str) -> None:
    """Raises TaskError if the ending of the file belongs to another format."""
    suffix = Path(path).suffix.lower()
    if suffix in ENDINGS[to] or not any(suffix in others for others in ENDINGS.values()):
        return
    other = next(name for name, endings in ENDINGS.items() if suffix in endings)
    folder = ["a folder's name"] if to in ("mcap", "drake") else []
    own = " or ".join([*ENDINGS[to], *folder])
    raise TaskError(f"{path}: {suffix} is the ending of {other}: should be {own} (to: {to})")


def _writer(to: str) -> Format:
    require_choice("to", to, FORMATS)
    try:
        if to in SCENES:
            require_mujoco()
        writer: Format = importlib.import_module(f".{to}", __name__)
    except ImportError as error:
        raise missing(error, EXTRAS.get(to, "timing")) from None
    return writer


__all__ = ["FORMATS", "export"]
