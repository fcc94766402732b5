# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Proposal of what the robot of a task lacks: SRDF, description of the hand, or both."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

from .robots import build_robot
from .source import at

if TYPE_CHECKING:
    import pydantic

    from .robots import Robot
    from .source import Source

HandT = TypeVar("HandT", bound="pydantic.BaseModel")


def with_proposal(
    robot: Robot, hand: HandT | None, model: type[HandT], source: Source
) -> tuple[Robot, HandT, str | None]:
    """Returns a resolved robot and its hand, completed by what `inspection` proposes.

    What is given has precedence.

    Parameters
    ----------
    robot : Robot
        With the text of its URDF, and of its SRDF if it has one.
    hand : Hand or None
        Fields that are given.
    model : type
        Type of the hand: of slides or of clasps.
    source : Source
        Source of the task, for error messages.

    Returns
    -------
    tuple of Robot, Hand and str or None
        The text says what was proposed.
    """
    if robot.srdf_text is not None and hand is not None:
        return robot, hand, None
    from ..inspection.build import propose

    kind = "clasp" if "thumb" in model.model_fields else "slide"
    built = build_robot(robot, source, warn=False)
    with at(source, "robot"):
        found = propose(built, None, built.name)
        proposed: dict[str, Any] = found.clasp if kind == "clasp" else found.hand
        if not proposed and hand is None:
            raise ValueError(found.refusal(kind))
    given = {} if hand is None else {name: getattr(hand, name) for name in hand.model_fields_set}
    lacking = [
        *(["SRDF"] if robot.srdf_text is None else []),
        *(["description of the hand"] if hand is None else []),
    ]
    note = f"no {' and no '.join(lacking)}: proposed {found.summary(kind, given)}"
    source.warn(("robot",), note)
    changes = {"urdf_text": found.urdf, "srdf_text": found.srdf}
    completed = model.model_validate(proposed | given)
    return robot.model_copy(update=changes), completed, note
