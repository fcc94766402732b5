# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""How many moments a second, and how many at most."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..errors import TaskError

if TYPE_CHECKING:
    from ..frames import Matrix

MOST_MOMENTS = 10**6  # of a trajectory: more fills the memory before it fills a file


class Rate:
    """Moments a second of one trajectory, counted over all its stretches.

    Attributes
    ----------
    hertz : float
        [1/s].
    """

    def __init__(self, hertz: float) -> None:
        self.hertz = hertz
        self._seconds = self._moments = 0.0

    def times(self, duration: float) -> Matrix:
        """[N] even times from 0 to `duration` [s], of the next stretch of the trajectory.

        Raises
        ------
        TaskError
            With those before they are more than MOST_MOMENTS.
        """
        count = np.maximum(2.0, np.ceil(float(duration) * self.hertz - 1e-9) + 1)  # also nan
        self._seconds += duration
        self._moments += count
        if not self._moments <= MOST_MOMENTS:
            raise TaskError(
                f"rate: {self.hertz:g}: {self._seconds:.3g} s of motion have {self._moments:.7g} "
                f"moments, more than {MOST_MOMENTS}: should be less, or max_velocity, "
                "max_acceleration or contact_speed more"
            )
        return np.linspace(0.0, duration, int(count))
