# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Paths through rows: straight between them, with rounded corners.

The path's parameter is the length of the rows' polyline. Before and after a row i where it turns
from direction u to direction v, over a distance d on either side, the direction is
u + (v - u) h(x), with h(x) = 3 x^2 - 2 x^3 and x from 0 to 1 over both. The path is then twice
continuously differentiable, and the farthest that any coordinate is from the polyline, at the
row, is 3/16 d |v - u|: d follows from the tolerance, and is at most half way to the next row.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.interpolate import PPoly

if TYPE_CHECKING:
    from ..frames import Matrix

REVERSAL = -0.9  # cosine of the turn beyond which a path comes to rest instead


@dataclass(frozen=True)
class Path:
    """A rounded polyline.

    Attributes
    ----------
    knots : array [K]
        Values of the parameter at the rows, from 0.
    rows : array [K]
        Indices of these rows: of equal rows the first and the last, whose knots are the same.
    curve : PPoly
        From the parameter to the coordinates.
    """

    knots: Matrix
    rows: Matrix
    curve: PPoly

    @property
    def length(self) -> float:
        """Length of the polyline."""
        return float(self.knots[-1])

    def __call__(self, s: Matrix, order: int = 0) -> Matrix:
        """Returns coordinates [N, n] at `s` [N], or their derivatives of the given order."""
        values: Matrix = self.curve(s, order)
        return values

    def row(self, s: Matrix) -> Matrix:
        """Returns fractional rows [N] at `s` [N]: the last of equal ones, but at 0 the first."""
        return np.where(s > 0, np.interp(s, self.knots, self.rows), self.rows[0])

    def place(self, row: float) -> float:
        """Returns the parameter at a fractional row."""
        return float(np.interp(row, self.rows, self.knots))

    def grid(self) -> Matrix:
        """Returns parameters [M] at which to evaluate limits: denser in bends and at the ends."""
        breaks = self.curve.x
        inner = [np.linspace(a, b, 7)[:-1] for a, b in zip(breaks, breaks[1:], strict=False)]
        # A slow segment reaches its speed long before the first bend.
        ends = self.length * 0.5 * np.geomspace(1e-5, 1.0, 24)
        even = np.linspace(0.0, self.length, 60)
        points = np.concatenate([*inner, even, ends, self.length - ends])
        points = np.unique(points.clip(0.0, self.length))
        keep = np.diff(points, prepend=-np.inf) > 1e-7 * self.length
        return np.append(points[keep][:-1], self.length)


def stretches(points: Matrix) -> list[slice]:
    """Splits rows [N, n] at reversals, where a path must come to rest."""
    runs, _, _, directions = _legs(points)
    cosines = np.einsum("ij,ij->i", directions[1:], directions[:-1])
    cuts = [0, *(runs[1:-1, 1][cosines < REVERSAL].tolist()), len(points) - 1]
    return [slice(a, b + 1) for a, b in zip(cuts, cuts[1:], strict=False)]


def rounded(points: Matrix, tolerance: Matrix) -> Path | None:
    """Returns a path along rows [N, n] that deviates from each by at most `tolerance` [N, n].

    None if the rows do not move.
    """
    runs, corners, lengths, directions = _legs(points)
    if len(runs) < 2:
        return None
    knots = np.concatenate([[0.0], np.cumsum(lengths)])
    breaks, pieces = [0.0], []
    for i, (u, length) in enumerate(zip(directions, lengths, strict=True)):
        bend = 0.0
        if i + 1 < len(lengths):
            first, last = runs[i + 1]
            near = tolerance[first : last + 1].min(axis=0)
            bend = _bend(directions[i + 1] - u, length, lengths[i + 1], near)
        start, end = breaks[-1], knots[i + 1] - bend
        if end - start > 1e-12 * knots[-1]:
            pieces.append(_straight(corners[i] + u * (start - knots[i]), u))
            breaks.append(end)
        else:  # this bend begins where the last one ended
            breaks[-1] = end
        if bend > 0:
            pieces.append(_rounding(corners[i + 1] - bend * u, u, directions[i + 1], bend))
            breaks.append(knots[i + 1] + bend)
    breaks[-1] = knots[-1]
    curve = PPoly(np.stack(pieces, axis=1), np.array(breaks), extrapolate=True)
    rows, kept = np.unique(runs, return_index=True)
    return Path(np.repeat(knots, 2)[kept], rows.astype(float), curve)


def _legs(points: Matrix) -> tuple[Matrix, Matrix, Matrix, Matrix]:
    """Splits rows [N, n] into runs of equal ones.

    Returns the first and the last row of each run [K, 2], their coordinates [K, n], and lengths
    and directions between them.
    """
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    moving = np.flatnonzero(steps > 1e-9)
    runs = np.stack([[0, *(moving + 1)], [*moving, len(points) - 1]], axis=1)
    corners = np.concatenate([points[runs[:-1, 0]], points[-1:]])
    legs = np.diff(corners, axis=0)
    lengths = np.linalg.norm(legs, axis=1)
    return runs, corners, lengths, legs / lengths[:, None]


def _bend(change: Matrix, before: float, after: float, tolerance: Matrix) -> float:
    """Returns the distance from a row at which the path leaves the polyline."""
    moved = np.abs(change)
    if moved.max() < 1e-9:
        return 0.0
    with np.errstate(divide="ignore"):
        allowed = 16 / 3 * tolerance / moved
    return float(min(before / 2, after / 2, allowed.min()))


def _straight(start: Matrix, u: Matrix) -> Matrix:
    zero = np.zeros_like(u)
    return np.array([zero, zero, zero, u, start])


def _rounding(start: Matrix, u: Matrix, v: Matrix, bend: float) -> Matrix:
    """Returns the coefficients of the integral of u + (v - u) h, fourth power first."""
    width, change = 2 * bend, v - u
    return np.array([-change / (2 * width**3), change / width**2, 0 * u, u, start])
