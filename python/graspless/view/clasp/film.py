# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A clasp over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import film as films

if TYPE_CHECKING:
    from ...clasp import Plan
    from ...frames import Matrix
    from ...simulation.results import Recording

SPEEDS = {"reach": 0.7, "close": 0.35}  # [rad/s]


def film(plan: Plan, recording: Recording | None = None) -> films.Film:
    """Returns a recording, or the plan's rows at a speed for watching, or else the start."""
    problem = plan.task.problem
    return films.film(plan, recording, problem.q_start, problem.X_WO, SPEEDS)


def linking(plan: Plan) -> Matrix:
    """Returns the virtual linking of every row, [N, curves]; no rows without motion."""
    rows = [segment.virtual_linking for segment in plan.segments if len(segment)]
    return np.concatenate(rows) if rows else np.empty((0, 0))


def linking_at(plan: Plan, shown: films.Film, times: Matrix) -> Matrix:
    """Returns the virtual linking at moments of the plan's film, [T, curves].

    Parameters
    ----------
    plan : Plan
    shown : Film
        Film of the plan, with a moment for each of its rows.
    times : array [T]
        Times [s]. Between two rows the earlier one counts: linking jumps where curves cross.
    """
    found = linking(plan)
    if not len(found):
        return found
    before = np.clip(np.searchsorted(shown.times, times, side="right") - 1, 0, len(found) - 1)
    return np.asarray(found[before])
