# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A clasp as a replay."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..film import spread, timed
from ..film_stage import FilmStage
from ..scene import add, add_segments, plain
from . import bodies
from .film import film, linking_at
from .stage import Scene, camera

if TYPE_CHECKING:
    from ...frames import Matrix
    from ...plans.clasp import Plan
    from ...simulation import Recording
    from ..bodies import Color


class Stage(FilmStage):
    """The scene of a clasp on a viser server; the caption tells the virtual linking."""

    def __init__(self, server: Any, plan: Plan, recording: Recording | None = None) -> None:
        self.plan = plan
        self.film = shown = timed(film(plan, recording))
        things = Scene(plan, shown)
        super().__init__(server, shown, things.object, camera(things, spread(shown, 8), (4, 3)))
        self._add_marks(things, shown.object_poses[0])
        self._add_tree()
        self.last = self._curve_ends(0)
        styles = (("curves", bodies.CURVE, 0.0035), ("chords", bodies.CHORD, 0.0025))
        self.curves = [
            self._add_lines(name, ends, color, radius)
            for (name, color, radius), ends in zip(styles, self.last, strict=True)
        ]

    def tell(self) -> list[str]:
        """What happens, and how far every curve is closed around the loop."""
        linked = linking_at(self.plan, self.film, self.shown.times)
        if self.shown.planned_poses is not None or not len(linked):
            return super().tell()
        return [
            f"{name}: linking " + "  ".join(f"{value:.2f}" for value in row)
            for name, row in zip(self.shown.names, linked, strict=True)
        ]

    def show(self, row: int) -> None:
        """Moves the robot and its finger curves to a row; what stays is not sent again."""
        super().show(row)
        ends = self._curve_ends(self.row)
        for handle, now, before in zip(self.curves, ends, self.last, strict=True):
            if not np.array_equal(now, before):
                handle.points = now
        self.last = ends

    def _add_marks(self, things: Scene, X_WO: Matrix) -> None:
        """Loops, target and cloud, which are fixed to the object."""
        target = [body for body in things.marks if body.name == "target"]
        loops = [body for body in things.marks if body.name != "target"]
        for name, some in (("loops", loops), ("target", target)):
            if some:
                self.carried.append(self.layers.add(name, X_WO))
                for body in some:
                    add(self.layers.scene, f"/{name}/{plain(body.name)}", body, np.eye(4))
        self.carried.append(self.layers.add("cloud", X_WO))
        cloud = np.asarray(self.plan.task.problem.object.points, dtype=np.float32)
        self.layers.scene.add_point_cloud(
            "/cloud/points", cloud, (60, 45, 20), point_size=0.0025, precision="float32"
        )

    def _add_tree(self) -> None:
        points = np.array(self.plan.tree.points, dtype=float).reshape(-1, 3)
        if len(points) < 2:
            return
        parents, path = np.array(self.plan.tree.parents), self.plan.tree.path
        branches = np.stack([points, points[parents]], axis=1)[1:]
        self._add_lines("tree", branches, bodies.NODE, 0.0008)
        if len(path) > 1:
            way = np.stack([points[path[:-1]], points[path[1:]]], axis=1)
            self._add_lines("path", way, bodies.PATH, 0.0025)

    def _add_lines(self, name: str, ends: Matrix, color: Color, radius: float) -> Any:
        """A layer of bars; its handle's `points` move them."""
        self.layers.add(name)
        return add_segments(self.layers.scene, f"/{name}/lines", ends, color, radius)

    def _curve_ends(self, row: int) -> list[Matrix]:
        """[S, 2, 3] segments of all finger curves, and of all chords, in the world."""
        curves = bodies.finger_curves(self.plan.task, self.shown.link_poses[row])
        along = [np.stack([curve[:-1], curve[1:]], axis=1) for curve in curves]
        chords = [curve[[0, -1]] for curve in curves]
        return [
            np.round(ends, 5).astype(np.float32)
            for ends in (np.concatenate(along), np.stack(chords))
        ]
