# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays of chains: those of their stages, one after the other."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ...plans.chain import Plan
    from ..replay import Stage


def draw(plan: Plan) -> bytes:
    """A picture as the bytes of a PNG file: those of the stages below each other."""
    from .picture import draw

    return draw(plan)


def set_stage(server: Any, plan: Plan) -> Stage:
    """The scene of a replay on a viser server."""
    from .replay import Stage

    return Stage(server, plan)
