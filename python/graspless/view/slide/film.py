# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A slide or a pinch over time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .. import film as films

if TYPE_CHECKING:
    from ... import pinch, slide
    from ...simulation.results import Recording

SPEEDS = {"press": 0.15, "slide": 0.3, "lift": 0.4, "grasp": 0.4, "close": 0.3}  # [rad/s]


def film(plan: slide.Plan | pinch.Plan, recording: Recording | None = None) -> films.Film:
    """Returns a recording, or the plan's rows at a speed for watching, or else the start."""
    return films.film(plan, recording, plan.q_start, plan.X_WO_start, SPEEDS)
