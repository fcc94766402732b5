# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of clasps: the hand reaches, closes to its grip torque, and the object is pulled.

Until then the object stands on a level floor under its lowest points, by its own weight; one that
cannot stand on them is held. Then floor and weight are taken away, so that a pull in any direction
asks the same of the hand. Robot and object touch by the links' shapes and the triangles that bound
its surface; obstacles stop the robot alone.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from ...tasks.clasp.hand import hand_of
from ...timing import time as timed
from ..results import Running, Trial
from ..robots import set_positions
from ..settings import Clasp
from ..variation import Variation
from .closing import left_open
from .execution import Execution, Recorder, executed, execution_of
from .model import make_world

if TYPE_CHECKING:
    from collections.abc import Generator, Mapping, Sequence

    from ... import geometry
    from ...clasp import Plan
    from ...frames import Matrix
    from ...timing import Trajectory
    from .judge import Judge

FAILURES = {
    "hit": "the object moved before the hand closed, or the robot touched an obstacle",
    "not_closed": "a finger was not linked with the loop after closing (if none is, the later "
    "tests are skipped), or the plan ends before a joint of the hand touches anything",
    "escaped": "random wrenches pulled the loop out of the closed hand, even with locked motors",
    "forced_open": "random wrenches forced the fingers open; the hand held with locked motors",
    "pulled_out": "the loop came out of the closed hand under a straight pull below 15 N",
    "open_hand_holds": "the open hand (negative control) lost the loop neither in a sequence of "
    "wrenches nor under the pull",
}

MEASURES = {
    "moved_before": "distance that the object moved before the hand closed [m]",
    "moved_by_closing": "distance that it had moved at the last row of the plan [m]",
    "moved_by_grip": "distance that it had moved when the motors reached their limit [m]",
    "linking": "least virtual linking of the fingers of the closed hand",
    "grip": "largest joint torque of the closed hand, as a fraction of its limit",
    "held": "number of sequences of random wrenches that the closed hand held",
    "held_dragged": "number held if lost sequences are repeated with drag on the object",
    "held_locked": "number held if lost sequences are repeated with locked motors",
    "sequences": "number of sequences of random wrenches",
    "pull": "straight pull that the closed hand held, at most 60 N or what is needed [N]",
    "open_pull": "straight pull at which the open hand lost the object [N]",
    "open_held": "number of the same sequences that the open hand held",
    "open_linked": "number of fingers of the opened hand that are linked with the loop",
}


def failures_of(plan: Plan) -> dict[str, str]:
    """Returns the meaning of the failures for a plan, whose hand may need less than 15 N."""
    needed = f"{_settings(plan).pull_needed:.3g} N"
    return FAILURES | {"pulled_out": FAILURES["pulled_out"].replace("15 N", needed)}


def run(
    plan: Plan,
    variation: Variation,
    *,
    record: bool = False,
    settings: Clasp | None = None,
    solids: Sequence[geometry.PlacedShape] | None = None,
) -> Trial:
    """Executes a solved plan.

    `settings` instead of those for the load of the task; `solids`, in O, instead of the cloud's
    skin.
    """
    return executed(partial(_prepare, plan, variation, settings, solids), record)


def start(plan: Plan, variation: Variation) -> Running:
    """Returns the execution of a solved plan, to be run step by step until the hand has gripped.

    The last step also pulls at the object.
    """
    return _prepare(plan, variation, None, None, None)


def _prepare(
    plan: Plan,
    variation: Variation,
    settings: Clasp | None,
    solids: Sequence[geometry.PlacedShape] | None,
    recorder: Recorder | None,
) -> Running:
    chosen = settings or _settings(plan)
    pull_W = plan.task.problem.pull_W
    world = make_world(plan.task, variation, chosen, solids)
    execution = execution_of(plan, world, recorder)

    def steps() -> Generator[str, None, Trial]:
        measures = yield from close(execution, timed(plan))
        failures = has_closed(execution, plan, measures, solids)
        if execution.judge.linked():  # otherwise the loop was never in the hand
            seeds = _seeds(plan, variation, chosen.sequences)
            pulled, found = _pulled(execution, seeds, _pull_direction(pull_W, execution.judge))
            measures |= found
            failures += pulled
        return execution.trial(variation, failures, measures)

    return Running(world.model, world.data, lambda: world.object_pose, steps())


def held_locked(plan: Plan, q: Matrix, seeds: Sequence[list[int]]) -> tuple[bool, float]:
    """Tests a hand that does not move: its motors are locked at a configuration.

    Parameters
    ----------
    plan : Plan
        Solved. Its task has robot and object.
    q : array [dof]
        Configuration of all joints [rad or m].
    seeds : list of list of int
        One for each sequence of random wrenches; each starts with the object as in the task.

    Returns
    -------
    bool
        True if the loop stays in the hand in every sequence.
    float
        Least virtual linking of a finger at the start.
    """
    settings = _settings(plan)
    finer = settings.locked_timing
    settings = replace(settings, stiffness_time=finer * settings.stiffness_time)
    world = make_world(plan.task, Variation(timestep=finer), settings)
    set_positions(world.model, world.data, plan.task.problem.robot, q)
    world.data.ctrl[:] = q
    execution = execution_of(plan, world, None)
    world.let_go()
    start = execution.save()
    execution.set_back(start)
    linking = execution.judge.linking()
    with execution.locked():
        for seed in seeds:
            execution.set_back(start)
            if not execution.shake(np.random.default_rng(seed)):
                return False, linking
    return True, linking


