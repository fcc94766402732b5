# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replay of a clasp."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..bodies import LOOP
from ..film import spread, timed
from ..film_stage import FilmStage
from ..scene import add, add_segments, plain
from . import bodies
from .film import film, linking_at
from .stage import Scene, camera

if TYPE_CHECKING:
    from ...clasp import Plan
    from ...frames import Matrix
    from ...simulation.results import Recording
    from ..bodies import Color

CLOUD_RGB = (60, 45, 20)
CLOUD: Color = (60 / 255, 45 / 255, 20 / 255)


class Stage(FilmStage):
    """Scene of a clasp on a viser server; the caption shows the virtual linking."""

    def __init__(self, server: Any, plan: Plan, recording: Recording | None = None) -> None:
        self.plan = plan
        self.film = shown = timed(film(plan, recording))
        things = Scene(plan, shown)
        super().__init__(server, shown, things.object, camera(things, spread(shown, 8), (4, 3)))
        self._add_marks(things, shown.object_poses[0])
        self._add_tree()
        self.last = self._curve_ends(0)
        styles = (("curves", bodies.CURVE, 0.0035), ("chords", bodies.CHORD, 0.0025))
        self.layers.explain(bodies.CURVE, "finger curves")
        self.layers.explain(bodies.CHORD, "chords, which close them")
        self.curves = [
            self._add_lines(name, ends, color, radius)
            for (name, color, radius), ends in zip(styles, self.last, strict=True)
        ]

    def tell(self) -> list[str]:
        """Returns captions: the segment, and the virtual linking of every finger."""
        linked = linking_at(self.plan, self.film, self.shown.times)
        if self.shown.planned_poses is not None or not len(linked):
            return super().tell()
        return [
            f"{name}: virtual linking " + "  ".join(f"{value:.2f}" for value in row)
            for name, row in zip(self.shown.names, linked, strict=True)
        ]

    def show(self, row: int) -> None:
        """Moves the robot and its finger curves to a row; sends only what has changed."""
        super().show(row)
        ends = self._curve_ends(self.row)
        for handle, now, before in zip(self.curves, ends, self.last, strict=True):
            if not np.array_equal(now, before):
                handle.points = now
        self.last = ends

    def _add_marks(self, things: Scene, X_WO: Matrix) -> None:
        """Adds loops, target and point cloud, which move with the object."""
        target = [body for body in things.marks if body.name == "target"]
        loops = [body for body in things.marks if body.name != "target"]
        for name, some in (("loops", loops), ("target", target)):
            if some:
                self.carried.append(self.layers.add(name, X_WO))
                for body in some:
                    add(self.layers.scene, f"/{name}/{plain(body.name)}", body, np.eye(4))
        self._explain_marks(len(loops), bool(target))
        self.carried.append(self.layers.add("cloud", X_WO))
        cloud = np.asarray(self.plan.task.problem.object.points, dtype=np.float32)
        self.layers.scene.add_point_cloud(
            "/cloud/points", cloud, CLOUD_RGB, point_size=0.0025, precision="float32"
        )

    def _explain_marks(self, loops: int, has_target: bool) -> None:
        clasped = self.plan.loop is not None
        if clasped:
            self.layers.explain(bodies.CLASPED, "clasped loop")
        if loops > clasped:
            self.layers.explain(LOOP, "other loops")
        if has_target:
            self.layers.explain(bodies.TARGET, "target: where the loop is clasped")
        self.layers.explain(CLOUD, "point cloud")

    def _add_tree(self) -> None:
        points = self.plan.tree.p_W
        if len(points) < 2:
            return
        parents, path = np.array(self.plan.tree.parents), np.array(self.plan.tree.path, dtype=int)
        branches = np.stack([points, points[parents]], axis=1)[1:]
        self._add_lines("tree", branches, bodies.NODE, 0.0008)
        self.layers.explain(bodies.NODE, "search tree of the hand's centre")
        if len(path) > 1:
            ends = np.stack([points[path[:-1]], points[path[1:]]], axis=1)
            self._add_lines("path", ends, bodies.PATH, 0.0025)
            self.layers.explain(bodies.PATH, "path found")

    def _add_lines(self, name: str, ends: Matrix, color: Color, radius: float) -> Any:
        """Adds a layer of bars; setting `points` of the handle moves them."""
        self.layers.add(name)
        return add_segments(self.layers.scene, f"/{name}/lines", ends, color, radius)

    def _curve_ends(self, row: int) -> list[Matrix]:
        """Returns the segments, [S, 2, 3] in the world, of all finger curves and of all chords."""
        curves = bodies.finger_curves(self.plan.task, self.shown.link_poses[row])
        along = [np.stack([curve[:-1], curve[1:]], axis=1) for curve in curves]
        chords = [curve[[0, -1]] for curve in curves]
        return [
            np.round(ends, 5).astype(np.float32)
            for ends in (np.concatenate(along), np.stack(chords))
        ]
