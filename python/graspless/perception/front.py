# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The function `perceive` for arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .._core.perception import Options, Scene, View
from .._core.perception import perceive as perceive_views
from ..errors import warn
from .readers import is_foreign, matrix_of, view_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

FARTHEST = 100.0  # of a camera from the origin of the world [m]


def perceive(
    depth: Any,
    K: Any = None,
    X_WC: ArrayLike | None = None,
    options: Options | None = None,
    *,
    stamp: float | None = None,
) -> Scene:
    """Finds supports, objects and unseen space in depth images of a still scene.

    Finding nothing is a status with a reason. Other Python threads run meanwhile.

    Parameters
    ----------
    depth : array [H, W] or [N, H, W], or one or several objects of another library
        Depths along the optical axis [m], of one view or of N. 0 or not finite: no measurement.
        Or an RGBDImage or PointCloud of open3d, a frame or frameset of pyrealsense2, a sensor_msgs
        PointCloud2, or a list of them. Points are in the optical frame.
    K : array [3, 3] or [N, 3, 3], optional
        Camera matrix [pixels], without skew; one for all views or one for each. Or the
        PinholeCameraIntrinsic of open3d. Clouds and frames of pyrealsense2 do without.
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
    if X_WC is None:
        raise ValueError("X_WC must be given: the pose of the camera's optical frame in the world")
    K = matrix_of(K)
    several = isinstance(depth, list | tuple) and any(map(is_foreign, depth))
    if several or is_foreign(depth):
        views = _foreign(list(depth) if several else [depth], K, X_WC)
    else:
        views = _arrays(depth, K, X_WC)
    for i, view in enumerate(views):
        warn_of_camera(view, f"X_WC[{i}]" if len(views) > 1 else "X_WC")
    if stamp is not None and not np.isfinite(stamp):
        raise ValueError(f"stamp must be a finite time in s, not {stamp}")
    scene = perceive_views(views, Options() if options is None else options)
    scene.stamp = stamp
    return scene


def warn_of_camera(view: View, name: str) -> None:
    """Warns of a camera whose position looks like millimetres."""
    away = float(np.linalg.norm(view.X_WC[:3, 3]))
    if away > FARTHEST:
        what = f"the camera is {away:.4g} m from the origin of the world; lengths are in metres"
        warn(f"{name}: {what}")


def _arrays(depth: ArrayLike, K: Any, X_WC: ArrayLike) -> list[View]:
    images = np.asarray(depth)
    if images.dtype.kind not in "fiu":
        raise ValueError(f"depth has values of type {images.dtype}; it must have numbers in metres")
    if images.ndim == 3 and images.shape[2] == 3 and K is None:
        raise ValueError(
            f"depth has shape {images.shape}: for an organized cloud, use "
            "perception.view_of_organized"
        )
    if images.ndim not in (2, 3):
        raise ValueError(f"depth has shape {images.shape}; it must have shape (H, W) or (N, H, W)")
    if images.ndim == 3 and images.shape[2] == 1:
        raise ValueError(
            f"depth has shape {images.shape}; it must have shape (H, W) or (N, H, W): "
            "give depth[..., 0]"
        )
    if K is None:
        raise ValueError("K must be given with a depth image: the camera matrix [pixels]")
    count = 1 if images.ndim == 2 else len(images)
    each = images.reshape(count, *images.shape[-2:])
    poses = _each("X_WC", X_WC, 4, count, is_shared=count == 1)
    return [View(*of) for of in zip(each, _each("K", K, 3, count), poses, strict=True)]


def _foreign(sources: list[Any], K: Any, X_WC: ArrayLike) -> list[View]:
    count = len(sources)
    matrices = [None] * count if K is None else _each("K", K, 3, count)
    poses = _each("X_WC", X_WC, 4, count, is_shared=count == 1)
    for i, source in enumerate(sources):
        if not is_foreign(source):
            raise ValueError(f"depth[{i}] is of type {type(source).__name__}, unlike the others")
    return [view_of(*of) for of in zip(sources, matrices, poses, strict=True)]


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
