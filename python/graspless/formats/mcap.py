# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""ROS 2 messages in an MCAP file.

On /joint_trajectory one trajectory_msgs/JointTrajectory at the start; on /joint_states and
/object_pose one message a moment; on /fingertip_0 and so on where a bare fingertip touches, while
it does. Times are from 0.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

from .. import files, frames
from .fingers import contacts
from .ros import seconds

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ..timing import Trajectory

WORLD = "world"  # frame_id of poses


def write(trajectory: Trajectory, path: Path | str) -> None:
    """Writes one file if the path ends in .mcap, else a new folder with its metadata."""
    path = Path(path)
    if path.suffix.lower() != ".mcap":
        with files.new_folder(path) as bag:
            _write_bag(trajectory, bag)
        return
    with files.beside(path) as place:
        _write_bag(trajectory, place / path.stem)
        files.write(path, next(place.glob("*/*.mcap")).read_bytes())


def _write_bag(trajectory: Trajectory, bag: Path) -> None:
    types = get_typestore(Stores.ROS2_HUMBLE)
    with Writer(bag, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connections: dict[str, Any] = {}
        for topic, nanoseconds, message in _messages(trajectory, types.types):
            if topic not in connections:
                name = message.__msgtype__
                connections[topic] = writer.add_connection(topic, name, typestore=types)
            data = types.serialize_cdr(message, message.__msgtype__)
            writer.write(connections[topic], nanoseconds, data)


def _messages(trajectory: Trajectory, types: Any) -> Iterator[tuple[str, int, Any]]:
    """Topic, time [ns] and message, in order of time."""
    ros = _Messages(types)
    if trajectory.joint_names:
        yield "/joint_trajectory", 0, ros.joint_trajectory(trajectory)
    points = contacts(trajectory)
    for k, t in enumerate(trajectory.times):
        nanoseconds = round(float(t) * 1e9)
        if trajectory.joint_names:
            yield "/joint_states", nanoseconds, ros.joint_state(trajectory, k)
        yield "/object_pose", nanoseconds, ros.pose(t, trajectory.object_poses[k])
        for i, p_W in enumerate(points[k]):
            if np.isfinite(p_W).all():
                yield f"/fingertip_{i}", nanoseconds, ros.point(t, p_W)


class _Messages:
    """Messages of the types that are needed."""

    def __init__(self, types: Any) -> None:
        self.types = types

    def joint_trajectory(self, trajectory: Trajectory) -> Any:
        Duration = self.types["builtin_interfaces/msg/Duration"]  # noqa: N806
        Point = self.types["trajectory_msgs/msg/JointTrajectoryPoint"]  # noqa: N806
        points = [
            Point(
                positions=trajectory.positions[k],
                velocities=trajectory.velocities[k],
                accelerations=trajectory.accelerations[k],
                effort=np.zeros(0),
                time_from_start=Duration(*seconds(t)),
            )
            for k, t in enumerate(trajectory.times)
        ]
        return self.types["trajectory_msgs/msg/JointTrajectory"](
            header=self.header(0.0, ""), joint_names=list(trajectory.joint_names), points=points
        )

    def joint_state(self, trajectory: Trajectory, k: int) -> Any:
        return self.types["sensor_msgs/msg/JointState"](
            header=self.header(float(trajectory.times[k]), ""),
            name=list(trajectory.joint_names),
            position=trajectory.positions[k],
            velocity=trajectory.velocities[k],
            effort=np.zeros(0),
        )

    def pose(self, t: float, X_WO: Any) -> Any:  # noqa: N803
        x, y, z, qw, qx, qy, qz = frames.to_row(X_WO)
        pose = self.types["geometry_msgs/msg/Pose"](
            position=self.types["geometry_msgs/msg/Point"](x, y, z),
            orientation=self.types["geometry_msgs/msg/Quaternion"](qx, qy, qz, qw),
        )
        return self.types["geometry_msgs/msg/PoseStamped"](self.header(t, WORLD), pose)

    def point(self, t: float, p_W: Any) -> Any:  # noqa: N803
        point = self.types["geometry_msgs/msg/Point"](*map(float, p_W))
        return self.types["geometry_msgs/msg/PointStamped"](self.header(t, WORLD), point)

    def header(self, t: float, frame: str) -> Any:
        stamp = self.types["builtin_interfaces/msg/Time"](*seconds(t))
        return self.types["std_msgs/msg/Header"](stamp=stamp, frame_id=frame)
