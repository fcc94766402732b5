# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversions of poses: 4 x 4 matrices, angles, quaternions, and rows of plan files."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ._core import geometry
from .errors import TaskError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    Matrix = NDArray[np.float64]


def _three(name: str, given: ArrayLike) -> Matrix:
    """Returns an array [3]; raises TaskError unless it has this shape."""
    array = np.asarray(given, dtype=float)
    if array.shape != (3,):
        raise TaskError(f"{name}: shape {array.shape}: should be three numbers")
    return array


def translation(p_AB: ArrayLike) -> Matrix:
    """Returns X_AB without rotation.

    Parameters
    ----------
    p_AB : array [3]
        Origin of B in A [m].

    Raises
    ------
    TaskError
        It has another shape.
    """
    X_AB = np.eye(4)
    X_AB[:3, 3] = _three("p_AB", p_AB)
    return X_AB


def transform(X_AB: ArrayLike, p_BP: ArrayLike) -> Matrix:
    """Returns points in A, [N, 3] or [3] as given [m].

    Parameters
    ----------
    X_AB : array [4, 4]
        Pose of B in A.
    p_BP : array [N, 3] or [3]
        Points in B [m].
    """
    X = np.asarray(X_AB, dtype=float)
    return np.asarray(np.asarray(p_BP, dtype=float) @ X[:3, :3].T + X[:3, 3])


def planar(x: float, y: float, yaw: float) -> Matrix:
    """Returns the 4 x 4 pose at x, y [m] and yaw [rad] in the plane z = 0."""
    return translation([x, y, 0.0]) @ from_rpy([0.0, 0.0, yaw])


