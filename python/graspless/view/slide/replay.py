# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replay of a slide."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..bodies import GHOST, TRAIL
from ..film import spread, timed
from ..film_stage import GHOST_OPACITY, FilmStage, ghost_of
from . import bodies
from .film import film
from .stage import camera

if TYPE_CHECKING:
    from ...simulation.results import Recording
    from ...slide import Plan


class Stage(FilmStage):
    """Scene of a slide on a viser server."""

    def __init__(self, server: Any, plan: Plan, recording: Recording | None = None) -> None:
        planned = film(plan)
        shown = timed(planned if recording is None else film(plan, recording))
        task = plan.task
        thing = bodies.object_body(task)
        # The camera sees the whole motion, not only some moments.
        super().__init__(server, shown, thing, camera(shown, 4, 3, spread(shown)))
        X_WS = np.asarray(task.problem.support.X_WS)
        self.layers.add_body(bodies.table_body(task), X_WS)
        self.contact = None
        if not plan:
            return
        if recording is None:
            self.layers.add_body(ghost_of(thing, "goal"), plan.X_WO_goal, GHOST_OPACITY)
            self.layers.explain(GHOST, "goal of the slide")
        trail, contact = bodies.trail_body(planned), bodies.contact_body(planned)
        if trail.parts:
            self.layers.add_body(trail, np.eye(4))
            self.layers.explain(TRAIL, "path of the fingertip (ribbon)")
        if contact.parts:
            self.contact = self.layers.add_body(contact, shown.object_poses[0])
            self.layers.explain(bodies.CONTACT, "contact of the fingertip (ring)")
            self.carried.append(self.contact)