def _settings(plan: Plan) -> Clasp:
    """Returns the settings, with the load that a plan for two fingers withstands."""
    load = plan.task.options.stability
    if len(hand_of(plan).fingers) > 1 or (load.force == 0 and load.torque == 0):
        return Clasp()
    return Clasp(force=load.force, torque=load.torque, pull_needed=load.force)


def _pulled(
    execution: Execution, seeds: list[list[int]], direction_W: Matrix
) -> tuple[list[str], dict[str, float]]:
    """Releases the object and pulls at it, in the closed and in the open hand. Returns failures
    and measures.
    """
    settings, recorder = execution.world.settings, execution.recorder
    failures: list[str] = []
    execution.world.let_go()
    closed = execution.save()
    measures = _shaken(execution, closed, seeds, recorder)
    if measures["held_locked"] < settings.sequences:
        failures.append("escaped")
    elif measures["held"] < settings.sequences:
        failures.append("forced_open")
    execution.set_back(closed)
    execution.recorder = recorder
    measures["pull"] = execution.pull(direction_W)
    if measures["pull"] < settings.pull_needed:
        failures.append("pulled_out")
    execution.set_back(closed)
    execution.recorder = None
    measures |= _opened(execution, seeds, direction_W)
    held_open = measures["open_held"] == settings.sequences
    if measures["open_pull"] >= settings.pull_most and held_open:
        failures.append("open_hand_holds")
    return failures, measures


def close(execution: Execution, trajectory: Trajectory) -> Generator[str, None, dict[str, float]]:
    """Reaches, closes and grips. Returns measures."""
    resting = execution.surface()
    yield from execution.settle(execution.world.settings.lead)
    moved = yield from execution.follow(trajectory)
    torque = yield from execution.grip()
    return {
        "moved_before": moved.get("reach", 0.0),
        "moved_by_closing": moved.get("close", 0.0),
        "moved_by_grip": execution.moved(resting),
        "linking": execution.judge.linking(),
        "grip": float(torque.max()),
    }


def has_closed(
    execution: Execution,
    plan: Plan,
    measures: Mapping[str, float],
    solids: Sequence[geometry.PlacedShape] | None = None,
) -> list[str]:
    """Returns the failures of the motion until the hand has gripped."""
    settings = execution.world.settings
    failures = []
    if execution.touched or not measures["moved_before"] <= settings.hit:
        failures.append("hit")
    if measures["linking"] == 0 or left_open(plan, settings, solids) > settings.left:
        failures.append("not_closed")
    return failures


def _seeds(plan: Plan, variation: Variation, count: int) -> list[list[int]]:
    """Returns one seed per sequence, for this trial of this plan. Trials with the same wrenches
    would not be independent.
    """
    of = [plan.segments[-1].positions[-1].tolist(), variation.as_dict()]
    digest = hashlib.sha256(json.dumps(of).encode()).digest()
    return [[int.from_bytes(digest[:8], "little"), k] for k in range(count)]


def _shaken(
    execution: Execution, closed: Any, seeds: list[list[int]], recorder: Recorder | None
) -> dict[str, float]:
    """Runs sequences of random wrenches on the object in the closed hand; records the first.

    One that frees the loop is run again with drag on the object, and with motors that nothing can
    turn. A free object gathers speed from wrench to wrench: what drag keeps in the hand was lost to
    blows, what it does not to the wrench itself. Where locked motors hold, the clasp was good, and
    the fingers too weak.
    """
    held = dragged = rigid = 0
    for sequence, seed in enumerate(seeds):
        execution.set_back(closed)
        execution.recorder = recorder if sequence == 0 else None
        if execution.shake(np.random.default_rng(seed)):
            held += 1
            continue
        execution.set_back(closed)
        with execution.dragged():
            dragged += execution.shake(np.random.default_rng(seed))
        execution.set_back(closed)
        with execution.locked():
            rigid += execution.shake(np.random.default_rng(seed))
    execution.recorder = None
    return {
        "held": float(held),
        "held_dragged": float(held + dragged),
        "held_locked": float(held + rigid),
        "sequences": float(len(seeds)),
    }


def _opened(execution: Execution, seeds: list[list[int]], direction_W: Matrix) -> dict[str, float]:
    """Runs the negative control: the same wrenches with the open hand."""
    execution.open()
    measures = {"open_linked": float(execution.judge.linked())}
    opened = execution.save()
    measures["open_pull"] = execution.pull(direction_W)
    held = 0
    for seed in seeds:
        execution.set_back(opened)
        held += execution.shake(np.random.default_rng(seed))
    return measures | {"open_held": float(held)}


def _pull_direction(pull_W: Matrix | None, judge: Judge) -> Matrix:
    """Returns the direction of the force on the object: against the pull, or out of the hand."""
    if pull_W is None:
        return judge.forward()
    along = np.asarray(pull_W)
    back: Matrix = -along / np.linalg.norm(along)
    return back
