# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Joint motion as plan files write it: rows of joints, and a pose of the object beside each."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import frames
from .model import require_unit_quaternions

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from ..frames import Matrix


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
