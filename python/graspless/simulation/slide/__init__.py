# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of slides by the whole arm: checks the pose of the object, and lifts it."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from ...errors import TaskError
from ..results import Running
from ..settings import SLIDE_SPREAD, Slide
from .conditions import CONDITIONS, draw
from .execution import Execution
from .judge import FAILURES

if TYPE_CHECKING:
    from collections.abc import Generator, Sequence

    from ...slide import Plan
    from ..results import Trial
    from ..variation import Variation
    from .truth import Truth

MEASURES = {
    "position_error": "position error of the object before the grasp [m]",
    "angle_error": "angle error of the object before the grasp [rad]",
    "overhang": "length of the object beyond the edge after the slide [m]",
    "mean_force": "mean force of the finger on the sliding object [N]",
    "max_force": "largest force of the finger on the sliding object [N]",
    "shift_by_lift": "distance that the object moved between slide and grasp [m]",
    "lift_height": "height of the object above its start at the end of the lift [m]",
    "lift_reach": "height to which the arm can lift straight up, up to the height requested [m]",
    "creep": "distance that the object moved in the hand during lift and hold [m]",
}

SPREAD = SLIDE_SPREAD

FOLLOWED_FAILURES = {"stopped": "the follower of the plan gave up"}
FOLLOWED_MEASURES = {
    "resumes": "number of new plans during the slide without lifting off",
    "restarts": "number of times that the hand was lifted off to begin anew",
    "update": "longest processor time of an update of the follower [s]",
    "resume_seconds": "longest processor time of a search for the rest of a slide [s]",
    "anew_seconds": "longest processor time of a search for a whole new plan [s]",
}


def run(
    plan: Plan, variation: Variation, *, record: bool = False, settings: Slide | None = None
) -> Trial:
    """Executes a solved plan; `settings` are for tests."""
    _require_rest(plan)
    return execute(plan, variation, record=record, settings=settings)


def _require_rest(plan: Any) -> None:
    """Raises TaskError for a resumed plan."""
    if getattr(plan, "resumed", None) is not None:  # a pinch has none
        raise TaskError(
            "a resumed plan begins with the finger pressed on the object, and the simulation "
            "begins at rest: simulate the plan that was interrupted"
        )


def execute(
    plan: Any, variation: Variation, *, record: bool = False, settings: Slide | None = None
) -> Trial:
    """Executes a solved plan of a slide or of a pinch, and lifts the object."""
    start = time.perf_counter()
    return finished(Execution(plan, variation, settings or Slide()), record, start)


def start(plan: Any, variation: Variation) -> Running:
    """Returns the execution of a solved plan, to be run step by step."""
    _require_rest(plan)
    return running(Execution(plan, variation, Slide()))


def running(execution: Execution) -> Running:
    """Returns an execution to be run step by step."""

    def steps() -> Generator[str, None, Trial]:
        yield from execution.steps()
        return execution.trial()

    return Running(execution.scene.model, execution.data, execution.object_pose, steps())


def follow(
    plan: Plan,
    variation: Variation,
    seed: Sequence[int],
    *,
    record: bool = False,
    settings: Slide | None = None,
    truth: Truth | None = None,
) -> Trial:
    """Executes a solved plan in closed loop; `seed` is that of the camera.

    `truth` is simulated in place of the object and the obstacles that the plan knows.
    """
    from .closed_loop import FollowedExecution

    _require_rest(plan)
    start = time.perf_counter()
    execution = FollowedExecution(plan, variation, settings or Slide(), seed, truth)
    return finished(execution, record, start)


def finished(execution: Execution, record: bool, start: float) -> Trial:
    """Runs an execution that was begun at `start` to its end; returns the trial."""
    if record:
        execution.record()
    execution.run()
    return execution.trial(time.perf_counter() - start)


__all__ = [
    "CONDITIONS",
    "FAILURES",
    "FOLLOWED_FAILURES",
    "FOLLOWED_MEASURES",
    "MEASURES",
    "SPREAD",
    "draw",
    "execute",
    "finished",
    "follow",
    "run",
    "running",
    "start",
]
