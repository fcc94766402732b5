# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A fingertip plan as a replay."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..bodies import obstacles, robot_bodies
from ..replay import RATE, Captions, add, look, move, plain, shade
from . import bodies
from .film import film
from .stage import camera, swept

if TYPE_CHECKING:
    from ...frames import Matrix
    from ...plans.fingertip import Plan
    from .moments import Moment

WALL_OPACITY, OBJECT_OPACITY = 0.35, 0.8
MOMENTS = 40  # that the camera looks at


class Stage:
    """The scene of a film on a viser server; `show` moves what moves."""

    def __init__(self, server: Any, plan: Plan) -> None:
        self.plan, self.task = plan, plan.task
        self.shown = film(plan, RATE)
        self.rows = len(self.shown)
        self.row = -1
        forces = [np.linalg.norm(m.forces, axis=1).max(initial=0.0) for m in self.shown]
        self.largest = max([*forces, 1e-9])
        scene = server.scene
        some = self.shown[:: max(1, self.rows // MOMENTS)]
        points = swept(self.task, some)
        self._add_surroundings(scene, points)
        thing = bodies.object_body(self.task)
        self.thing = add(scene, "/object", thing, self.shown[0].X_WO, opacity=OBJECT_OPACITY)
        self._add_fingers(scene)
        self.links: list[tuple[int, Any]] = []
        self.poses: Matrix = np.empty((0, 4, 4))
        self._add_robot(scene)
        view = camera(self.task, some, points, (4, 3))
        look(server, view)
        self.captions = Captions(scene, view, [moment.name for moment in self.shown])

    def show(self, row: int) -> None:
        """Moves object, fingers and robot to a moment; what stays is not sent again."""
        row = min(max(row, 0), self.rows - 1)
        before, self.row = self.row, row
        moment, last = self.shown[row], self.shown[max(before, 0)]
        move(self.thing, moment.X_WO, last.X_WO, before)
        self._show_fingers(moment, last, before)
        if self.links and moment.q is not None:
            poses = np.asarray(self.task.arm.robot.forward(moment.q))
            for i, handle in self.links:
                move(handle, poses[i], self.poses[i], before)
            self.poses = poses
        self.captions.show(moment.name)

    def _add_surroundings(self, scene: Any, points: Matrix) -> None:
        floor = bodies.floor_body(self.task, points)
        if floor.parts:
            add(scene, "/floor", floor, np.eye(4))
        for wall in bodies.wall_bodies(self.task, points):
            add(scene, f"/walls/{plain(wall.name)}", wall, np.eye(4), opacity=WALL_OPACITY)
        for body, X_WB in obstacles(self.task):
            add(scene, f"/obstacles/{plain(body.name)}", body, X_WB)

    def _add_fingers(self, scene: Any) -> None:
        """A frame a finger, with a ball of each colour in it, and the arrows of all."""
        radius = self.task.problem.fingers.radius
        self.fingers: list[tuple[Any, dict[str, Any]]] = []
        count = len(self.shown[0].modes)
        for k in range(count):
            frame = scene.add_frame(f"/fingers/{k + 1}", show_axes=False)
            balls = {
                mode: scene.add_icosphere(
                    f"/fingers/{k + 1}/{mode}", radius, shade(color), visible=False
                )
                for mode, color in bodies.MODES.items()
            }
            self.fingers.append((frame, balls))
        width = min(0.018 * self.task.problem.object.size, 0.4 * radius)
        self.arrows = None
        if count:
            self.arrows = scene.add_arrows(
                "/forces",
                np.zeros((count, 2, 3), dtype=np.float32),
                shade(bodies.ARROW),
                shaft_radius=width,
                head_radius=2.2 * width,
                head_length=4.5 * width,
            )

    def _show_fingers(self, moment: Moment, last: Moment, before: int) -> None:
        for k, (frame, balls) in enumerate(self.fingers):
            center = moment.centers_W[k]
            there = bool(np.isfinite(center).all())
            if there:
                frame.position = tuple(np.round(center, 6))
            if before < 0 or moment.modes[k] != last.modes[k] or not there:
                for mode, ball in balls.items():
                    ball.visible = there and mode == moment.modes[k]
        if self.arrows is not None:
            ends = bodies.arrow_ends(self.task, moment, self.largest)
            self.arrows.points = np.round(ends, 6).astype(np.float32)

    def _add_robot(self, scene: Any) -> None:
        moment = self.shown[0]
        if self.task.arm is None or moment.q is None:
            return
        robot = self.task.arm.robot
        self.poses = np.asarray(robot.forward(moment.q))
        self.links = [
            (i, add(scene, f"/robot/{plain(body.name)}", body, self.poses[i]))
            for i, body in enumerate(robot_bodies(robot, self.task.fields.robot))
            if body.parts
        ]
