# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Simulation of the first stage of a chain if fingertips carry it out by an arm.

It is a run of its own. What the next one gets is the place where the object then stands, as an
offset and a turn on the support from where the plan has it.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import fingertip
from .settings import FINGERTIP_SPREAD, SLIDE_SPREAD

if TYPE_CHECKING:
    from ..chain import Plan
    from .results import Recording
    from .variation import Variation

FAILURES = {
    "fingers_lost": "the object was more than 1 cm from its place under the fingertips",
    "fingers_hit": "under the fingertips, an obstacle was touched, the robot touched a plane, or a "
    "link other than a fingertip touched the object",
}
MEASURES = {
    "fingers_error": "largest distance of a corner from its place under the fingertips [m]",
    "left_error": "distance of the object from its place when the fingertips had left it [m]",
    "left_angle": "its turn about the vertical from its pose there [rad]",
}


@dataclass(frozen=True)
class Moved:
    """Result of the motion of the object by fingertips.

    Attributes
    ----------
    failures : list of str
        Names of FAILURES.
    measures : dict
        MEASURES.
    variation : Variation
        For what follows: the object is where the fingertips left it.
    recording : Recording
    """

    failures: list[str]
    measures: dict[str, float]
    variation: Variation
    recording: Recording


def move(plan: Plan, variation: Variation) -> Moved:
    """Executes the first stage of a chain by its arm."""
    first: Any = plan.stages[0]
    second: Any = plan.stages[1]
    world, script, log = fingertip.carry_out_by_arm(first, narrowed(variation))
    recording = fingertip.recording(script, log)
    known = fingertip.measure(world, script, log)
    judged = fingertip.judge(known, world.settings)
    X_WW = recording.object_poses[-1] @ np.linalg.inv(first.segments[-1].X_WO[-1])
    X_WO = second.segments[0].object_poses[0]
    p_S = np.asarray(second.task.problem.support.X_WS)[:3, :3].T @ (X_WW @ X_WO - X_WO)[:3, 3]
    yaw = float(np.arctan2(X_WW[1, 0], X_WW[0, 0]))
    measures = {
        "fingers_error": known["vertex_error"],
        "left_error": float(np.linalg.norm((X_WW @ X_WO - X_WO)[:3, 3])),
        "left_angle": yaw,
    }
    failures = [f"fingers_{name}" for name in ("lost", "hit") if name in judged]
    after = dataclasses.replace(variation, x=float(p_S[0]), y=float(p_S[1]), yaw=yaw)
    return Moved(failures, measures, after, recording)


def narrowed(variation: Variation) -> Variation:
    """Returns the variation of a chain as that of a fingertip plan, which varies less."""

    def share(name: str) -> float:
        return float(getattr(FINGERTIP_SPREAD, name) / getattr(SLIDE_SPREAD, name))

    friction, position = share("friction"), share("position")
    return dataclasses.replace(
        variation,
        friction=1 + friction * (variation.friction - 1),
        support_friction=1 + friction * (variation.support_friction - 1),
        mass=1 + share("mass") * (variation.mass - 1),
        x=position * variation.x,
        y=position * variation.y,
        yaw=share("angle") * variation.yaw,
    )


def joined(moved: Recording, after: Recording, plan: Plan) -> Recording:
    """Returns both recordings, one after the other, with the object in its first frame."""
    X_OO = np.linalg.inv(plan.object_frames[1])
    assert moved.planned_poses is not None
    assert after.planned_poses is not None
    count = len(moved.times) + len(after.times)
    step = float(moved.times[-1] - moved.times[-2])
    return dataclasses.replace(
        after,
        times=np.concatenate([moved.times, moved.times[-1] + step + after.times]),
        positions=np.concatenate([moved.positions, after.positions]),
        object_poses=np.concatenate([moved.object_poses, after.object_poses @ X_OO]),
        fingers=np.zeros((count, 0, 3)),
        names=[*moved.names, *after.names],
        planned_poses=np.concatenate([moved.planned_poses, after.planned_poses @ X_OO]),
    )
