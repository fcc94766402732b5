# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A film as a replay: what robots and their objects have in common."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .bodies import obstacles, robot
from .replay import RATE, Captions, add, look, move, plain

if TYPE_CHECKING:
    from .bodies import Body
    from .film import Film
    from .raster import Camera


class FilmStage:
    """Robot, object and obstacles of a film on a viser server; `show` moves what moves."""

    def __init__(self, server: Any, film: Film, thing: Body, view: Camera) -> None:
        self.shown = shown = film.resampled(RATE)
        self.rows = len(shown.times)
        self.row = -1
        task = shown.plan.task
        scene = server.scene
        for body, X_WB in obstacles(task):
            add(scene, f"/obstacles/{plain(body.name)}", body, X_WB)
        self.links = [
            (i, add(scene, f"/robot/{plain(body.name)}", body, shown.link_poses[0, i]))
            for i, body in enumerate(robot(task))
            if body.parts
        ]
        self.thing = add(scene, "/object", thing, shown.object_poses[0])
        look(server, view)
        self.texts = self.tell()
        self.captions = Captions(scene, view, self.texts)

    def tell(self) -> list[str]:
        """What to say at each moment."""
        return self.shown.names

    def show(self, row: int) -> None:
        """Moves the robot and the object to a row; what stays is not sent again."""
        row = min(max(row, 0), self.rows - 1)
        before, self.row = self.row, row
        for i, handle in self.links:
            move(handle, self.shown.link_poses[row, i], self.shown.link_poses[before, i], before)
        move(self.thing, self.shown.object_poses[row], self.shown.object_poses[before], before)
        self.captions.show(self.texts[row])
