# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans that the pictures of a chain are made of."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...kinds import plan_type

if TYPE_CHECKING:
    from ..._plan import Plan as AnyPlan
    from ...chain import Plan

NO_TIME = 1e-9  # too short to find a plan: the start alone is drawn [s]


def stages_of(plan: Plan) -> list[tuple[str, AnyPlan]]:
    """Returns names and plans of the stages; for a chain without plans, its start."""
    if plan.stages:
        return list(zip(plan.names, plan.stages, strict=True))
    problem = plan.task.problem
    first = problem.first.with_changes(seconds=NO_TIME)
    return [(problem.stages[0].name, plan_type(first.kind)._search(first, first.budget))]
