# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Poses in a plane, as rows of x, y [m] and yaw [rad]."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ..frames import Matrix


def compose(X_AB: Matrix, X_BC: Matrix) -> Matrix:
    """Returns X_AC [3]."""
    c, s = np.cos(X_AB[2]), np.sin(X_AB[2])
    x, y, yaw = X_BC
    return np.array([X_AB[0] + c * x - s * y, X_AB[1] + s * x + c * y, wrapped(X_AB[2] + yaw)])


def inverse(X_AB: Matrix) -> Matrix:
    """Returns X_BA [3]."""
    c, s = np.cos(X_AB[2]), np.sin(X_AB[2])
    x, y, yaw = X_AB
    return np.array([-c * x - s * y, s * x - c * y, wrapped(-yaw)])


def wrapped(angle: float) -> float:
    """Returns an angle within [-pi, pi)."""
    return float((angle + np.pi) % (2 * np.pi) - np.pi)


def turned(point: Matrix, pivot: Matrix, step: Matrix) -> Matrix:
    """Returns the transform [3] that turns by step[2] about a pivot [2], then moves by step[:2].

    It acts from the left: on X_AB it gives the pose after that motion in A. `point` is X_AB.
    """
    c, s = np.cos(step[2]), np.sin(step[2])
    x, y = point[:2] - pivot[:2]
    return np.array(
        [
            pivot[0] + c * x - s * y + step[0],
            pivot[1] + s * x + c * y + step[1],
            wrapped(point[2] + step[2]),
        ]
    )


def difference(X_AB: Matrix, X_AC: Matrix) -> Matrix:
    """Returns the motion [3] that takes B to C: displacement in A, and turn."""
    return np.array([*(X_AC[:2] - X_AB[:2]), wrapped(X_AC[2] - X_AB[2])])
