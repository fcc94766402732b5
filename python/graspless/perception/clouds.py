# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Depth images from point clouds, and from several frames of a still camera."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .._core.perception import Camera, Options, View
from ..errors import warn
from . import sparse
from .rendering import look_at

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from ..frames import Matrix

_WIDEST = math.radians(120)  # field of view of the image of a cloud
_NARROWEST = math.radians(5)  # of any image: see View
_MARGIN = 5  # around the points, whose image cuts nothing off [pixels]
_MOST, _FEWEST = 640, 64  # pixels along its side
_FARTHEST = 1e9  # coordinates [m]
_SPARSE = 0.3  # share of gaps from which on they are bridged
_OPEN = 0.05  # share of gaps that may remain
_SIGMAS = 6.0  # between the nearest and the farthest of the points of one surface in a pixel
_GROWTH = 1.15  # of the pixels, until the rest is bridged


def average(depths: Sequence[ArrayLike]) -> Matrix:
    """Averages depth images of a still scene from a camera that does not move.

    Parameters
    ----------
    depths : sequence of array [H, W]
        Depths [m]. 0 or not finite: no measurement.

    Returns
    -------
    array [H, W]
        Mean of the measurements of each pixel that are within 1 % and 10 mm of their median, so
        that a pixel that jumps between two surfaces takes one of them. 0 where fewer than half of
        the images have a measurement.

    Raises
    ------
    ValueError
        There is no image, or they differ in size.
    """
    images = [np.asarray(depth, dtype=float) for depth in depths]
    if not images:
        raise ValueError("depths must have at least one image, not 0")
    if len({image.shape for image in images}) > 1 or images[0].ndim != 2:
        shapes = ", ".join(str(shape) for shape in sorted({image.shape for image in images}))
        raise ValueError(f"depths must be images of one size (H, W), not {shapes}")
    stack = np.stack(images)
    is_seen = np.isfinite(stack) & (stack > 0)
    stack = np.where(is_seen, stack, np.nan)
    few = is_seen.sum(axis=0) < (len(images) + 1) // 2
    stack[:, few] = 0.0
    middle = np.nanpercentile(stack, 50, axis=0, method="lower")
    near = np.abs(stack - middle) <= np.maximum(0.01, 0.01 * middle)
    return np.asarray(np.nanmean(np.where(near, stack, np.nan), axis=0))


def view_of_organized(points: ArrayLike, X_WC: ArrayLike) -> View:
    """Returns the depth image of an organised cloud, with the camera that its points imply.

    Parameters
    ----------
    points : array [H, W, 3]
        One point per pixel in the optical frame C: x right, y down, z forward [m]. Not finite, or
        z = 0: no measurement.
    X_WC : array [4, 4]
        Pose of the optical frame in the world.

    Raises
    ------
    ValueError
        The points are not those of a pinhole camera.
    """
    grid = np.asarray(points, dtype=float)
    if grid.ndim != 3 or grid.shape[2] != 3:
        raise ValueError(f"points has shape {grid.shape}; it must have shape (H, W, 3)")
    is_seen = np.isfinite(grid).all(axis=2) & (grid[..., 2] > 0)
    if np.count_nonzero(is_seen) < 100:
        raise ValueError(
            f"points has {np.count_nonzero(is_seen)} points with z > 0; at least 100 needed"
        )
    rows, columns = np.nonzero(is_seen)
    seen = grid[is_seen]
    K = np.eye(3)
    for axis, pixels in ((0, columns), (1, rows)):
        slope = seen[:, axis] / seen[:, 2]
        (focal, center), residual, rank, _ = np.linalg.lstsq(
            np.column_stack([slope, np.ones(len(slope))]), pixels, rcond=None
        )
        off = float(np.sqrt(residual[0] / len(slope))) if len(residual) else math.inf
        if rank < 2 or off > 0.5:
            raise ValueError(
                f"points are not those of a pinhole camera: they are {off:.2g} pixels off in "
                f"{'xy'[axis]}; they must be in the optical frame, row by row"
            )
        K[axis, axis], K[axis, 2] = focal, center
    return View(np.where(is_seen, grid[..., 2], 0.0), K, np.asarray(X_WC, dtype=float))


