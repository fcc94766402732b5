# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of the sliding planner."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..force import in_force as _in_force
from .build import build as build_problem
from .build import build_options
from .model import SlideTask
from .resolve import resolve

if TYPE_CHECKING:
    from ... import slide
    from ..source import Source

SEARCHES = ("paper", "fast")
Fields = SlideTask


def require_resolved(fields: SlideTask, source: Source) -> None:
    """Raises TaskError unless fields of a plan file name no file that is not beside it."""
    for section, field in (("robot", "urdf"), ("object", "cloud")):
        if getattr(getattr(fields, section), field) is not None:
            raise source.error((section, field), "must stand in the plan file itself")
    if isinstance(fields.hand, str):
        raise source.error(("hand",), "must stand in the plan file itself")


def build(fields: SlideTask, source: Source, other: Source) -> tuple[slide.Problem, None]:
    """The problem of resolved fields; those of the hand stand in `other`."""
    return build_problem(fields, source, other), None


def options(fields: SlideTask, problem: slide.Problem, source: Source) -> slide.Options:
    """How to search."""
    return build_options(fields, source)


def in_force(fields: SlideTask, problem: slide.Problem, options: slide.Options) -> dict[str, Any]:
    """Fields with every value that was in force."""
    support = {name: getattr(problem.support, name) for name in ("slab", "friction")}
    return {
        "support": fields.support.model_copy(update=support),
        "hand": _in_force(fields.hand, problem.hand),
        "options": _in_force(fields.options, options),
    }


__all__ = ["SEARCHES", "Fields", "build", "in_force", "options", "require_resolved", "resolve"]
