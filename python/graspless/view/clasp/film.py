# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A clasp in time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .. import film as films

if TYPE_CHECKING:
    from ...frames import Matrix
    from ...plans.clasp import Plan
    from ...simulation import Recording

SPEEDS = {"reach": 0.7, "close": 0.35}  # [rad/s]


def film(plan: Plan, recording: Recording | None = None) -> films.Film:
    """The plan's rows at a pace for watching, or what was recorded; a plan without motion shows the
    start.
    """
    problem = plan.task.problem
    return films.film(plan, recording, problem.q_start, problem.X_WO, SPEEDS)


def linking(plan: Plan) -> Matrix:
    """[N, curves] virtual linking of every row; no row without motion."""
    rows = [segment.virtual_linking for segment in plan.segments if len(segment)]
    return np.concatenate(rows) if rows else np.empty((0, 0))


def linking_at(plan: Plan, shown: films.Film, times: Matrix) -> Matrix:
    """[T, curves] virtual linking at moments of the plan's film.

    Parameters
    ----------
    plan : Plan
    shown : Film
        Of the plan, with a moment for each of its rows.
    times : array [T]
        [s]; between two rows, what the earlier one has: linking jumps where curves cross.
    """
    found = linking(plan)
    if not len(found):
        return found
    before = np.clip(np.searchsorted(shown.times, times, side="right") - 1, 0, len(found) - 1)
    return np.asarray(found[before])
