# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Views from what other libraries call a depth image or a cloud.

Objects are known by their attributes: open3d, pyrealsense2 and ROS are not imported and need not
be installed.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from .._core.perception import View
from .clouds import view_of_cloud, view_of_organized

if TYPE_CHECKING:
    from ..frames import Matrix

_CLOUD_TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 8: "f8"}


def is_foreign(source: Any) -> bool:
    """Returns true for the types that `view_of` reads."""
    return _is_message(source) or _is_cloud(source) or _is_rgbd(source) or _is_realsense(source)


def view_of(source: Any, K: Any, X_WC: Matrix) -> View:
    """Returns the view of a depth image or a cloud of another library.

    Parameters
    ----------
    source : object
        An open3d.geometry.RGBDImage or PointCloud (or one of open3d.t.geometry), a frame or
        frameset of pyrealsense2, or a sensor_msgs PointCloud2. Points are in the optical frame.
    K : array [3, 3] or None
        Camera matrix [pixels]. Frames of pyrealsense2 and clouds bring their own.
    X_WC : array [4, 4]
        Pose of the optical frame in the world.

    Raises
    ------
    ValueError
        K is missing, or the image or cloud is not valid.
    """
    if _is_message(source):
        return view_of_grid(points_of_message(source), X_WC)
    if _is_cloud(source):
        return _view_of_points(_points_of(source), X_WC)
    depth, own = _frame_of(source) if _is_realsense(source) else (_pixels_of(source.depth), None)
    matrix = own if K is None else K
    if matrix is None:
        raise ValueError(f"K must be given: {type(source).__name__} has no camera matrix")
    return View(depth, matrix, X_WC)


def matrix_of(K: Any) -> Any:
    """Returns a camera matrix: of an open3d PinholeCameraIntrinsic, of the intrinsics of
    pyrealsense2, or K itself.
    """
    if hasattr(K, "intrinsic_matrix"):
        return np.asarray(K.intrinsic_matrix, dtype=float)
    if not all(hasattr(K, name) for name in ("fx", "fy", "ppx", "ppy", "coeffs")):
        return K
    if any(abs(value) > 1e-9 for value in K.coeffs):
        raise ValueError(
            f"K is that of a distorted image (coeffs {list(K.coeffs)}); rectify it first"
        )
    return np.array([[K.fx, 0, K.ppx], [0, K.fy, K.ppy], [0, 0, 1.0]])


def points_of_message(cloud: Any) -> Matrix:
    """Returns the points [H, W, 3] of a PointCloud2 in its own frame [m].

    Raises
    ------
    ValueError
        A field is missing or of an unknown type, or bytes are missing.
    """
    fields = {field.name: field for field in cloud.fields}
    missing = [axis for axis in "xyz" if axis not in fields]
    if missing:
        raise ValueError(f"the point cloud has no field {', '.join(missing)}")
    if any(fields[axis].datatype not in _CLOUD_TYPES for axis in "xyz"):
        raise ValueError("the point cloud has coordinates of an unknown type")
    order = ">" if cloud.is_bigendian else "<"
    formats = [order + _CLOUD_TYPES[fields[axis].datatype] for axis in "xyz"]
    offsets = [int(fields[axis].offset) for axis in "xyz"]
    ends = [offset + np.dtype(form).itemsize for offset, form in zip(offsets, formats, strict=True)]
    width, height = int(cloud.width), int(cloud.height)
    size, step = int(cloud.row_step) * height, int(cloud.point_step)
    if step < max(ends) or cloud.row_step < width * step or len(cloud.data) < size or not size:
        raise ValueError(
            f"the point cloud has {len(cloud.data)} bytes, not {height} rows of {width}"
        )
    axes: Any = {"names": list("xyz"), "formats": formats, "offsets": offsets}
    kind = np.dtype(axes | {"itemsize": step})
    rows = np.frombuffer(cloud.data, np.uint8, size).reshape(height, int(cloud.row_step))
    found = np.ascontiguousarray(rows[:, : width * step]).view(kind)
    return np.stack([np.asarray(found[axis], dtype=float) for axis in "xyz"], axis=-1)


def _is_message(source: Any) -> bool:
    return all(hasattr(source, name) for name in ("fields", "point_step", "row_step", "data"))


def _is_cloud(source: Any) -> bool:
    return hasattr(source, "points") or "positions" in getattr(source, "point", ())


def _is_rgbd(source: Any) -> bool:
    return hasattr(source, "depth") and hasattr(source, "color")


def _is_realsense(source: Any) -> bool:
    return hasattr(source, "get_depth_frame") or hasattr(source, "get_units")


def _points_of(cloud: Any) -> Matrix:
    """Returns the points [N, 3] of a cloud of open3d."""
    found = cloud.points if hasattr(cloud, "points") else cloud.point["positions"].cpu().numpy()
    points = np.asarray(found, dtype=float)
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(f"the cloud's points have shape {points.shape}; it must be (N, 3)")
    return points


def view_of_grid(points: Matrix, X_WC: Matrix) -> View:
    """Returns the view of the points [H, W, 3] of a PointCloud2; with H = 1 it is not organised."""
    return view_of_organized(points, X_WC) if len(points) > 1 else _view_of_points(points, X_WC)


def _view_of_points(points: Matrix, X_WC: Matrix) -> View:
    """Returns the view of points in the optical frame. Those that are not finite, or not in front
    of the camera, are no measurements.
    """
    points = points.reshape(-1, 3)
    seen = points[np.isfinite(points).all(axis=1) & (points[:, 2] > 0)]
    return view_of_cloud(frames.transform(X_WC, seen), X_WC[:3, 3])


def _pixels_of(image: Any) -> Matrix:
    """Returns the values [H, W] of an image of open3d."""
    tensor = image.as_tensor().cpu().numpy() if hasattr(image, "as_tensor") else image
    pixels = np.asarray(tensor)
    return pixels[..., 0] if pixels.ndim == 3 and pixels.shape[2] == 1 else pixels


def _frame_of(source: Any) -> tuple[Matrix, Any]:
    """Returns the depths [m] and the camera matrix of a frame, or of a set's depth frame."""
    frame = source.get_depth_frame() if hasattr(source, "get_depth_frame") else source
    if not frame:
        raise ValueError("the frameset has no depth frame")
    profile = frame.get_profile().as_video_stream_profile()
    depth = np.asarray(frame.get_data()) * float(frame.get_units())
    return depth, matrix_of(profile.get_intrinsics())
