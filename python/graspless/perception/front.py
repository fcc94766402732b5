# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The function `perceive` for arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .._core.perception import Options, Scene, View
from .._core.perception import perceive as perceive_views

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


def perceive(
    depth: ArrayLike,
    K: ArrayLike,
    X_WC: ArrayLike,
    options: Options | None = None,
    *,
    stamp: float | None = None,
) -> Scene:
    """Finds supports, objects and unseen space in depth images of a still scene.

    Finding nothing is a status with a reason. Other Python threads run meanwhile.

    Parameters
    ----------
    depth : array [H, W] or [N, H, W]
        Depths along the optical axis [m], of one view or of N. 0 or not finite: no measurement.
    K : array [3, 3] or [N, 3, 3]
        Camera matrix [pixels], without skew; one for all views or one for each.
    X_WC : array [4, 4] or [N, 4, 4]
        Pose of the optical frame C in the world for each view: x right, y down, z forward. The
        world's z points up.
    options : Options, optional
        Settings of the search.
    stamp : float, optional
        When the images were taken [s since 1970]: the scene keeps it, and `graspless.pick` can
        refuse a scene that is too old.

    Returns
    -------
    Scene
        False if nothing trustworthy was found. Its warnings, and those of its objects, say what may
        be wrong.

    Raises
    ------
    ValueError
        An array has the wrong shape, K is not that of a pinhole camera of this size, a pose is not
        rigid, or an option is out of its range. Names the argument.
    """
    images = np.asarray(depth)
    if images.dtype.kind not in "fiu":
        raise ValueError(f"depth has values of type {images.dtype}; it must have numbers in metres")
    if images.ndim not in (2, 3):
        raise ValueError(f"depth has shape {images.shape}; it must have shape (H, W) or (N, H, W)")
    count = 1 if images.ndim == 2 else len(images)
    views = [
        View(image, matrix, pose)
        for image, matrix, pose in zip(
            images.reshape(count, *images.shape[-2:]),
            _each("K", K, 3, count),
            _each("X_WC", X_WC, 4, count, is_shared=count == 1),
            strict=True,
        )
    ]
    scene = perceive_views(views, Options() if options is None else options)
    scene.stamp = stamp
    return scene


def _each(
    name: str, given: ArrayLike, size: int, count: int, is_shared: bool = True
) -> list[np.ndarray]:
    """Returns one matrix for each view."""
    matrices = np.asarray(given, dtype=float)
    if matrices.shape == (size, size) and is_shared:
        return [matrices] * count
    if matrices.shape != (count, size, size):
        shared = f"({size}, {size}) or " if is_shared else ""
        expected = f"{shared}({count}, {size}, {size})"
        raise ValueError(f"{name} has shape {matrices.shape}; it must have shape {expected}")
    return list(matrices)


__all__ = ["perceive"]
