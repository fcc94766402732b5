# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A table: one row a moment, one line of names above."""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING

import numpy as np

from .. import frames
from .fingers import contacts
from .numbers import numbered, plain

if TYPE_CHECKING:
    from ..timing import Trajectory

POSE = ("x", "y", "z", "qw", "qx", "qy", "qz")


def header(trajectory: Trajectory, fingers: int) -> list[str]:
    """Returns the names of the columns."""
    joints = trajectory.joint_names
    return [
        "time",
        "segment",
        *joints,
        *(f"{name}_velocity" for name in joints),
        *(f"object_{name}" for name in POSE),
        *(f"finger_{i}_{axis}" for i in range(fingers) for axis in "xyz"),
    ]


def text(trajectory: Trajectory) -> str:
    """Returns the content of the file."""
    points = contacts(trajectory)
    written = io.StringIO()
    table = csv.writer(written, lineterminator="\n")
    table.writerow(header(trajectory, points.shape[1]))
    for k, name in enumerate(_names(trajectory)):
        numbers = [
            *trajectory.positions[k],
            *trajectory.velocities[k],
            *frames.to_row(trajectory.object_poses[k]),
        ]
        touched = ["" if np.isnan(value) else value for value in plain(points[k].ravel())]
        table.writerow([float(trajectory.times[k]), name, *plain(numbers), *touched])
    return written.getvalue()


def _names(trajectory: Trajectory) -> list[str]:
    """Returns the segment at each moment; numbered in a chain, whose stages may share names."""
    if trajectory.plan.kind != "chain":
        return trajectory.names
    names = numbered(trajectory)
    return [names[i] for i in trajectory.segment_index]
