# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of fingertip plans: spheres under position or force control, or an arm.

Trials vary friction by 10 % and the fingers' places by 0.1 mm: `x` and `y` of a variation say
where the first finger is beside its place; the others are beside theirs as far, in directions
evenly round. With an arm the object is beside its place. No mass is varied.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

import numpy as np

from ... import frames
from ...errors import TaskError
from ...timing import time as timed
from ..results import Recording, Running, Trial
from ..settings import FINGERTIP_SPREAD, Fingertip
from .arm import ArmServo, carry_out_by_arm, prepare
from .breaking import disturb
from .execute import Log, execute, steps
from .program import program
from .servo import Servo
from .world import build_world

if TYPE_CHECKING:
    from collections.abc import Generator

    from ...fingertip import Plan
    from ...frames import Matrix
    from ..variation import Variation
    from .script import Script
    from .world import World

SPREAD = FINGERTIP_SPREAD

FAILURES = {
    "off": "a corner of the object was too far from its planned position (1 mm, 1.5 mm if varied)",
    "lost": "a corner of the object was more than 1 cm from its planned position",
    "hit": "an obstacle was touched, the robot touched a plane, or a link other than a "
    "fingertip touched the object",
    "slipped": "a fingertip slipped by more than 1 mm on the object",
    "chatter": "the floor's force was zero for more than 5 % of the sliding time",
}

MEASURES = {
    "vertex_error": "largest distance of a corner of the object from its planned position [m]",
    "vertex_error_end": "largest distance at the end of the motion [m]",
    "slip": "largest distance of a fingertip from its planned place on the object [m]",
    "hit": "largest forbidden penetration [m]",
    "floor_lost": "fraction of the sliding and turning time without force from floor and walls",
    "duration": "duration of the motion [s]",
}


def run(plan: Plan, variation: Variation, *, record: bool = False) -> Trial:
    """Executes a solved plan by its arm or, without one, by bare fingertips."""
    start = time.perf_counter()
    by = carry_out_by_arm if plan.joint_segments else carry_out
    world, script, log = by(plan, variation)
    measures = measure(world, script, log)
    settings = world.settings
    return Trial(
        variation,
        judge(measures, settings, varied=not variation.is_nominal),
        measures,
        time.perf_counter() - start,
        recording(script, log) if record else None,
    )


def start(plan: Plan, variation: Variation) -> Running:
    """Returns the execution of a solved plan by its arm, to be run step by step."""
    if not plan.joint_segments:
        raise TaskError("the plan has no arm: only plans with joint paths run step by step")
    world, script = prepare(plan, variation)
    log = Log()

    def advance() -> Generator[str, None, Trial]:
        yield from steps(world, script, ArmServo(world, script), log)
        measures = measure(world, script, log)
        failures = judge(measures, world.settings, varied=not variation.is_nominal)
        return Trial(variation, failures, measures, 0.0)

    return Running(world.model, world.data, lambda: world.X_WO, advance())


def carry_out(plan: Plan, variation: Variation, *, feeds: bool = True) -> tuple[World, Script, Log]:
    """Executes a plan by bare fingertips. Returns the final world, the commands of each step,
    and the observations.

    `feeds` is a parameter of the servo.
    """
    problem, settings = plan.task.problem, Fingertip()
    world = build_world(problem, variation, settings)
    trajectory = timed(plan, contact_speed=settings.speed, fingers=True)
    script = program(plan, trajectory, settings)
    script = script.at(np.arange(0, script.duration, world.model.opt.timestep))
    world.place(plan.segments[0].X_WO[0], script.centers[0])
    offsets, limit = finger_offsets(variation, world.fingers), problem.fingers.max_normal_force
    servo = Servo(world, script, limit, offsets, feeds=feeds)
    return world, script, execute(world, script, servo)


def finger_offsets(variation: Variation, fingers: int) -> Matrix:
    """Returns the horizontal offset of each finger from its position [n, 3] [m]."""
    turns = 2 * np.pi * np.arange(fingers) / fingers
    x, y = variation.x, variation.y
    along, across = np.cos(turns) * x - np.sin(turns) * y, np.sin(turns) * x + np.cos(turns) * y
    return np.column_stack([along, across, np.zeros(fingers)])


def measure(world: World, script: Script, log: Log) -> dict[str, float]:
    """Returns the measures of an execution."""
    stage = script.stage[log.moments]
    moves = np.isin([script.names[k] for k in stage], ["slide", "turn", "tumble"])
    touches = np.array(log.pressed) > 0
    slips = finger_slips(script, log)
    floor_lost = np.array(log.floor)[moves & (script.slides[log.moments] > 0)] <= 0
    return {
        "vertex_error": float(np.max(log.errors)),
        "vertex_error_end": float(log.errors[-1]),
        "hit": float(np.max(log.hits)),
        "slip": float(np.max(slips[moves & touches.any(axis=1)], initial=0.0)),
        "floor_lost": float(floor_lost.mean()) if floor_lost.size else 0.0,
        "duration": script.duration,
    }


def finger_slips(script: Script, log: Log) -> Matrix:
    """Returns the largest slip of a fingertip along the surface of the object [K] [m]."""
    slips = []
    actual = np.linalg.inv(frames.from_rows(log.places))
    planned = np.linalg.inv(frames.from_rows(script.places[log.moments]))
    of_moments = zip(log.moments, actual, planned, log.centers, strict=True)
    for i, X_OW, X_OW_planned, centers in of_moments:
        should = frames.transform(X_OW_planned, script.centers[i])
        normals = script.normals[i] @ X_OW_planned[:3, :3].T
        off = frames.transform(X_OW, centers) - should
        off -= (off * normals).sum(axis=1, keepdims=True) * normals
        slips.append(float(np.linalg.norm(off, axis=1).max()))
    return np.array(slips)


def judge(
    measures: dict[str, float], settings: Fingertip | None = None, *, varied: bool = False
) -> tuple[str, ...]:
    """Returns names of FAILURES; a value that is not a number exceeds every limit."""
    limits = settings or Fingertip()
    tolerance = limits.varied_tolerance if varied else limits.tolerance
    holds = {
        "lost": measures["vertex_error"] <= limits.lost,
        "off": measures["vertex_error"] <= tolerance,
        "hit": measures["hit"] <= 0,
        "slipped": measures["slip"] <= limits.slipped,
        "chatter": measures["floor_lost"] <= limits.chatter,
    }
    return tuple(name for name, is_so in holds.items() if not is_so)


def recording(script: Script, log: Log) -> Recording:
    """Returns the recording."""
    return Recording(
        times=script.times[log.moments],
        positions=np.array(log.joints),
        object_poses=frames.from_rows(log.places),
        fingers=np.array(log.centers),
        names=[script.names[k] for k in script.stage[log.moments]],
        planned_poses=frames.from_rows(script.places[log.moments]),
    )


__all__ = [
    "FAILURES",
    "MEASURES",
    "SPREAD",
    "carry_out",
    "carry_out_by_arm",
    "disturb",
    "run",
    "start",
]
