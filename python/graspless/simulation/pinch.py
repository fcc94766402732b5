# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of pinches: the execution of slides, without a slide.

The object stands on its support until the hand has closed, and is then lifted by 10 cm.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .settings import SLIDE_SPREAD, Slide
from .slide import FAILURES as SLIDE_FAILURES
from .slide import MEASURES as SLIDE_MEASURES
from .slide import execute, start

if TYPE_CHECKING:
    from ..pinch import Plan
    from .results import Trial
    from .variation import Variation

OF_SLIDES = ("overhang", "mean_force", "max_force")
MEASURES = {name: text for name, text in SLIDE_MEASURES.items() if name not in OF_SLIDES}
MEASURES |= {
    "position_error": "distance that the closing fingers moved the object [m]",
    "angle_error": "angle that the closing fingers turned the object by [rad]",
    "shift_by_lift": "distance that the object moved between closing and grasp [m]",
}
FAILURES = {name: text for name, text in SLIDE_FAILURES.items() if name != "tip_lost"}
SPREAD = SLIDE_SPREAD


def run(
    plan: Plan, variation: Variation, *, record: bool = False, settings: Slide | None = None
) -> Trial:
    """Executes a solved plan; `settings` are for tests."""
    trial = execute(plan, variation, record=record, settings=settings)
    for name in OF_SLIDES:
        trial.measures.pop(name, None)
    return trial


__all__ = ["FAILURES", "MEASURES", "SPREAD", "run", "start"]
