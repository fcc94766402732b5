# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays of fingertip plans."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ...plans.fingertip import Plan
    from ...simulation import Recording
    from ..replay import Stage


def draw(plan: Plan) -> bytes:
    """A picture as the bytes of a PNG file: the object at its steps, and z along the way."""
    from .picture import draw

    return draw(plan)


def set_stage(server: Any, plan: Plan, recording: Recording | None = None) -> Stage:
    """The scene of a replay on a viser server, of the plan or of what became of it."""
    from .replay import Stage

    return Stage(server, plan, recording)
