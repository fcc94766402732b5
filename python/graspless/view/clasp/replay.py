# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A clasp as a replay."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..film import spread
from ..film_stage import FilmStage
from ..replay import add, plain, shade
from . import bodies
from .film import film, linking_at
from .stage import Scene, camera

if TYPE_CHECKING:
    from ...frames import Matrix
    from ...plans.clasp import Plan

WIDTH = 5.0  # of lines [pixels]


class Stage(FilmStage):
    """The scene of a clasp on a viser server; the caption tells the virtual linking."""

    def __init__(self, server: Any, plan: Plan) -> None:
        self.plan = plan
        self.film = shown = film(plan)
        things = Scene(plan, shown)
        super().__init__(server, shown, things.object, camera(things, spread(shown, 8), (4, 3)))
        X_WO = shown.object_poses[0]
        for body in things.marks:
            add(server.scene, f"/loops/{plain(body.name)}", body, X_WO)
        self._add_cloud(server.scene, X_WO)
        self._add_tree(server.scene)
        self.curves = self._add_curves(server.scene)
        self.last: Matrix | None = None

    def tell(self) -> list[str]:
        """What happens, and how far every curve is closed around the loop."""
        linked = linking_at(self.plan, self.film, self.shown.times)
        if not len(linked):
            return self.shown.names
        return [
            f"{name}: linking " + "  ".join(f"{value:.2f}" for value in row)
            for name, row in zip(self.shown.names, linked, strict=True)
        ]

    def show(self, row: int) -> None:
        """Moves the robot and its finger curves to a row; what stays is not sent again."""
        super().show(row)
        ends = self._curve_ends(self.row)
        if self.last is None or not np.array_equal(ends, self.last):
            self.curves.points = ends
            self.last = ends

    def _add_cloud(self, scene: Any, X_WO: Matrix) -> None:
        points = np.asarray(self.plan.task.problem.object.points)
        cloud = points @ X_WO[:3, :3].T + X_WO[:3, 3]
        scene.add_point_cloud(
            "/cloud", cloud.astype(np.float32), (60, 45, 20), point_size=0.0025, precision="float32"
        )

    def _add_tree(self, scene: Any) -> None:
        points = np.array(self.plan.tree.points, dtype=np.float32).reshape(-1, 3)
        if len(points) < 2:
            return
        parents, path = np.array(self.plan.tree.parents), self.plan.tree.path
        branches = np.stack([points, points[parents]], axis=1)[1:]
        scene.add_line_segments("/tree", branches, shade(bodies.NODE), line_width=1.0)
        if len(path) > 1:
            way = np.stack([points[path[:-1]], points[path[1:]]], axis=1)
            scene.add_line_segments("/path", way, shade(bodies.PATH), line_width=3.0)

    def _add_curves(self, scene: Any) -> Any:
        """Finger curves and their chords; the last segment of each is the chord."""
        ends = self._curve_ends(0)
        colors = np.tile(np.array(shade(bodies.CURVE), dtype=np.uint8), (len(ends), 2, 1))
        colors[self._chords()] = shade(bodies.CHORD)
        return scene.add_line_segments("/curves", ends, colors, line_width=WIDTH)

    def _chords(self) -> list[int]:
        hand = self.plan.task.problem.hand
        counts = [len(finger.nodes) + len(hand.thumb.nodes) for finger in hand.fingers]
        return [int(end) - 1 for end in np.cumsum(counts)]

    def _curve_ends(self, row: int) -> Matrix:
        """[S, 2, 3] segments of all closed curves in the world."""
        curves = bodies.finger_curves(self.plan.task, self.shown.link_poses[row])
        closed = [np.stack([curve, np.roll(curve, -1, axis=0)], axis=1) for curve in curves]
        return np.round(np.concatenate(closed), 5).astype(np.float32)
