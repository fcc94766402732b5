# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays of chains, made from those of their stages."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...kinds import part

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..._plan import Plan as AnyPlan
    from ...chain import Plan
    from ...simulation import Recording
    from ..replay import Stage as AnyStage

NO_TIME = 1e-9  # too short to find a plan: the start alone is drawn [s]


def draw(plan: Plan) -> Figure:
    """Draws the stages below each other."""
    from .picture import draw

    return draw(plan)


def set_stage(server: Any, plan: Plan, recording: Recording | None = None) -> AnyStage:
    """Sets up the scene of a replay on a viser server, of the plan or of a recording.

    A recording is shown in the scene of the first stage.
    """
    if recording is not None:
        first: AnyStage = part("view", plan.stages[0].kind).set_stage(
            server, plan.stages[0], recording
        )
        return first
    from .replay import Stage

    return Stage(server, plan)


def stages_of(plan: Plan) -> list[tuple[str, AnyPlan]]:
    """Returns names and plans of the stages; for a chain without plans, its start."""
    if plan.stages:
        return list(zip(plan.names, plan.stages, strict=True))
    from ... import _api

    problem = plan.task.problem
    return [(problem.stages[0].name, _api.plan(problem.first, seconds=NO_TIME))]
