# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Proposal of what a slide's robot lacks: SRDF, description of the hand, or both."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

from ..robots import build_robot
from ..source import at
from . import model

if TYPE_CHECKING:
    from ..robots import Robot
    from ..source import Source


def with_proposal(
    robot: Robot, hand: model.Hand | None, source: Source
) -> tuple[Robot, model.Hand, str | None]:
    """Returns a resolved robot and its hand, completed by what `inspect` proposes.

    What is given has precedence.

    Parameters
    ----------
    robot : Robot
        With the text of its URDF, and of its SRDF if it has one.
    hand : Hand or None
        Fields that are given.
    source : Source
        Source of the task, for error messages.

    Returns
    -------
    tuple of Robot, Hand and str or None
        The text says what was proposed.
    """
    if robot.srdf_text is not None and hand is not None:
        return robot, hand, None
    from ...robot import inspect

    built = build_robot(robot, source)
    with at(source, "robot"):
        found = inspect(built)
        if not found.hand:
            raise ValueError("no joint carries the hand")
    given = {} if hand is None else {name: getattr(hand, name) for name in hand.model_fields_set}
    completed = model.Hand(**(found.hand | given))
    lacking = [
        *(["SRDF"] if robot.srdf_text is None else []),
        *(["description of the hand"] if hand is None else []),
    ]
    note = f"no {' and no '.join(lacking)}: proposed {found.summary()}"
    warnings.warn(source.message(("robot",), note), stacklevel=4)
    changes = {"urdf_text": found.urdf, "srdf_text": found.srdf}
    return robot.model_copy(update=changes), completed, note
