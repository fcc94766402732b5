# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replay of a pinch."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..film import spread, timed
from ..film_stage import FilmStage
from ..slide import bodies
from ..slide.film import film
from ..slide.stage import camera

if TYPE_CHECKING:
    from ...pinch import Plan
    from ...simulation.results import Recording


class Stage(FilmStage):
    """Scene of a pinch on a viser server."""

    def __init__(self, server: Any, plan: Plan, recording: Recording | None = None) -> None:
        shown = timed(film(plan, recording))
        task = plan.task
        super().__init__(
            server, shown, bodies.object_body(task), camera(shown, 4, 3, spread(shown))
        )
        self.layers.add_body(bodies.table_body(task), np.asarray(task.problem.support.X_WS))
