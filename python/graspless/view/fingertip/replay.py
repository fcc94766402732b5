# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replay of a fingertip plan."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..bodies import GHOST, OBJECT, OBSTACLE, obstacles, robot
from ..clock import tell_pace
from ..film_stage import apart
from ..replay import RATE
from ..scene import Captions, Layers, add_segments, look, move, shade
from . import bodies
from .film import recorded, timed
from .moments import largest_force
from .stage import camera, swept

if TYPE_CHECKING:
    from ...fingertip import Plan
    from ...frames import Matrix
    from ...simulation.results import Recording
    from .moments import Moment

WALL_OPACITY, OBJECT_OPACITY = 0.35, 0.8
MEANINGS = {
    "position": "fingertip in position control",
    "force": "fingertip in force control",
    "free": "fingertip without contact or command",
}
MOMENTS = 40  # moments that the camera must show


class Stage:
    """Scene of a fingertip plan on a viser server; `show` moves it to a row."""

    def __init__(self, server: Any, plan: Plan, recording: Recording | None = None) -> None:
        self.plan, self.task = plan, plan.task
        filmed = timed(plan, RATE) if recording is None else recorded(plan, recording, RATE)
        self.shown, self.pace = filmed
        self.rows = len(self.shown)
        self.row = -1
        self.arrows: Any = None
        self.fingers: list[tuple[Any, dict[str, Any]]] = []
        self.links: list[tuple[int, Any]] = []
        self.poses: Matrix = np.empty((0, 4, 4))
        self.largest = largest_force(self.shown)
        self.layers = Layers(server.scene)
        some = self.shown[:: max(1, self.rows // MOMENTS)]
        points = swept(self.task, some)
        self._add_object()
        self._add_fingers()
        self._add_robot()
        ground = self._add_surroundings(points)
        tails = np.concatenate([bodies.arrow_ends(self.task, m, self.largest)[:, 0] for m in some])
        everything = np.concatenate([points, tails[tails.any(axis=1)], *ground])
        view = camera(self.task, some, everything, (4, 3))
        look(server, view)
        self.captions = Captions(self.layers, view, self._tell(self.shown[0]))

    def show(self, row: int) -> None:
        """Moves object, fingers and robot to a moment; sends only what has changed."""
        row = min(max(row, 0), self.rows - 1)
        before, self.row = self.row, row
        moment, last = self.shown[row], self.shown[max(before, 0)]
        move(self.thing, moment.X_WO, last.X_WO, before)
        if moment.X_WP is not None and last.X_WP is not None:
            move(self.ghost, moment.X_WP, last.X_WP, before)
        self._show_contacts(moment)
        self._show_fingers(moment, last, before)
        if self.links and moment.q is not None:
            poses = np.asarray(self.task.arm.robot.forward(moment.q))
            for i, handle in self.links:
                move(handle, poses[i], self.poses[i], before)
            self.poses = poses
        self.captions.show(self._tell(moment))

    def _tell(self, moment: Moment) -> str:
        if moment.X_WP is None:
            return moment.name + tell_pace(self.pace)
        center = np.asarray(self.task.problem.object.com)
        off = apart(moment.X_WP, moment.X_WO, center)
        return f"{moment.name}: {off}{tell_pace(self.pace)}"

    def _add_object(self) -> None:
        """Adds the object, its goal, and its contacts with floor and walls."""
        thing, first = bodies.object_body(self.task), self.shown[0]
        self.thing = self.layers.add_body(thing, first.X_WO, OBJECT_OPACITY)
        self.layers.explain(OBJECT, self.task.problem.object.name)
        if first.X_WP is not None:
            self.ghost = self._add_outline("planned", first.X_WP)
            self.layers.explain(GHOST, "where the plan puts it")
        elif self.plan.segments:
            self._add_outline("goal", self.plan.segments[-1].X_WO[-1])
            self.layers.explain(GHOST, "goal")
        self.layers.explain(bodies.CONTACT, "contacts with floor and walls")
        self.touching: Matrix = bodies.supported(self.task, first.X_WO)
        self.layers.add("contacts")
        self.contacts = self.layers.scene.add_point_cloud(
            "/contacts/points",
            self.touching,
            shade(bodies.CONTACT),
            point_size=0.03 * self.task.problem.object.size,
            point_shape="circle",
            precision="float32",
        )

    def _add_outline(self, name: str, X_WP: Matrix) -> Any:
        """Adds a layer with the object's edges: a second transparent body would flicker."""
        frame = self.layers.add(name, X_WP)
        edges = bodies.edges(self.task)
        width = 0.004 * self.task.problem.object.size
        add_segments(self.layers.scene, f"/{name}/edges", edges, GHOST, width)
        return frame

    def _show_contacts(self, moment: Moment) -> None:
        touching = bodies.supported(self.task, moment.X_WO)
        if not np.array_equal(touching, self.touching):
            self.contacts.points = self.touching = touching

    def _add_surroundings(self, points: Matrix) -> list[Matrix]:
        """Adds floor, walls and obstacles; returns the floor's corners."""
        floor = bodies.floor_body(self.task, points)
        if floor.parts:
            self.layers.add_body(floor, np.eye(4))
        walls = [(wall, np.eye(4)) for wall in bodies.wall_bodies(self.task, points)]
        self.layers.add_bodies("walls", walls, WALL_OPACITY)
        if self.layers.add_bodies("obstacles", obstacles(self.task)):
            self.layers.explain(OBSTACLE, "obstacles")
        return [part.vertices for part in floor.parts]

    def _add_fingers(self) -> None:
        """Adds a frame per finger with a ball of each colour, and the arrows of all fingers."""
        radius, scene = self.task.problem.fingers.radius, self.layers.scene
        count = len(self.shown[0].modes)
        if not count:
            return
        self.layers.add("fingers")
        for k in range(count):
            frame = scene.add_frame(f"/fingers/{k}", show_axes=False)
            balls = {
                mode: scene.add_icosphere(
                    f"/fingers/{k}/{mode}", radius, shade(color), visible=False
                )
                for mode, color in bodies.MODES.items()
            }
            self.fingers.append((frame, balls))
        shown = {mode for moment in self.shown for mode in moment.modes}
        for mode, meaning in MEANINGS.items():
            if mode in shown:
                self.layers.explain(bodies.MODES[mode], meaning)
        if self.largest > 1e-6:
            self.layers.explain(bodies.ARROW, "nominal contact force")
            self._add_forces(count)

    def _add_forces(self, count: int) -> None:
        width = bodies.arrow_width(self.task)
        self.layers.add("forces")
        self.arrows = self.layers.scene.add_arrows(
            "/forces/arrows",
            np.zeros((count, 2, 3), dtype=np.float32),
            shade(bodies.ARROW),
            shaft_radius=width,
            head_radius=bodies.HEAD_RADIUS * width,
            head_length=bodies.HEAD_LENGTH * width,
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

    def _add_robot(self) -> None:
        moment = self.shown[0]
        if self.task.arm is None or moment.q is None:
            return
        self.poses = np.asarray(self.task.arm.robot.forward(moment.q))
        links = [(i, body) for i, body in enumerate(robot(self.task)) if body.parts]
        handles = self.layers.add_bodies("robot", [(body, self.poses[i]) for i, body in links])
        self.links = [(i, handle) for (i, _), handle in zip(links, handles, strict=True)]
