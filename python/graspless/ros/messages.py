# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversions between messages of ROS 2 and arrays. Bad messages raise RefusedError."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from builtin_interfaces.msg import Duration, Time
from geometry_msgs.msg import Point, Pose, PoseArray, Quaternion
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

from .. import frames
from ..perception.readers import points_of_message

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..frames import Matrix

_UNIT = 0.05  # largest difference between the norm of a quaternion and 1


class RefusedError(Exception):
    """A goal that cannot be served. Its text is the reason, which the client gets."""


def seconds_of(stamp: Any) -> float:
    """Returns a Time or Duration in seconds."""
    return float(stamp.sec) + 1e-9 * float(stamp.nanosec)


def time_of(seconds: float) -> Any:
    """Returns the Time of seconds."""
    sec, nanosec = divmod(round(seconds * 1e9), 10**9)
    return Time(sec=sec, nanosec=nanosec)


def duration_of(seconds: float) -> Any:
    """Returns the Duration of seconds."""
    sec, nanosec = divmod(round(seconds * 1e9), 10**9)
    return Duration(sec=sec, nanosec=nanosec)


def matrix_of(position: Any, orientation: Any, what: str) -> Matrix:
    """Returns the pose [4, 4] of a position (or translation) and a quaternion."""
    p = np.array([position.x, position.y, position.z])
    q = np.array([orientation.w, orientation.x, orientation.y, orientation.z])
    if not (np.isfinite(p).all() and np.isfinite(q).all()):
        raise RefusedError(f"{what} has values that are not finite")
    if abs(float(np.linalg.norm(q)) - 1) > _UNIT:
        raise RefusedError(f"{what} has a quaternion of norm {np.linalg.norm(q):.3g}; it must be 1")
    X = frames.from_quaternion(q)
    X[:3, 3] = p
    return X


def pose_of(X: Matrix) -> Any:
    """Returns the Pose of a matrix [4, 4]."""
    x, y, z, qw, qx, qy, qz = frames.to_row(X)
    return Pose(position=Point(x=x, y=y, z=z), orientation=Quaternion(x=qx, y=qy, z=qz, w=qw))


def poses_of(poses: Any, frame: str, stamp: Any) -> Any:
    """Returns a PoseArray of matrices [N, 4, 4]."""
    message = PoseArray(poses=[pose_of(X) for X in poses])
    message.header.frame_id, message.header.stamp = frame, stamp
    return message


def trajectory_of(
    names: Sequence[str], times: Any, positions: Any, velocities: Any, accelerations: Any = None
) -> Any:
    """Returns a JointTrajectory with stamp 0.

    Parameters
    ----------
    names : sequence of str
        Joints, the columns of the arrays.
    times : array [N]
        Times from the start [s].
    positions, velocities, accelerations : array [N, dof]
        [rad, rad/s, rad/s^2], or [m, m/s, m/s^2] for sliding joints.
    """
    message = JointTrajectory(joint_names=list(names))
    for k, t in enumerate(times):
        point = JointTrajectoryPoint(time_from_start=duration_of(float(t)))
        point.positions = np.asarray(positions[k], dtype=float).tolist()
        point.velocities = np.asarray(velocities[k], dtype=float).tolist()
        if accelerations is not None:
            point.accelerations = np.asarray(accelerations[k], dtype=float).tolist()
        message.points.append(point)
    return message


def depth_of(image: Any) -> Matrix:
    """Returns the depths [H, W] of an Image in metres: 32FC1 [m] or 16UC1 [mm]. 0: none."""
    kinds = {"32FC1": ("f4", 1.0), "16UC1": ("u2", 0.001), "mono16": ("u2", 0.001)}
    if image.encoding not in kinds:
        choices = ", ".join(kinds)
        raise RefusedError(f"the depth image is of encoding '{image.encoding}' (one of: {choices})")
    kind, unit = kinds[image.encoding]
    dtype = np.dtype(kind).newbyteorder(">" if image.is_bigendian else "<")
    width, height, step = int(image.width), int(image.height), int(image.step)
    if width < 1 or height < 1 or step < width * dtype.itemsize or len(image.data) < step * height:
        raise RefusedError(
            f"the depth image has {len(image.data)} bytes, too few for {width} x {height} pixels"
        )
    rows = np.frombuffer(image.data, np.uint8, step * height).reshape(height, step)
    pixels = np.ascontiguousarray(rows[:, : width * dtype.itemsize]).view(dtype)
    depth = np.asarray(pixels, dtype=float) * unit
    return np.where(np.isfinite(depth) & (depth > 0), depth, 0.0)


def is_rectified(topic: str) -> bool:
    """Returns True if the name of a topic says that its images are without distortion."""
    return topic.rpartition("/")[2].startswith("image_rect")


def camera_matrix_of(info: Any, image: Any, is_rectified: bool) -> Matrix:
    """Returns K [3, 3] of an image by its camera info, in which d and k are of the raw image."""
    if (info.width, info.height) != (image.width, image.height):
        raise RefusedError(
            f"the camera info is of {info.width} x {info.height} pixels, and the depth image of "
            f"{image.width} x {image.height}"
        )
    if info.header.frame_id != image.header.frame_id:
        raise RefusedError(
            f"the camera info is of frame '{info.header.frame_id}', and the depth image of "
            f"'{image.header.frame_id}'"
        )
    is_distorted = any(abs(value) > 1e-9 for value in info.d)
    if is_distorted and not is_rectified:
        raise RefusedError("the depth image is distorted (camera info: d); rectify it first")
    name, K = "k", np.array(info.k, dtype=float).reshape(3, 3)
    if is_rectified and (is_distorted or any(info.p)):  # some drivers fill k alone
        name, K = "p", np.array(info.p, dtype=float).reshape(3, 4)[:, :3]
    if not (np.isfinite(K).all() and K[0, 0] > 0 and K[1, 1] > 0):
        raise RefusedError(f"the camera info is not calibrated: {name} has no focal lengths")
    return K


def points_of(cloud: Any) -> Matrix:
    """Returns the points [H, W, 3] of a PointCloud2 in its own frame [m]."""
    try:
        return points_of_message(cloud)
    except ValueError as error:
        raise RefusedError(str(error)) from None
