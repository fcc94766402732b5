# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays of chains: those of their stages, one after the other."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...kinds import part

if TYPE_CHECKING:
    from ...plans.chain import Plan
    from ...simulation import Recording
    from ..replay import Stage as AnyStage


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
