# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of chains: a slide, a pinch or a clasp followed by carries, executed in one run.

A slide from where the object was put down is part of that run.

Before a slide or a pinch, an arm may have moved the object with its fingertips: a run before that
one.

The carries replace the lift by 10 cm of a slide or a pinch alone, and the pulls at a clasp. If the
last one puts the object down, the hand opens, withdraws, and the object must stand where it was
put. A chain of a slide or a pinch alone is simulated as that one. Other chains are not simulated.
"""

from __future__ import annotations

import dataclasses
import time
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames, timing
from ..errors import TaskError
from ..tasks import scenes
from . import moved, pinch
from .carries import OPEN, RETREAT, require_simulated, with_carries
from .clasp import carried
from .results import Trial
from .settings import SLIDE_SPREAD, Slide
from .slide import FAILURES as SLIDE_FAILURES
from .slide import MEASURES as SLIDE_MEASURES
from .slide import finished, running
from .slide.execution import Execution
from .slide.program import (
    HOLD,
    RAISE,
    REST,
    SQUEEZE,
    Program,
    make_program,
)

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from ..chain import Plan
    from ..frames import Matrix
    from .results import Recording, Running
    from .slide.truth import Truth
    from .variation import Variation

SPREAD = SLIDE_SPREAD
FAILURES = {
    **carried.FAILURES,
    **moved.FAILURES,
    **SLIDE_FAILURES,
    "off_target": "a slide ended with the object off its planned pose, or the closing fingers of a "
    "pinch moved it off",
    "dropped": "the object left the hand while it was carried, moved in it, stayed behind, or was "
    "held but not brought to where it was to be carried",
    "not_placed": "the object did not stand free of the hand, where it was to be put down",
}
MEASURES = {
    **carried.MEASURES,
    **moved.MEASURES,
    **SLIDE_MEASURES,  # of the lift: where nothing is carried
    "kept": "1 if the hand still held the object at the end as it had grasped it",
    "lifted": "1 if the object was in the hand during the hold, at rest and clear of all else",
    "carried": "distance that the hand moved the object, from squeeze to hold [m]",
    "carry_error": "difference between that motion of the object and the planned one [m]",
    "place_error": "distance of the object from its place, at the end [m]",
    "place_angle": "angle between the object and its pose at that place [rad]",
}


def run(
    plan: Plan,
    variation: Variation,
    *,
    record: bool = False,
    settings: Slide | None = None,
    truth: Truth | None = None,
) -> Trial:
    """Executes a solved plan of several stages; `settings` are for tests.

    `truth` is simulated in place of the object and the obstacles that the plan knows.
    """
    require_simulated(plan.task)
    start = time.perf_counter()
    if plan.stages[0].kind != "fingertip":
        return _executed(plan.stages, variation, record, settings, truth)
    before = moved.move(plan, variation)
    done = Trial(variation, tuple(before.failures), before.measures, 0.0, before.recording)
    if not before.failures:
        after = _executed(plan.stages[1:], before.variation, record, settings, truth)
        film = after.recording and moved.joined(before.recording, after.recording, plan)
        measures = before.measures | after.measures
        done = Trial(variation, after.failures, measures, 0.0, film, after.touched)
    film = done.recording if record else None
    return dataclasses.replace(done, seconds=time.perf_counter() - start, recording=film)


def _executed(
    stages: Sequence[Any],
    variation: Variation,
    record: bool,
    settings: Slide | None,
    truth: Truth | None,
) -> Trial:
    """Executes a slide, a pinch or a clasp, and the carries after it."""
    if stages[0].kind == "clasp":
        return carried.run(stages, variation, record=record)
    start = time.perf_counter()
    done = finished(_execution(stages, variation, settings or Slide(), truth), record, start)
    measures = pinch.measured(done.measures) if stages[0].kind == "pinch" else done.measures
    film = done.recording and _with_plan(done.recording, stages)
    return dataclasses.replace(done, measures=measures, recording=film)


def _execution(
    stages: Sequence[Any], variation: Variation, settings: Slide, truth: Truth | None = None
) -> Execution:
    """Returns the execution of a slide or a pinch, and the carries after it, if any."""
    if len(stages) == 1:
        return Execution(stages[0], variation, settings, truth=truth)
    return _Carried(stages, variation, settings, truth)


def start(plan: Plan, variation: Variation) -> Running:
    """Returns the execution of a solved plan, to be run step by step."""
    require_simulated(plan.task)
    first: Any = plan.stages[0]
    if first.kind == "fingertip":
        raise TaskError("a chain that begins with fingertips does not run step by step")
    if first.kind == "clasp":
        return carried.start(plan.stages, variation)
    return running(_execution(plan.stages, variation, Slide()))


def _with_plan(recording: Recording, stages: Sequence[Any]) -> Recording:
    """Adds the planned poses of the object to a recording: on the support, then in the hand."""
    first, carries, later = _parted(stages)
    names = np.array(recording.names)
    last = int(np.flatnonzero(names == RETREAT)[-1]) + 1 if (names == RETREAT).any() else len(names)
    own = [name if row < last else REST for row, name in enumerate(recording.names)]
    poses = timing.time(first).followed(own, recording.times)
    after = np.isin(own, (RAISE, HOLD, OPEN, RETREAT, REST))
    if after.any():
        begin = float(recording.times[after][0])
        for stage in carries:
            trajectory = timing.time(stage)
            rows = after & (recording.times >= begin)
            poses[rows] = trajectory.at(recording.times[rows] - begin).object_poses
            begin += trajectory.duration
    if later is not None and last < len(names):
        slid = timing.time(later).followed(recording.names[last:], recording.times[last:])
        poses[last:] = slid
    return dataclasses.replace(recording, planned_poses=poses)


def _parted(stages: Sequence[Any]) -> tuple[Any, list[Any], Any]:
    """Returns the grasp, the carries after it, and the slide at their end, or None."""
    first, *carries = stages
    later = carries.pop() if carries and carries[-1].kind == "slide" else None
    return first, carries, later


class _Carried(Execution):
    """Execution of a slide or pinch whose lift is replaced by the carries of the plan."""

    def __init__(
        self,
        stages: Sequence[Any],
        variation: Variation,
        settings: Slide,
        truth: Truth | None = None,
    ) -> None:
        first, carries, later = _parted(stages)

        def control(timestep: float) -> Program:
            program = make_program(first, timing.time(first), timestep, settings)
            return with_carries(program, carries, timestep, later, settings)

        last: Any = carries[-1]
        places = last.task.problem.places
        super().__init__(
            first,
            variation,
            settings,
            _obstacles(first, carries, later),
            control,
            truth,
            standing=None if places is None else places.on,
            later=later,
        )
        self.measures = {"kept": 0.0}
        if places is None:  # otherwise it is down again before the hold
            self.measures["lifted"] = 0.0
        self._until = HOLD if places is None else REST
        begin: Matrix = carries[0].segments[0].object_poses[0]
        put: Matrix = last.segments[-1].object_poses[-1]
        self._place: Matrix = put if later is None else later.X_WO_goal
        self._asked: Matrix = put[:3, 3] - begin[:3, 3]
        self._is_put = False
        self._lowest = min(
            float(self.judge.height(segment.object_poses[:, :3, 3]).min())
            for stage in carries
            for segment in stage.segments
        )

    def run(self, until: str = "") -> None:
        """Runs to the end of a phase, by default of the last one."""
        super().run(until or self._until)

    def steps(self, until: str = "") -> Iterator[str]:
        """Does the same; yields the phase before each step."""
        return super().steps(until or self._until)

    def _end_of(self, phase: str, following: str) -> None:
        super()._end_of(phase, following)
        if phase == RETREAT:
            self._is_put = True
            self._let_finger_slide()
        if phase == SQUEEZE:
            self._from = self.judge.pose(self.data)[:3, 3]
            self.judge.lowest = min(self.judge.lowest, self._lowest - self.settings.fell)

    def _measure_slide(self) -> None:
        if not self._is_put:  # it is looked at when it rests, after another slide
            super()._measure_slide()

    def _measure_rested(self) -> None:
        X_WO = self.judge.pose(self.data)
        position = float(np.linalg.norm((X_WO - self._place)[:3, 3]))
        angle = frames.angle(self._place, X_WO)
        self.measures |= {"place_error": position, "place_angle": angle}
        allowed = self.settings.placed
        stands = position <= allowed[0] and angle <= allowed[1]
        if not stands or self.judge.is_touched(self.data):
            self.judge.note("not_placed")

    def _measure_lift(self, phase: str) -> None:
        moved = self.judge.pose(self.data)[:3, 3] - self._from
        creep = float(np.linalg.norm(self._in_hand() - self._held))
        raised = moved + [0.0, 0.0, self._sag()]  # as by a wrist that does not yield
        error = float(np.linalg.norm(raised - self._asked))
        self.measures |= {
            "carried": float(np.linalg.norm(moved)),
            "carry_error": float(np.linalg.norm(moved - self._asked)),
            "creep": creep,
        }
        if "not_grasped" in self.judge.failures:
            return
        if not self.judge.holds(self.data) or max(creep, error) > self.settings.kept:
            self.judge.note("dropped")
        self.measures["kept"] = float(phase == HOLD and "dropped" not in self.judge.failures)


def _obstacles(first: Any, carries: Sequence[Any], later: Any) -> list[Any]:
    """Returns the obstacles of all stages, without the first support, which is the table.

    To a last slide on another support, the slab of the first one is an obstacle.
    """
    stages = [first, *carries] if later is None else [first, *carries, later]
    X_WS = np.asarray(first.task.problem.support.X_WS)
    return [
        obstacle
        for obstacle in obstacles_of(stages)
        if not (scenes.is_of_scene(obstacle.name) and np.allclose(obstacle.X_WB, X_WS))
    ]


def obstacles_of(stages: Sequence[Any]) -> list[Any]:
    """Returns the obstacles of all stages, each once, without the support, which is the table."""
    found: list[Any] = []
    known: list[Any] = []
    for stage in stages:
        given = stage.task.fields.obstacles or []
        # The support of a carry comes after the obstacles of its task.
        for fields, obstacle in zip(given, stage.task.problem.obstacles, strict=False):
            if fields not in known:
                known.append(fields)
                found.append(obstacle)
    return found
