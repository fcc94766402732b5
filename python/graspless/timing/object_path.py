# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""An object's motion as six coordinates in metres, so that its inertia can be bounded.

The coordinates are its centre of mass in the world, and the sum of its rotations from row to row
(rotation vectors in the world) times its greatest radius of gyration k: an acceleration of any of
them, times the mass, is a force.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial.transform import Rotation

from .settings import STABILITY_SHARE, TUMBLE_SPEED

if TYPE_CHECKING:
    from ..fingertip import Object
    from ..frames import Matrix
    from .limits import Pace


@dataclass(frozen=True)
class ObjectPath:
    """Path of an object through poses X_WO [N, 4, 4]."""

    object: Object
    poses: Matrix

    @property
    def gyration(self) -> float:
        """Radius of gyration k [m]."""
        greatest = np.linalg.eigvalsh(self.object.inertia).max()
        return float(np.sqrt(greatest / self.object.mass))

    def coordinates(self) -> Matrix:
        """Returns coordinates [N, 6] of each row [m]."""
        com = self.poses[:, :3, :3] @ self.object.com + self.poses[:, :3, 3]
        return np.hstack([com, self.gyration * self._turned()])

    def at(self, coordinates: Matrix, rows: Matrix) -> Matrix:
        """Returns poses [M, 4, 4] at coordinates [M, 6] on the path, near rows [M]."""
        near = np.rint(rows).astype(int).clip(0, len(self.poses) - 1)
        turns = coordinates[:, 3:] / self.gyration - self._turned()[near]
        X_WO: Matrix = self.poses[near].copy()
        X_WO[:, :3, :3] = Rotation.from_rotvec(turns).as_matrix() @ X_WO[:, :3, :3]
        X_WO[:, :3, 3] = coordinates[:, :3] - X_WO[:, :3, :3] @ self.object.com
        return X_WO

    def acceleration(self, stability: float) -> Matrix:
        """Returns limits [6] under which inertia takes at most a fixed share of `stability` [N].

        The force is bounded by m (|a| + k |alpha|): by the greatest moment of inertia, and with
        the torque taken over the arm k.
        """
        moving = np.ptp(self.coordinates(), axis=0) > 1e-9
        counts = np.sqrt([moving[:3].sum(), moving[3:].sum()])
        each = STABILITY_SHARE * stability / (self.object.mass * max(counts.sum(), 1.0))
        return np.full(6, each)

    def slow(self, name: str, speed: float) -> Pace:
        """Returns the speed limits of a segment.

        While it slides or turns, no point of the object is faster than `speed` [m/s]. While it
        tumbles, this holds for the centre of mass, and the object turns at most at TUMBLE_SPEED.
        """
        k = self.gyration
        reach = np.linalg.norm(self.object.hull - self.object.com, axis=1).max()

        def pace(_: Matrix, dq: Matrix) -> Matrix:
            moved = np.linalg.norm(dq[:, -6:-3], axis=1)
            turned = np.linalg.norm(dq[:, -3:], axis=1) / k
            if name == "tumble":
                slowest: Matrix = np.maximum(moved / speed, turned / TUMBLE_SPEED)
            else:
                slowest = (moved + reach * turned) / speed
            return slowest

        return pace

    def _turned(self) -> Matrix:
        R = self.poses[:, :3, :3]
        turns = Rotation.from_matrix(R[1:] @ R[:-1].transpose(0, 2, 1)).as_rotvec()
        return np.vstack([np.zeros(3), np.cumsum(turns, axis=0)])
