# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Model of trajectory files, format 1. `trajectory.schema.json` is made from it."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from ..plan_files.table import PoseRow
from ..tasks.shapes import Fields, Point3


class TrajectoryFile(Fields):
    """A plan in time: N samples, n bare fingertips."""

    format: Literal[1]
    kind: str = Field(description="kind of the plan")
    version: str = Field(description="version of graspless that wrote the file")
    duration: float = Field(description="duration [s]")
    joint_names: list[str] = Field(description="names of the columns of positions")
    segments: list[str] = Field(description="names of the segments, in order")
    times: list[float] = Field(description="(N,) times from 0, increasing [s]")
    segment_index: list[int] = Field(description="(N,) index in `segments`")
    rows: list[float] = Field(
        description="(N,) place in that segment of the plan: 2.25 is a quarter of the way from row "
        "2 to row 3; in a regrasp without an arm, from 0 to 1"
    )
    positions: list[list[float]] = Field(description="(N, dof) positions, rad or m")
    velocities: list[list[float]] = Field(description="(N, dof) velocities, rad/s or m/s")
    accelerations: list[list[float]] = Field(description="(N, dof) accelerations, rad/s^2 or m/s^2")
    object_poses: list[PoseRow] = Field(
        description="(N, 7) poses of the object, x y z qw qx qy qz in the world"
    )
    fingers: list[list[Point3 | None]] = Field(
        description="(N, n, 3) contact points of bare fingertips in the world [m]; null while off "
        "the object"
    )


def schema() -> dict[str, Any]:
    """Returns the JSON schema of trajectory files."""
    return TrajectoryFile.model_json_schema()
