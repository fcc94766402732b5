# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trajectory as JSON with a published schema."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import __version__, frames
from .fingers import contacts
from .json_model import TrajectoryFile
from .numbers import plain

if TYPE_CHECKING:
    from ..timing import Trajectory


def text(trajectory: Trajectory) -> str:
    """Returns the content of the file."""
    return document(trajectory).model_dump_json() + "\n"


def document(trajectory: Trajectory) -> TrajectoryFile:
    """Returns the trajectory as an instance of the model."""
    points = [
        [None if np.isnan(p).any() else plain(p) for p in row] for row in contacts(trajectory)
    ]
    return TrajectoryFile(
        format=1,
        kind=trajectory.plan.kind,
        version=__version__,
        duration=trajectory.duration,
        joint_names=list(trajectory.joint_names),
        segments=[str(segment.name) for segment in trajectory.segments],
        times=trajectory.times.tolist(),
        segment_index=trajectory.segment_index.tolist(),
        rows=trajectory.rows.tolist(),
        positions=plain(trajectory.positions),
        velocities=plain(trajectory.velocities),
        accelerations=plain(trajectory.accelerations),
        object_poses=plain(frames.to_rows(trajectory.object_poses)),
        fingers=points,
    )
