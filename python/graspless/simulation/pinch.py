# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of pinches: the execution of slides, without a slide.

The object stands on its support until the hand has closed, and is then lifted by 10 cm.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from .settings import SLIDE_SPREAD, Slide
from .slide import FAILURES as SLIDE_FAILURES
from .slide import MEASURES as SLIDE_MEASURES
from .slide import execute, start

if TYPE_CHECKING:
    from ..pinch import Plan
    from .results import Trial
    from .variation import Variation

OF_SLIDES = ("overhang", "mean_force", "max_force", "shift_by_lift")
MEASURES = {name: text for name, text in SLIDE_MEASURES.items() if name not in OF_SLIDES}
MEASURES |= {
    "position_error": "distance that the closing fingers moved the object [m]",
    "angle_error": "angle that the closing fingers turned the object by [rad]",
}
FAILURES = {name: text for name, text in SLIDE_FAILURES.items() if name != "tip_lost"}
FAILURES |= {"off_target": "the closing fingers moved the object off its planned pose"}
SPREAD = SLIDE_SPREAD


def run(
    plan: Plan, variation: Variation, *, record: bool = False, settings: Slide | None = None
) -> Trial:
    """Executes a solved plan; `settings` are for tests."""
    trial = execute(plan, variation, record=record, settings=settings)
    return replace(trial, measures=measured(trial.measures))


def measured(measures: dict[str, float]) -> dict[str, float]:
    """Returns the measures of an execution without those that only slides have."""
    return {name: value for name, value in measures.items() if name not in OF_SLIDES}


__all__ = ["FAILURES", "MEASURES", "SPREAD", "run", "start"]
