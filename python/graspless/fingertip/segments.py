# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of a fingertip plan, with arrays over their rows."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from .._core import fingertip as _core

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..frames import Matrix


class Segment(_core.Segment):
    """Part of a plan during which no finger changes its place, or one regrasp: N rows, n fingers.

    `rows` has the rows one by one. The other attributes are arrays over all rows.
    """

    @cached_property
    def _arrays(self) -> tuple[Matrix, Matrix, Matrix]:
        return self._to_arrays()

    def _points(self, first: int) -> Matrix:
        points: Matrix = self._arrays[2][..., first : first + 3].copy()
        points[~self.touches] = np.nan
        return points

    @property
    def object_poses(self) -> Matrix:
        """(N, 4, 4) pose of O in the world at each row."""
        return self._arrays[0]

    @cached_property
    def touches(self) -> NDArray[np.bool_]:
        """(N, n) True if a finger is on the object."""
        touches: NDArray[np.bool_] = self._arrays[2][..., 0] != 0
        return touches

    @cached_property
    def fingers(self) -> Matrix:
        """(N, n, 3) contact points in O [m]; NaN while a finger is off the object."""
        return self._points(1)

    @cached_property
    def normals(self) -> Matrix:
        """(N, n, 3) unit normals into the object, in O; NaN while a finger is off it."""
        return self._points(4)

    @cached_property
    def modes(self) -> list[list[str]]:
        """(N, n) control of each finger: position or force."""
        is_force = self._arrays[2][..., 7] != 0
        modes: list[list[str]] = np.where(is_force, "force", "position").tolist()
        return modes

    @property
    def commanded_forces(self) -> Matrix:
        """(N, n) normal force in force control, else 0 [N]."""
        return self._arrays[2][..., 8]

    @property
    def nominal_forces(self) -> Matrix:
        """(N, n, 3) forces on the object to feed forward, in O [N]."""
        return self._arrays[2][..., 9:]

    @property
    def stability(self) -> Matrix:
        """(N,) z [N]."""
        return self._arrays[1][:, 0]

    @property
    def compliant_stability(self) -> Matrix:
        """(N,) see mechanics.compliant_stability [N]."""
        return self._arrays[1][:, 1]

    @property
    def nominal_margin(self) -> Matrix:
        """(N,) margin of the nominal forces [N]."""
        return self._arrays[1][:, 2]

    @property
    def withstands(self) -> Matrix:
        """(N,) largest disturbance that each row withstands, fingers in their places [N]."""
        return self._arrays[1][:, 3]

    @property
    def place_tolerance(self) -> Matrix:
        """(N,) error of every finger's place that each row tolerates [m].

        With an error of e, a row withstands `withstands` (1 - e / `place_tolerance`).
        """
        return self._arrays[1][:, 4]


class JointSegment(_core.JointSegment):
    """Part of a joint motion."""

    @cached_property
    def object_poses(self) -> Matrix:
        """(N, 4, 4) pose of O in the world at each row."""
        return self.X_WO


class Weakest(NamedTuple):
    """Place of the least stability in a plan."""

    segment: int
    """Index of the segment, from 0."""

    row: int
    """Row of the segment, from 0."""