def view_of_cloud(points: ArrayLike, viewpoint: ArrayLike) -> View:
    """Returns the depth image of a plain cloud, as seen from where the camera was.

    A pixel of the image is about as large as the spacing of the points. Where points are much
    farther apart than elsewhere, as on the nearest surfaces of a voxel grid, the gaps between those
    of one surface are bridged, with a warning.

    Parameters
    ----------
    points : array [N, 3]
        Points in the world [m]. Those that are not finite are no measurements.
    viewpoint : array [3]
        Position of the camera in the world [m]. Without it nobody knows what the points hide.

    Raises
    ------
    ValueError
        There are fewer than 100 points, or they surround the viewpoint or fill hardly any of its
        view.
    """
    cloud, eye = np.asarray(points, dtype=float), np.asarray(viewpoint, dtype=float)
    if cloud.ndim != 2 or cloud.shape[1] != 3 or len(cloud) < 100:
        raise ValueError(f"points has shape {cloud.shape}; it must have shape (N, 3), N >= 100")
    cloud = cloud[np.isfinite(cloud).all(axis=1)]
    if len(cloud) < 100:
        raise ValueError(f"points has only {len(cloud)} points that are finite; 100 are needed")
    if eye.shape != (3,) or not np.isfinite(eye).all():
        raise ValueError(f"viewpoint is {eye}; it must be three finite coordinates [m]")
    for name, values in (("points", cloud), ("viewpoint", eye)):
        if (largest := np.abs(values).max()) > _FARTHEST:
            raise ValueError(f"{name} has the coordinate {largest:.3g}; at most {_FARTHEST:g} m")
    middle = (cloud.min(axis=0) + cloud.max(axis=0)) / 2
    distance = float(np.linalg.norm(middle - eye))
    X_WC = look_at(eye, middle) if distance > 0 else np.eye(4)
    p_CP = (cloud - eye) @ X_WC[:3, :3]
    slopes = np.abs(p_CP[:, :2] / np.maximum(p_CP[:, 2:], 1e-9)).max(axis=0)
    if p_CP[:, 2].min() <= 0 or slopes.max() > math.tan(_WIDEST / 2):
        raise ValueError(
            f"viewpoint {eye} is among the points; they must lie within 60 degrees of one "
            "direction from it. Both must be in metres, in the same frame"
        )
    angles = 2 * np.arctan(slopes * 1.02)
    if angles.min() < _NARROWEST:
        across, down = np.degrees(angles)
        raise ValueError(
            f"viewpoint {eye} is {distance:.3g} m from the middle of the points, which fill only "
            f"{across:.2g} x {down:.2g} degrees of its view, less than "
            f"{math.degrees(_NARROWEST):g}; both must be in metres, in the same frame"
        )
    # As many pixels as points, over the rectangle that they fill.
    side = float(np.sqrt(4 * slopes[0] * slopes[1] / len(cloud)))
    size, K = _camera(slopes, side)
    depth = _depths(p_CP, size, K)
    if (gaps := sparse.gaps_of(depth)).share > _SPARSE:
        _warn_of_spacing(gaps, K)
        depth, K = _closed(p_CP, slopes, side)
    return View(np.where(np.isfinite(depth), depth, 0.0), K, X_WC)


def _camera(slopes: Matrix, side: float) -> tuple[list[int], Matrix]:
    """Returns width, height and matrix of the image whose pixels have this side at distance 1."""
    size = [int(np.clip(2 * slope / side, _FEWEST, _MOST)) for slope in slopes]
    across, down = (slope * (1 + 2 * _MARGIN / n) for slope, n in zip(slopes, size, strict=True))
    camera = Camera(size[0], size[1], 2 * math.atan(across))
    K = camera.K.copy()
    K[1, 1] = size[1] / (2 * down)
    return size, K


def _pixels(p_CP: Matrix, K: Matrix) -> Matrix:
    return np.asarray(p_CP[:, :2] / p_CP[:, 2:] * [K[0, 0], K[1, 1]] + K[:2, 2])


def _depths(p_CP: Matrix, size: list[int], K: Matrix) -> Matrix:
    """Returns an image with the mean depth of the points of the nearest surface in each pixel.

    The nearest point alone would lift all surfaces by their noise. Infinite: there is no point.
    """
    columns, rows = np.clip(np.rint(_pixels(p_CP, K)).astype(int), 0, np.array(size) - 1).T
    at, z = rows * size[0] + columns, p_CP[:, 2]
    nearest = np.full(size[0] * size[1], np.inf)
    np.minimum.at(nearest, at, z)
    nearest = nearest[at]
    noise = Options().noise_constant + Options().noise_quadratic * nearest**2
    pitch = 1 / min(K[0, 0], K[1, 1])
    is_one = z - nearest < _SIGMAS * noise + sparse.STEEPEST * pitch * nearest
    count = np.bincount(at[is_one], minlength=size[0] * size[1])
    total = np.bincount(at[is_one], z[is_one], size[0] * size[1])
    mean = np.where(count > 0, total / np.maximum(count, 1), np.inf)
    return np.asarray(mean.reshape(size[1], size[0]))


def _closed(p_CP: Matrix, slopes: Matrix, side: float) -> tuple[Matrix, Matrix]:
    """Returns the image of a sparse cloud, with the least pixels whose gaps can be bridged."""
    while True:
        size, K = _camera(slopes, side)
        points = sparse.nearest_points(_pixels(p_CP, K), p_CP[:, 2], size)
        pitch = float(1 / min(K[0, 0], K[1, 1]))
        depth = sparse.bridged(points.depth, pitch)
        side *= _GROWTH
        if sparse.gaps_of(depth).share <= _OPEN or 2 * slopes.min() / side < _FEWEST:
            return sparse.resampled(points, depth, pitch), K


def _warn_of_spacing(gaps: sparse.Gaps, K: Matrix) -> None:
    pixel = 1000 * gaps.depth / math.sqrt(K[0, 0] * K[1, 1])
    spacing = pixel / math.sqrt(max(1 - gaps.share, 0.01))
    warn(
        f"points are about {spacing:.2g} mm apart at {gaps.depth:.2g} m from the viewpoint, as in "
        "a voxel grid: outlines may be off by thrice that, and small or thin objects missed, "
        "whatever least_thickness says; give the raw cloud, or smaller voxels"
    )
