# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Motion between two samples, of which positions, velocities and accelerations are known."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ..frames import Matrix

    State = tuple[Matrix, Matrix, Matrix]


def between(first: State, last: State, t: Matrix, gaps: Matrix) -> State:
    """Returns positions, velocities and accelerations [N, n] on polynomials of degree 5.

    Each polynomial has the positions, velocities and accelerations of both its samples. At the
    samples themselves, the values are theirs without rounding errors.

    Parameters
    ----------
    first, last : tuple of arrays [N, n]
        Positions, velocities and accelerations of the samples before and after each moment.
    t : array [N]
        How far each moment is between them: from 0 to 1.
    gaps : array [N]
        Time between them, positive [s].
    """
    x, h = t[:, None], gaps[:, None]
    p, v, a = first[0], first[1] * h, first[2] * h**2 / 2
    # What is left to the last sample of a motion with constant acceleration.
    d, e, f = last[0] - p - v - a, last[1] * h - v - 2 * a, last[2] * h**2 / 2 - a
    b, c, g = 10 * d - 4 * e + f, -15 * d + 7 * e - 2 * f, 6 * d - 3 * e + f
    found = (
        p + x * (v + x * (a + x * (b + x * (c + x * g)))),
        (v + x * (2 * a + x * (3 * b + x * (4 * c + x * 5 * g)))) / h,
        (2 * a + x * (6 * b + x * (12 * c + x * 20 * g))) / h**2,
    )
    inside = [
        np.where(x <= 0, start, np.where(x >= 1, end, value))
        for start, end, value in zip(first, last, found, strict=True)
    ]
    return inside[0], inside[1], inside[2]
