# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Recording for rerun: bodies in /world, curves of the joints in /joints, names of segments in
/segments; times from 0 on the timeline `time`.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import rerun

from .. import files, frames, geometry
from ..kinds import stages_of
from ..view.bodies import ARM, OBJECT, OBSTACLE, placed_part, robot_bodies
from .fingers import centers, contacts
from .mujoco_scene import OBJECT as THING
from .mujoco_scene import finger_names
from .things import things

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from ..frames import Matrix
    from ..robot import Robot
    from ..timing import Trajectory
    from ..view.bodies import Color
    from .things import Shape

_PLANE = 1.0  # side of the square that is drawn of a plane [m]
_CONTACT = 0.003  # radius of a point of contact [m]
_SOLIDS: dict[str, Any] = {
    "box": lambda size: geometry.Box(size),
    "sphere": lambda size: geometry.Sphere(*size),
    "capsule": lambda size: geometry.Capsule(*size),
}


def write(trajectory: Trajectory, path: Path | str) -> None:
    """Writes the file."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / "plan.rrd"
        stream = rerun.RecordingStream("graspless")
        stream.save(place)
        _Recording(stream, trajectory).send()
        stream.flush()
        stream.disconnect()
        files.write(path, place.read_bytes())


class _Recording:
    """Trajectory that is sent to a stream of rerun."""

    def __init__(self, stream: Any, trajectory: Trajectory) -> None:
        self.stream = stream
        self.trajectory = trajectory

    def send(self) -> None:
        """Sends everything."""
        self.stream.log("world", rerun.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
        found, robot = things(self.trajectory)
        fingers = finger_names(self.trajectory)
        name: tuple[str, ...]
        for thing in found:
            color = OBSTACLE
            if thing.name == THING:
                name, color = ("world", THING), OBJECT
                self._move(name, self.trajectory.object_poses)
            elif thing.name in fingers:
                name, color = ("world", "robot", thing.name), ARM
                self._move(name, self._fingertip(fingers.index(thing.name)))
            else:
                name = ("world", "surroundings", thing.name)
                self._place(name, thing.X_WB)
            for k, shape in enumerate(thing.shapes):
                self._add_shape((*name, str(k)), shape, color)
        if robot is not None:
            self._add_robot(robot)
        self._add_curves()
        self._add_segments()
        self._add_contacts()

    def _add_robot(self, robot: Robot) -> None:
        fields = stages_of(self.trajectory.plan)[0].task.fields.robot
        poses = np.array([np.asarray(robot.forward(q)) for q in self.trajectory.positions])
        for i, body in enumerate(robot_bodies(robot, fields)):
            if body.parts:
                name = ("world", "robot", body.name)
                for k, part in enumerate(body.parts):
                    self._add_mesh((*name, str(k)), part.vertices, part.triangles, part.color)
                self._move(name, poses[:, i])

    def _add_shape(self, name: Sequence[str], shape: Shape, color: Color) -> None:
        vertices, triangles = shape.vertices, shape.triangles
        if shape.kind == "plane":
            corners = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
            vertices, triangles = _PLANE / 2 * np.array(corners), np.array([[0, 1, 2], [0, 2, 3]])
        elif shape.kind in _SOLIDS:
            solid = geometry.PlacedShape(_SOLIDS[shape.kind](shape.size))
            part = placed_part(solid, color)
            vertices, triangles = part.vertices, part.triangles
        self._add_mesh(name, frames.transform(shape.X_BG, vertices), triangles, color)

    def _add_mesh(
        self, name: Sequence[str], vertices: Matrix, triangles: ArrayLike, color: Color
    ) -> None:
        mesh = rerun.Mesh3D(
            vertex_positions=vertices, triangle_indices=triangles, albedo_factor=[*color, 1.0]
        )
        self.stream.log(_path(name), mesh, static=True)

    def _place(self, name: Sequence[str], X_WB: Matrix) -> None:
        w, x, y, z = frames.to_quaternion(X_WB)
        turned = rerun.Quaternion(xyzw=[x, y, z, w])
        pose = rerun.Transform3D(translation=X_WB[:3, 3], quaternion=turned)
        self.stream.log(_path(name), pose, static=True)

    def _move(self, name: Sequence[str], poses: Matrix) -> None:
        rows = frames.to_rows(poses)
        turns = rows[:, [4, 5, 6, 3]]
        columns = rerun.Transform3D.columns(translation=rows[:, :3], quaternion=turns)
        self._send(name, columns)

    def _send(self, name: Sequence[str], columns: Any) -> None:
        time = rerun.TimeColumn("time", duration=self.trajectory.times)
        self.stream.send_columns(_path(name), indexes=[time], columns=columns)

    def _fingertip(self, i: int) -> Matrix:
        places = [centers(self.trajectory, k)[i] for k in range(len(self.trajectory))]
        return np.array([frames.translation(p_W) for p_W in places])

    def _add_curves(self) -> None:
        for what in ("positions", "velocities"):
            values = getattr(self.trajectory, what)
            for i, name in enumerate(self.trajectory.joint_names):
                self._send(("joints", what, name), rerun.Scalars.columns(scalars=values[:, i]))

    def _add_segments(self) -> None:
        """Adds the name of each segment where it begins."""
        index = self.trajectory.segment_index
        begins = np.flatnonzero(np.diff(index, prepend=-1))
        time = rerun.TimeColumn("time", duration=self.trajectory.times[begins])
        names = [str(self.trajectory.segments[index[k]].name) for k in begins]
        columns = rerun.TextLog.columns(text=names)
        self.stream.send_columns("segments", indexes=[time], columns=columns)

    def _add_contacts(self) -> None:
        """Adds the contact points of bare fingertips, none while they are off the object."""
        points = contacts(self.trajectory)
        for i in range(points.shape[1]):
            on = np.isfinite(points[:, i]).all(axis=1)
            columns = rerun.Points3D.columns(
                positions=points[on, i], radii=np.full(np.count_nonzero(on), _CONTACT)
            )
            self._send(("world", "contacts", str(i)), columns.partition(on.astype(int)))


def _path(name: Sequence[str]) -> str:
    return str(rerun.new_entity_path(list(name)))
