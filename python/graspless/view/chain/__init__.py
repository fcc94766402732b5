# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays of chains: those of their stages, one after the other."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...kinds import part

if TYPE_CHECKING:
    from ...plans import Plan as AnyPlan
    from ...plans.chain import Plan
    from ...simulation import Recording
    from ..replay import Stage as AnyStage

NO_TIME = 1e-9  # for a planner to find anything: a plan without motion is drawn as it starts [s]


def draw(plan: Plan) -> bytes:
    """A picture as the bytes of a PNG file: those of the stages below each other."""
    from .picture import draw

    return draw(plan)


def set_stage(server: Any, plan: Plan, recording: Recording | None = None) -> AnyStage:
    """The scene of a replay on a viser server, of the plan or of what became of it; that has the
    first stage's scene.
    """
    if recording is not None:
        first: AnyStage = part("view", plan.stages[0].kind).set_stage(
            server, plan.stages[0], recording
        )
        return first
    from .replay import Stage

    return Stage(server, plan)


def stages_of(plan: Plan) -> list[tuple[str, AnyPlan]]:
    """Names and plans of the stages; of a chain that ended before the first, its start."""
    if plan.stages:
        return list(zip(plan.names, plan.stages, strict=True))
    from ... import plans

    problem = plan.task.problem
    return [(problem.stages[0].name, plans.plan(problem.first, seconds=NO_TIME))]
