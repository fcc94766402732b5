# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scene of a replay with a robot and an object."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from .bodies import GHOST, OBJECT, OBSTACLE, obstacles, robot
from .clock import tell_pace
from .replay import RATE
from .scene import Captions, Layers, look, move

if TYPE_CHECKING:
    from ..frames import Matrix
    from .bodies import Body
    from .film import Film
    from .raster import Camera

GHOST_OPACITY = 0.3


class FilmStage:
    """Robot, object and obstacles of a film on a viser server; `show` moves them to a row."""

    def __init__(self, server: Any, film: Film, thing: Body, view: Camera) -> None:
        self.shown = shown = film.resampled(RATE)
        self.rows = len(shown.times)
        self.row = -1
        task = shown.plan.task
        self.layers = Layers(server.scene)
        links = [(i, body) for i, body in enumerate(robot(task)) if body.parts]
        placed = [(body, shown.link_poses[0, i]) for i, body in links]
        handles = self.layers.add_bodies("robot", placed)
        self.links = [(i, handle) for (i, _), handle in zip(links, handles, strict=True)]
        # Everything that moves with the object.
        self.carried = [self.layers.add_body(thing, shown.object_poses[0])]
        self.layers.explain(OBJECT, task.problem.object.name)
        self.center = np.concatenate([part.vertices for part in thing.parts]).mean(axis=0)
        self.ghost = None
        if shown.planned_poses is not None:
            there = shown.planned_poses[0]
            self.ghost = self.layers.add_body(ghost_of(thing, "planned"), there, GHOST_OPACITY)
            self.layers.explain(GHOST, "where the plan puts it")
        if self.layers.add_bodies("obstacles", obstacles(task)):
            self.layers.explain(OBSTACLE, "obstacles")
        look(server, view)
        self.texts = [text + tell_pace(shown.pace) for text in self.tell()]
        self.captions = Captions(self.layers, view, self.texts[0])

    def tell(self) -> list[str]:
        """Returns the caption of each row."""
        planned = self.shown.planned_poses
        if planned is None:
            return self.shown.names
        return [
            f"{name}: {apart(planned[row], self.shown.object_poses[row], self.center)}"
            if name in self.shown.compared
            else name
            for row, name in enumerate(self.shown.names)
        ]

    def show(self, row: int) -> None:
        """Moves robot and object to a row; sends only what has changed."""
        row = min(max(row, 0), self.rows - 1)
        before, self.row = self.row, row
        for i, handle in self.links:
            move(handle, self.shown.link_poses[row, i], self.shown.link_poses[before, i], before)
        for handle in self.carried:
            move(handle, self.shown.object_poses[row], self.shown.object_poses[before], before)
        planned = self.shown.planned_poses
        if self.ghost is not None and planned is not None:
            move(self.ghost, planned[row], planned[before], before)
        self.captions.show(self.texts[row])


def ghost_of(thing: Body, name: str) -> Body:
    """Returns the same body in the colour of ghosts, to be drawn transparently."""
    return replace(thing, name=name, parts=[replace(p, color=GHOST) for p in thing.parts])


def apart(X_WP: Matrix, X_WO: Matrix, center: Matrix) -> str:
    """Returns the distance of an object from its planned pose, as text.

    Parameters
    ----------
    X_WP, X_WO : array [4, 4]
        Poses of the object, planned and real.
    center : array [3]
        Centre of the object, in O [m].
    """
    off = X_WO[:3, :3] @ center + X_WO[:3, 3] - X_WP[:3, :3] @ center - X_WP[:3, 3]
    turn = np.degrees(frames.angle(X_WP, X_WO))
    return f"{1000 * np.linalg.norm(off):.1f} mm, {turn:.1f}° from the plan"
