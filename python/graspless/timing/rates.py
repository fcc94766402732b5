# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sampling rate of trajectories, and the largest number of samples."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import TaskError

if TYPE_CHECKING:
    from ..frames import Matrix

MOST_MOMENTS = 10**6  # of a trajectory: more fills the memory before it fills a file


class Rate:
    """Sampling rate of one trajectory; counts the samples over all its parts.

    Attributes
    ----------
    hertz : float
        Samples per second [1/s].
    """

    def __init__(self, hertz: float) -> None:
        self.hertz = hertz
        self._seconds = self._moments = 0.0

    def times(self, duration: float) -> Matrix:
        """Returns even times [N] from 0 to `duration` [s] for the next part of the trajectory.

        Raises
        ------
        TaskError
            The trajectory would have more than MOST_MOMENTS samples.
        """
        count = np.maximum(2.0, np.ceil(float(duration) * self.hertz - 1e-9) + 1)  # also nan
        self._seconds += duration
        self._moments += count
        if not self._moments <= MOST_MOMENTS:
            raise TaskError(
                f"rate: {self.hertz:g}: the first {self._seconds:.3g} s of motion alone have "
                f"{self._moments:.7g} samples, more than {MOST_MOMENTS}: should be less, or "
                "max_velocity, max_acceleration or contact_speed more"
            )
        return np.linspace(0.0, duration, int(count))
