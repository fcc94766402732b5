# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Success rates and times of runs, some of which were not solved."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

Z95 = 1.959963984540054  # two-sided 95 % of the normal distribution


def wilson(successes: int, runs: int, z: float = Z95) -> tuple[float, float]:
    """Returns the Wilson score interval of a success rate (Wilson 1927).

    Returns
    -------
    (float, float)
        Bounds within [0, 1]; (0, 1) without runs.
    """
    if runs == 0:
        return 0.0, 1.0
    rate = successes / runs
    scale = 1 + z**2 / runs
    middle = (rate + z**2 / (2 * runs)) / scale
    half = z / scale * math.sqrt(rate * (1 - rate) / runs + z**2 / (4 * runs**2))
    low = 0.0 if successes == 0 else max(0.0, middle - half)
    high = 1.0 if successes == runs else min(1.0, middle + half)
    return low, high


def quantile(seconds: Sequence[float], fraction: float) -> float:
    """Returns the least time within which at least this fraction of the runs was solved [s].

    Parameters
    ----------
    seconds : list of float
        inf for a run that was not solved.
    """
    if not seconds:
        return math.inf
    ordered = sorted(seconds)
    return ordered[max(0, math.ceil(fraction * len(ordered)) - 1)]
