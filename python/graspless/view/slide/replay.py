# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A slide as a replay."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..film import spread
from ..film_stage import FilmStage
from ..replay import add
from . import bodies
from .film import film
from .stage import camera

if TYPE_CHECKING:
    from ...plans.slide import Plan


class Stage(FilmStage):
    """The scene of a slide on a viser server."""

    def __init__(self, server: Any, plan: Plan) -> None:
        shown = film(plan)
        task = plan.task
        # All of the way, not some moments of it.
        view = camera(shown, 4, 3, spread(shown))
        super().__init__(server, shown, bodies.object_body(task), view)
        add(server.scene, "/table", bodies.table_body(task), np.asarray(task.problem.support.X_WS))
        trail = bodies.trail_body(self.shown)
        if trail.parts:
            add(server.scene, "/fingertip", trail, np.eye(4))
