# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A carry over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import film as films

if TYPE_CHECKING:
    from ...carry import Plan
    from ...simulation.results import Recording

SPEEDS = {"carry": 0.25, "lower": 0.25, "open": 0.5, "retreat": 0.25}  # [rad/s]


def film(plan: Plan, recording: Recording | None = None) -> films.Film:
    """Returns a recording, or the plan's rows at a speed for watching, or else the start."""
    problem = plan.task.problem
    return films.film(plan, recording, problem.q_start, problem.object.X_WB, SPEEDS)
