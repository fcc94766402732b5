# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""trajectory_msgs/JointTrajectory as `ros2 topic pub --yaml-file` reads it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import yaml

from ..errors import TaskError
from . import FORMATS
from .numbers import plain

if TYPE_CHECKING:
    from ..timing import Trajectory


def text(trajectory: Trajectory) -> str:
    """Returns the content of the file."""
    dumper: Any = getattr(yaml, "CSafeDumper", yaml.SafeDumper)
    written: str = yaml.dump(
        message(trajectory), Dumper=dumper, default_flow_style=None, sort_keys=False, width=1000
    )
    return written


def message(trajectory: Trajectory) -> dict[str, Any]:
    """Returns the message in plain types. Raises TaskError if no joints move."""
    if not trajectory.joint_names:
        others = ", ".join(name for name in FORMATS if name != "ros")
        raise TaskError(
            "to: ros: the plan moves no joints, its fingertips have no arm "
            f"(one of these holds fingertips: {others})"
        )
    return {
        "header": {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": ""},
        "joint_names": list(trajectory.joint_names),
        "points": [
            {
                "positions": plain(trajectory.positions[k]),
                "velocities": plain(trajectory.velocities[k]),
                "accelerations": plain(trajectory.accelerations[k]),
                "effort": [],
                "time_from_start": dict(zip(("sec", "nanosec"), seconds(t), strict=True)),
            }
            for k, t in enumerate(trajectory.times)
        ],
    }


def seconds(t: float) -> tuple[int, int]:
    """Seconds and nanoseconds of a time [s]."""
    return divmod(round(float(t) * 1e9), 10**9)
