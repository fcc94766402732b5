# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conditions of slides in closed loop: one difference from the plan at a time, of its full size."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ...errors import TaskError
from ..variation import Variation

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.random import Generator

    from ...slide import Plan

FRICTION = 0.6  # fraction, drawn evenly and separately for the pad and the support
PLACE, TURN = 0.010, np.radians(10)  # of the object at the start, and of a kick [m, rad]
MASS = (0.5, 2.0)
THICKNESS = 0.001  # [m]
TABLE = 0.003  # [m]

CONDITIONS = {
    "none": "as planned",
    "friction": "friction of pad and of support up to 60 % more or less, each",
    "start": "the object starts 10 mm and 10 degrees off",
    "kick": "the object is displaced by 10 mm and 10 degrees half way",
    "mass": "half the mass, or twice",
    "thickness": "the object 1 mm thinner or thicker",
    "table": "the support 3 mm lower or higher",
}


def draw(condition: str, plan: Plan, random: Generator) -> Variation:
    """Draws a variation of a condition."""
    return _DRAWN[condition](plan, random)


def _sign(random: Generator) -> float:
    return float(random.choice([-1.0, 1.0]))


def _place(random: Generator) -> tuple[float, float, float]:
    way = random.uniform(-np.pi, np.pi)
    return float(PLACE * np.cos(way)), float(PLACE * np.sin(way)), TURN * _sign(random)


def _friction(_: Plan, random: Generator) -> Variation:
    pad, support = 1 + FRICTION * random.uniform(-1, 1, 2)
    return Variation(friction=float(pad), support_friction=float(support))


def _start(_: Plan, random: Generator) -> Variation:
    x, y, yaw = _place(random)
    return Variation(x=x, y=y, yaw=yaw)


def _kick(_: Plan, random: Generator) -> Variation:
    x, y, yaw = _place(random)
    return Variation(kick_x=x, kick_y=y, kick_yaw=yaw)


def _thickness(plan: Plan, random: Generator) -> Variation:
    thickness = float(plan.task.problem.object.thickness)
    if thickness <= THICKNESS:
        raise TaskError(
            f"condition: thickness: the object has {1000 * thickness:g} mm: should be more than "
            f"{1000 * THICKNESS:g} mm"
        )
    return Variation(thickness=1 + _sign(random) * THICKNESS / thickness)


_DRAWN: dict[str, Callable[[Plan, Generator], Variation]] = {
    "none": lambda plan, random: Variation(),
    "friction": _friction,
    "start": _start,
    "kick": _kick,
    "mass": lambda plan, random: Variation(mass=float(random.choice(MASS))),
    "thickness": _thickness,
    "table": lambda plan, random: Variation(table=TABLE * _sign(random)),
}
