# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The hand and its path, shifted and turned in the plane of the support."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import frames

if TYPE_CHECKING:
    from ..frames import Matrix
    from ..slide import Problem

_LIFT_STEPS = 16
_STEPS = 3  # of least squares
_DAMPING = 1e-2  # of singular values squared [m^2 or 1]; with less, joints jump near a singularity


class Hand:
    """The arm's inverse kinematics, and places in the plane of the support.

    A place is that of the object's centre of mass C, however far from it the origin of O is: x, y
    [m] and yaw [rad].
    """

    def __init__(self, problem: Problem) -> None:
        hand = problem.hand
        self.robot, self.frame = problem.robot, hand.grasp_frame
        self.arm = list(self.robot.group(hand.arm))
        self.X_WS = np.array(problem.support.X_WS)
        self.X_SW = np.linalg.inv(self.X_WS)
        self._X_OC = frames.translation([*problem.object.com[:2], 0.0])

    def place(self, X_WO: Matrix) -> Matrix:
        """Returns the place [3] of an object at X_WO."""
        return self.seen(X_WO)[:3]

    def seen(self, X_WO: Matrix) -> Matrix:
        """Returns the place of an object at X_WO, and its height there [4]."""
        X_SC = self.X_SW @ X_WO @ self._X_OC
        return np.array([*X_SC[:2, 3], np.arctan2(X_SC[1, 0], X_SC[0, 0]), X_SC[2, 3]])

    def pose(self, place: Matrix) -> Matrix:
        """Returns X_WO of an object that lies flat at a place [3]."""
        X_WO: Matrix = self.X_WS @ frames.planar(*map(float, place)) @ np.linalg.inv(self._X_OC)
        return X_WO

    def away(self, X_WH: Matrix, distance: float) -> Matrix:
        """Returns a step [2] in the plane of the support, back along the approach to a grasp."""
        back = -(self.X_SW[:2, :3] @ X_WH[:3, 2])
        step: Matrix = distance * back / max(float(np.linalg.norm(back)), 1e-9)
        return step

    def shifted(self, q: Matrix, motion: Matrix, height: float) -> Matrix:
        """Returns the joints [dof] that put the hand where the motion [3] takes it from q.

        The motion acts from the left in the plane of the support, which is `height` higher [m].
        Damped least squares from q: near a singularity or a joint limit the hand moves less, but no
        joint jumps.
        """
        if not np.any(motion) and height == 0:
            return q
        X_SS = frames.planar(*map(float, motion))
        X_SS[2, 3] = height
        X_WH = self.X_WS @ X_SS @ self.X_SW @ self.robot.pose(self.frame, q)
        found = q.copy()
        for _ in range(_STEPS):
            error = _twist(self.robot.pose(self.frame, found), X_WH)
            J = np.asarray(self.robot.jacobian(self.frame, found))[:, self.arm]
            weighted = J @ J.T + _DAMPING * np.eye(6)
            found[self.arm] += J.T @ np.linalg.solve(weighted, error)
        return np.asarray(self.robot.clamp(found))

    def lifted(self, q: Matrix, height: float) -> Matrix:
        """Returns a path [N, dof] that lifts the hand straight up, as high as the arm can."""
        path = [q]
        for _ in range(_LIFT_STEPS):
            path.append(self.shifted(path[-1], np.zeros(3), height / _LIFT_STEPS))
        return np.array(path)


def _twist(X_WA: Matrix, X_WB: Matrix) -> Matrix:
    """Returns displacement and rotation vector [6] from A to B, in the world."""
    R = X_WB[:3, :3] @ X_WA[:3, :3].T
    turn = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2  # if small
    return np.concatenate([X_WB[:3, 3] - X_WA[:3, 3], turn])
