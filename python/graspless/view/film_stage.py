# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A film as a replay: what robots and their objects have in common."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from .bodies import GHOST, obstacles, robot
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
    """Robot, object and obstacles of a film on a viser server; `show` moves what moves."""

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
        # What moves with the object.
        self.carried = [self.layers.add_body(thing, shown.object_poses[0])]
        self.center = np.concatenate([part.vertices for part in thing.parts]).mean(axis=0)
        self.ghost = None
        if shown.planned_poses is not None:
            there = shown.planned_poses[0]
            self.ghost = self.layers.add_body(ghost_of(thing, "planned"), there, GHOST_OPACITY)
        self.layers.add_bodies("obstacles", obstacles(task))
        look(server, view)
        self.texts = [text + tell_pace(shown.pace) for text in self.tell()]
        self.captions = Captions(self.layers, view, self.texts[0])

    def tell(self) -> list[str]:
        """What to say at each moment."""
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
        """Moves the robot and the object to a row; what stays is not sent again."""
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
    """The same body, to be drawn as glass."""
    return replace(thing, name=name, parts=[replace(p, color=GHOST) for p in thing.parts])


def apart(X_WP: Matrix, X_WO: Matrix, center: Matrix) -> str:
    """How far an object is from where it was planned to be, as text.

    Parameters
    ----------
    X_WP, X_WO : array [4, 4]
        Of the object, planned and real.
    center : array [3]
        Of the object, in O.
    """
    off = X_WO[:3, :3] @ center + X_WO[:3, 3] - X_WP[:3, :3] @ center - X_WP[:3, 3]
    w, *xyz = frames.to_quaternion(np.linalg.inv(X_WP) @ X_WO)
    turn = 2 * np.degrees(np.arctan2(np.linalg.norm(xyz), w))
    return f"{1000 * np.linalg.norm(off):.1f} mm, {turn:.1f}° from the plan"