def from_rpy(rpy: ArrayLike) -> Matrix:
    """Returns the 4 x 4 rotation Rz(yaw) Ry(pitch) Rx(roll) of `rpy` [3], as in URDF [rad].

    Raises TaskError unless there are three angles.
    """
    rpy = _three("rpy", rpy)
    (cr, cp, cy), (sr, sp, sy) = map(math.cos, rpy), map(math.sin, rpy)
    X_AB = np.eye(4)
    X_AB[:3, :3] = [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
    return X_AB


def to_rpy(X_AB: ArrayLike) -> Matrix:
    """Returns roll, pitch and yaw [3] of a 4 x 4 pose, as in URDF [rad].

    The pitch lies in [-pi/2, pi/2]. At its ends, where only roll - yaw or roll + yaw is defined,
    the yaw is 0.
    """
    R = np.asarray(X_AB, dtype=float)[:3, :3]
    level = float(np.hypot(R[0, 0], R[1, 0]))
    pitch = np.arctan2(-R[2, 0], level)
    if level < 1e-9:
        return np.array([np.arctan2(-R[1, 2], R[1, 1]), pitch, 0.0])
    return np.array([np.arctan2(R[2, 1], R[2, 2]), pitch, np.arctan2(R[1, 0], R[0, 0])])


def from_quaternion(wxyz: ArrayLike) -> Matrix:
    """Returns the rotations [..., 4, 4] of quaternions [..., 4] (w, x, y, z), normalised first.

    Raises TaskError for another shape, and for the quaternion 0.
    """
    q = np.asarray(wxyz, dtype=float)
    if q.shape[-1:] != (4,):
        raise TaskError(f"wxyz: shape {q.shape}: should be (..., 4)")
    if not q.any(axis=-1).all():
        raise TaskError("wxyz: a quaternion of length 0 is no rotation")
    X_AB: Matrix = geometry.rotations(q.reshape(-1, 4)).reshape(*q.shape[:-1], 4, 4)
    return X_AB


def to_quaternion(X_AB: ArrayLike) -> Matrix:
    """Returns the unit quaternions [..., 4] (w, x, y, z), w >= 0, of poses [..., 4, 4]."""
    X = np.asarray(X_AB, dtype=float)
    if X.shape[-2:] != (4, 4):
        raise TaskError(f"X_AB: shape {X.shape}: should be (..., 4, 4)")
    wxyz: Matrix = geometry.quaternions(X.reshape(-1, 4, 4)).reshape(*X.shape[:-2], 4)
    return wxyz


def to_row(X_AB: ArrayLike) -> list[float]:
    """Returns the row of a pose [4, 4] in plan files: x y z [m], qw qx qy qz."""
    X = np.asarray(X_AB, dtype=float)
    return [*X[:3, 3].tolist(), *to_quaternion(X).tolist()]


def from_row(row: ArrayLike) -> Matrix:
    """Returns the 4 x 4 pose of a row of `to_row`.

    Raises TaskError unless there are seven numbers.
    """
    X_AB: Matrix = from_rows(np.asarray(row, dtype=float)[None])[0]
    return X_AB


def to_rows(poses: ArrayLike) -> Matrix:
    """Returns the rows [N, 7] of poses [N, 4, 4] in plan files."""
    X = np.asarray(poses, dtype=float).reshape(-1, 4, 4)
    return np.concatenate([X[:, :3, 3], to_quaternion(X)], axis=1)


def from_rows(rows: ArrayLike) -> Matrix:
    """Returns the poses [N, 4, 4] of the rows of `to_rows`.

    Raises TaskError unless each has seven numbers.
    """
    given = np.asarray(rows, dtype=float)
    if given.shape != (0,) and given.shape[1:] != (7,):
        raise TaskError(f"rows: shape {given.shape}: should be (N, 7)")
    given = given.reshape(-1, 7)
    poses = from_quaternion(given[:, 3:])
    poses[:, :3, 3] = given[:, :3]
    return poses


def angle(X_A: ArrayLike, X_B: ArrayLike) -> float:
    """Returns the angle between the orientations of two poses [4, 4], from 0 to pi [rad]."""
    first, last = np.asarray(X_A, dtype=float), np.asarray(X_B, dtype=float)
    w = abs(float(to_quaternion(np.linalg.inv(first) @ last)[0]))
    return 2 * float(np.arccos(w)) if w < 1 - 1e-15 else 0.0


def between(X_A: ArrayLike, X_B: ArrayLike, t: float) -> Matrix:
    """Interpolates between two poses [4, 4]: X_A at t = 0, X_B at t = 1, positions linearly.

    Orientations by the normalised sum of quaternions, the shorter way round.
    """
    first, last = np.asarray(X_A, dtype=float), np.asarray(X_B, dtype=float)
    a, b = to_quaternion(first), to_quaternion(last)
    b = -b if a @ b < 0 else b
    p = (1 - t) * first[:3, 3] + t * last[:3, 3]
    return translation(p) @ from_quaternion((1 - t) * a + t * b)


def along(poses: ArrayLike, rows: ArrayLike) -> Matrix:
    """Interpolates poses [N, 4, 4] as `between` does, at fractional `rows` [M], such as 2.25.

    Returns [M, 4, 4]. Rows before 0 and beyond N - 1 give the first and the last pose.
    """
    given, at = np.asarray(poses, dtype=float), np.asarray(rows, dtype=float)
    before = np.floor(at).astype(int).clip(0, len(given) - 1)
    after = np.minimum(before + 1, len(given) - 1)
    return mixed(places(given), before, after, np.clip(at - before, 0.0, 1.0))


def places(poses: Matrix) -> tuple[Matrix, Matrix]:
    """Returns positions [N, 3] and unit quaternions [N, 4] of poses [N, 4, 4]."""
    return poses[:, :3, 3], to_quaternion(poses)


def mixed(
    given: tuple[Matrix, Matrix], before: NDArray[np.int64], after: NDArray[np.int64], t: Matrix
) -> Matrix:
    """Interpolates as `between` does, at parameters t [M] from index before [M] to after [M].

    `given` are positions and quaternions of `places`; returns poses [M, 4, 4].
    """
    points, quaternions = given
    a, b = quaternions[before], quaternions[after]
    b = np.where(np.einsum("ij,ij->i", a, b)[:, None] < 0, -b, b)
    X = from_quaternion((1 - t)[:, None] * a + t[:, None] * b)
    X[:, :3, 3] = (1 - t)[:, None] * points[before] + t[:, None] * points[after]
    return X


__all__ = [
    "along",
    "angle",
    "between",
    "from_quaternion",
    "from_row",
    "from_rows",
    "from_rpy",
    "planar",
    "to_quaternion",
    "to_row",
    "to_rows",
    "to_rpy",
    "transform",
    "translation",
]


def __dir__() -> list[str]:
    return __all__
