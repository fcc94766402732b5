# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Joint motion as plan files write it: rows of joints, and a pose of the object beside each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from .model import require_unit_quaternions

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from ..frames import Matrix


@dataclass(frozen=True)
class Segment:
    """A stretch of motion.

    Attributes
    ----------
    name : str
        What goes on.
    positions : array [N, dof]
        All joints [rad or m].
    object_poses : array [N, 4, 4]
        X_WO at each row.
    """

    name: str
    positions: Matrix
    object_poses: Matrix

    def __len__(self) -> int:
        return len(self.positions)


def segments(fields: Any) -> list[Segment]:
    """The segments of a plan file with joint_names."""
    dof = len(fields.joint_names)
    return [
        Segment(segment.name, positions(segment.positions, dof), poses(segment.object_poses))
        for segment in fields.segments
    ]


def segment_documents(found: Any) -> list[dict[str, Any]]:
    """The segments that a planner found, as they stand in a plan file."""
    return [
        {
            "name": segment.name,
            "positions": to_rows(segment.positions),
            "object_poses": [frames.to_row(X_WO) for X_WO in segment.object_poses],
        }
        for segment in found.segments
    ]


def positions(rows: Sequence[Sequence[float]], dof: int) -> Matrix:
    """[N, dof] of a file's rows."""
    return np.array(rows, dtype=float).reshape(-1, dof)


def poses(rows: Sequence[Sequence[float]]) -> Matrix:
    """[N, 4, 4] of a file's rows: x y z qw qx qy qz."""
    return np.array([frames.from_row(row) for row in rows]).reshape(-1, 4, 4)


def to_rows(values: ArrayLike) -> list[list[float]]:
    """Rows of numbers in plain types."""
    rows: list[list[float]] = np.asarray(values, dtype=float).tolist()
    return rows


def require_rows(
    where: str, joint_rows: list[list[float]], object_poses: list[list[float]], dof: int
) -> None:
    """Raises unless there is one value a joint in each row, and one pose a row."""
    if len(joint_rows) != len(object_poses):
        counts = f"{len(joint_rows)} positions and {len(object_poses)} poses"
        raise ValueError(f"{where} has {counts}: one a row are needed")
    for i, row in enumerate(joint_rows):
        if len(row) != dof:
            raise ValueError(f"row {i} of {where} has {len(row)} values for {dof} joint_names")
    require_unit_quaternions(object_poses)
