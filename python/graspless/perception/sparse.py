# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Depth images of sparse clouds, such as voxel grids: gaps between the points are bridged."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ..frames import Matrix

_REACH = 2  # pixels from a gap to the points beside it
_ROUNDS = 2  # in which gaps are bridged
STEEPEST = 2.5  # tangent of the angle between ray and normal on one surface
_UNEVEN = 0.01  # difference of depth that is always allowed [m]
_SMALLEST = 0.02  # variance that is added to the places of points [pixels^2]
_AHEAD = [(0, 1), (1, 0), (1, 1), (1, -1), (0, 2), (2, 0), (2, 2), (2, -2)]  # rows and columns
_AROUND = [
    (i, j) for i in range(-_REACH, _REACH + 1) for j in range(-_REACH, _REACH + 1)
]  # rows and columns


class Gaps(NamedTuple):
    """Gaps in a depth image, where they are most frequent."""

    share: float  # of the pixels
    depth: float  # median of these pixels [m]


class Nearest(NamedTuple):
    """The nearest point in each pixel."""

    depth: Matrix  # [m]; infinite: none
    right: Matrix  # from the centre of the pixel to the point [pixels]
    down: Matrix


def nearest_points(uv: Matrix, depth: Matrix, size: list[int]) -> Nearest:
    """Returns the nearest of the points in each pixel of an image of this width and height."""
    order = np.argsort(-depth, kind="stable")  # the nearest is written last
    uv = uv[order]
    columns, rows = np.clip(np.rint(uv).astype(int), 0, np.array(size) - 1).T
    image = Nearest(*(np.full(size[::-1], value) for value in (np.inf, 0.0, 0.0)))
    for values, of in zip(image, (depth[order], uv[:, 0] - columns, uv[:, 1] - rows), strict=True):
        values[rows, columns] = of
    return image


def gaps_of(depth: Matrix) -> Gaps:
    """Returns the gaps in the worst tenth of the pixels by depth.

    A gap is an empty pixel between two others that are opposite each other.
    """
    beside = np.full(depth.shape, np.inf)
    for a, b, _ in _opposite(depth):
        beside = np.minimum(beside, np.maximum(a, b))
    is_gap = np.isinf(depth) & np.isfinite(beside)
    known = np.where(is_gap, beside, depth)
    is_known = np.isfinite(known)
    depths = known[is_known]
    tenth = np.searchsorted(np.quantile(depths, np.linspace(0.1, 0.9, 9)), depths)
    shares = np.bincount(tenth, is_gap[is_known], 10) / np.maximum(np.bincount(tenth, None, 10), 1)
    worst = int(np.argmax(shares))
    return Gaps(float(shares[worst]), float(np.median(depths[tenth == worst])))


def bridged(depth: Matrix, pitch: float) -> Matrix:
    """Returns an image whose gaps within a surface have depths. `pitch` is the angle of a pixel.

    A gap takes the mean of the two opposite neighbours that differ least.
    """
    for _ in range(_ROUNDS):
        filled, least = depth.copy(), np.full(depth.shape, np.inf)
        for a, b, pixels in _opposite(depth):
            with np.errstate(invalid="ignore"):
                apart = np.abs(a - b)
                is_one = apart < _allowed(np.minimum(a, b), 2 * pixels * pitch)
            is_one &= np.isinf(depth) & (apart < least)
            least[is_one] = apart[is_one]
            filled[is_one] = 2 / (1 / a[is_one] + 1 / b[is_one])
        depth = filled
    return depth


def resampled(points: Nearest, depth: Matrix, pitch: float) -> Matrix:
    """Returns the depths at the centres of the pixels of a bridged image.

    The points around a pixel give the plane of its surface, 1/z = a u + b v + c. A point moves
    along it to the centre of its pixel, and gaps take the plane itself.
    """
    rows, columns = np.nonzero(np.isfinite(depth))
    z = depth[rows, columns]
    padded = [
        np.pad(values, _REACH, constant_values=fill)
        for values, fill in zip(points, (np.inf, 0.0, 0.0), strict=True)
    ]
    sums: Any = np.zeros((9, len(z)))
    for i, j in _AROUND:
        near, x, y = (values[rows + i + _REACH, columns + j + _REACH] for values in padded)
        x, y, w = x + j, y + i, 1 / near
        is_one = np.abs(near - z) < _allowed(z, max(abs(i), abs(j), 1) * pitch)
        sums += is_one * np.stack([np.ones_like(w), x, y, w, x * x, x * y, y * y, x * w, y * w])
    x, y, w, xx, xy, yy, xw, yw = sums[1:] / np.maximum(sums[0], 1)
    xx, xy, yy = xx - x * x + _SMALLEST, xy - x * y, yy - y * y + _SMALLEST
    xw, yw = xw - x * w, yw - y * w
    slope_x, slope_y = np.stack([xw * yy - yw * xy, yw * xx - xw * xy]) / (xx * yy - xy * xy)
    own, own_x, own_y = (values[rows, columns] for values in points)
    is_gap = np.isinf(own)
    x, y, w = (np.where(is_gap, *of) for of in ((x, own_x), (y, own_y), (w, 1 / own)))
    at_center = w - slope_x * x - slope_y * y
    result = np.zeros(depth.shape)
    is_valid = at_center > 0.5 / z
    result[rows[is_valid], columns[is_valid]] = 1 / at_center[is_valid]
    return result


def _allowed(depth: Matrix, angle: float) -> Matrix:
    """Returns the largest difference of depth on one surface."""
    return np.asarray(_UNEVEN + STEEPEST * angle * depth)


def _opposite(depth: Matrix) -> Iterator[tuple[Matrix, Matrix, float]]:
    """Gives images of two neighbours that are opposite each other, and their distance."""
    height, width = depth.shape
    padded = np.pad(depth, _REACH, constant_values=np.inf)

    def shifted(i: int, j: int) -> Matrix:
        return padded[_REACH + i : _REACH + i + height, _REACH + j : _REACH + j + width]

    for i, j in _AHEAD:
        yield shifted(i, j), shifted(-i, -j), float(np.hypot(i, j))
