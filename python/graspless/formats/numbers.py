# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers, and names with numbers, as text has them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..timing import Trajectory


def plain(values: ArrayLike) -> Any:
    """Nested lists of plain floats, none of them -0.0."""
    return (np.asarray(values, dtype=float) + 0.0).tolist()


def numbered(trajectory: Trajectory) -> list[str]:
    """Returns names of the segments that differ from each other: 0_approach, 1_press, ..."""
    return [f"{i}_{segment.name}" for i, segment in enumerate(trajectory.segments)]
