# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of pinching: those of sliding, with other options."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ... import pinch
from ..effective_values import in_force as _in_force
from ..grip import ends_of_jaws, warn_of_grip
from ..slide import require_resolved, state
from ..slide.build import build as build_problem
from ..slide.resolve import resolve
from ..source import at
from .model import PinchTask

if TYPE_CHECKING:
    from ..source import Source

SEARCHES: tuple[str, ...] = ()
Fields = PinchTask


def build(fields: PinchTask, source: Source, other: Source) -> tuple[pinch.Problem, None]:
    """Returns the problem of resolved fields. `other` is the source of the hand."""
    problem = build_problem(fields, source, other, pinch.Problem)
    ends = ends_of_jaws(problem.robot, problem.hand)
    given = fields.options.model_dump(exclude_none=True)
    if ends is not None and "grip_force" not in given:
        warn_of_grip(problem.robot, problem.hand, [ends], source, ", or give grip_force")
    return problem, None


def options(fields: PinchTask, problem: pinch.Problem, source: Source) -> pinch.Options:
    """Returns the options of the search."""
    with at(source, "options"):
        found = pinch.Options(**fields.options.model_dump(exclude_none=True))
        pinch.validate(found)
    return found


def in_force(fields: PinchTask, problem: pinch.Problem, options: pinch.Options) -> dict[str, Any]:
    """Fields with every value that was in force."""
    support = {name: getattr(problem.support, name) for name in ("slab", "friction")}
    return {
        "support": fields.support.model_copy(update=support),
        "hand": _in_force(fields.hand, problem.hand),
        "options": _in_force(fields.options, options),
    }


__all__ = [
    "SEARCHES",
    "Fields",
    "build",
    "in_force",
    "options",
    "require_resolved",
    "resolve",
    "state",
]
