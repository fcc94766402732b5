# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays of chains, made from those of their stages."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...kinds import part

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...chain import Plan
    from ...simulation.results import Recording
    from ..replay import Stage as AnyStage


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
