# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A slide as a replay."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..replay import RATE, Captions, add, look, move, plain
from . import bodies
from .film import film
from .stage import camera, spread

if TYPE_CHECKING:
    from ...plans.slide import Plan


class Stage:
    """The scene of a film on a viser server; `show` moves what moves."""

    def __init__(self, server: Any, plan: Plan) -> None:
        self.shown = shown = film(plan).resampled(RATE)
        self.rows = len(shown.times)
        self.row = -1
        task = shown.plan.task
        scene = server.scene
        X_WS = np.asarray(task.problem.support.X_WS)
        add(scene, "/table", bodies.table_body(task), X_WS)
        for body, X_WB in bodies.obstacles(task):
            add(scene, f"/obstacles/{plain(body.name)}", body, X_WB)
        self.links = [
            (i, add(scene, f"/robot/{plain(body.name)}", body, shown.link_poses[0, i]))
            for i, body in enumerate(bodies.robot(task))
            if body.parts
        ]
        self.thing = add(scene, "/object", bodies.object_body(task), shown.object_poses[0])
        trail = bodies.trail_body(shown)
        if trail.parts:
            add(scene, "/fingertip", trail, np.eye(4))
        view = camera(shown, 4, 3, spread(shown))  # all of the way, not some moments of it
        look(server, view)
        self.captions = Captions(scene, view, shown.names)

    def show(self, row: int) -> None:
        """Moves the robot and the object to a row; what stays is not sent again."""
        row = min(max(row, 0), len(self.shown.times) - 1)
        before, self.row = self.row, row
        for i, handle in self.links:
            move(handle, self.shown.link_poses[row, i], self.shown.link_poses[before, i], before)
        move(self.thing, self.shown.object_poses[row], self.shown.object_poses[before], before)
        self.captions.show(self.shown.names[row])
