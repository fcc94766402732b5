# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays of fingertip plans."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ...fingertip import Plan
    from ...simulation.results import Recording
    from ..replay import Stage


def draw(plan: Plan) -> Figure:
    """Draws the object at some moments, and its stability."""
    from .picture import draw

    return draw(plan)


def set_stage(server: Any, plan: Plan, recording: Recording | None = None) -> Stage:
    """Sets up the scene of a replay on a viser server, of the plan or of a recording."""
    from .replay import Stage

    return Stage(server, plan, recording)
