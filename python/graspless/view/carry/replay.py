# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replay of a carry."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ... import frames
from ..bodies import GHOST
from ..film import spread, timed
from ..film_stage import GHOST_OPACITY, FilmStage, ghost_of
from .film import film
from .stage import Scene, camera

if TYPE_CHECKING:
    from ...carry import Plan
    from ...simulation.results import Recording


class Stage(FilmStage):
    """Scene of a carry on a viser server."""

    def __init__(self, server: Any, plan: Plan, recording: Recording | None = None) -> None:
        shown = timed(film(plan, recording))
        scene = Scene(shown)
        super().__init__(server, shown, scene.object, camera(scene, spread(shown, 8), (4, 3)))
        for body, X_WB in scene.still:
            if body.name == "table":
                self.layers.add_body(body, X_WB)
        if plan and recording is None:
            goal = plan.segments[-1].object_poses[-1]
            self.layers.add_body(ghost_of(scene.object, "goal"), goal, GHOST_OPACITY)
            self.layers.explain(GHOST, "goal")

    def tell(self) -> list[str]:
        """Returns captions: the segment, and how far the object has moved."""
        if self.shown.planned_poses is not None:
            return super().tell()
        start = self.shown.object_poses[0]
        return [
            f"{name}: {_moved(start, X_WO)}"
            for name, X_WO in zip(self.shown.names, self.shown.object_poses, strict=True)
        ]


def _moved(X_A: Any, X_B: Any) -> str:
    distance = np.linalg.norm(X_B[:3, 3] - X_A[:3, 3])
    turn = np.degrees(frames.angle(X_A, X_B))
    text = f"{100 * distance:.1f} cm"
    return text if turn < 1 else f"{text}, {turn:.0f}°"
