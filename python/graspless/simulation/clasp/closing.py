# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Test in the engine's geometry whether a plan closes the hand until contact."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ...tasks.clasp.hand import hand_of
from ..robots import set_positions
from ..variation import Variation
from .model import make_world

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ... import geometry
    from ...clasp import Plan
    from ..settings import Clasp

_STEP = 0.01  # of a joint [rad; m / 10], as in the planner


def left_open(
    plan: Plan, settings: Clasp, solids: Sequence[geometry.PlacedShape] | None = None
) -> float:
    """Returns how far a joint of the hand could close beyond the last row before a link that it
    moves touches something: the largest of all joints [rad; m / 10], up to `settings.left_most`.

    The object is where the task says. Nothing moves it, unlike in a trial, where a finger that
    pushes the object leaves others without contact.
    """
    task = plan.task
    robot, hand = task.problem.robot, hand_of(plan)
    world = make_world(task, Variation(), settings, solids, robot.ignored_pairs)
    model, data = world.model, world.data
    end = np.asarray(plan.segments[-1].positions[-1])
    closed = robot.clamp(robot.state(hand.closed))
    way = np.sign(closed - robot.clamp(robot.state(hand.open)))
    steps = np.floor(way * (closed - end) * robot.step_weights / _STEP)
    steps = np.minimum(steps, round(settings.left_most / _STEP))
    left = 0
    for joint in robot.group(hand.hand):
        stride = np.zeros(len(end))
        stride[joint] = way[joint] * _STEP / robot.step_weights[joint]
        set_positions(model, data, robot, end)
        before = data.xpos + data.xmat[:, :3]
        for step in range(1, int(steps[joint]) + 1):
            set_positions(model, data, robot, end + step * stride)
            if _touches(model, data, np.any(data.xpos + data.xmat[:, :3] != before, axis=1)):
                break
            left = max(left, step)
    return left * _STEP


def _touches(model: Any, data: Any, moved: Any) -> bool:
    """True if a body that has moved touches something."""
    geoms = data.contact.geom[data.contact.dist < 0]
    return bool(np.any((geoms >= 0) & moved[model.geom_bodyid[geoms]]))
