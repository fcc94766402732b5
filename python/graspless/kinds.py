# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kinds of tasks, and the modules that handle them.

The packages tasks, plan_files, report and view contain the code that all kinds share, and a
protocol for the code that differs. For each kind, a module with the name of the kind implements
that protocol. To add a kind, add its name here and a module in each package.
"""

from __future__ import annotations

import importlib
from typing import Any

from .errors import TaskError

KINDS = ("slide", "pinch", "fingertip", "clasp", "carry", "chain")


def part(room: str, kind: str, *inside: str) -> Any:
    """Returns the module of a package that handles a kind: `tasks.slide`, `view.slide.picture`.

    It is imported at the first call.
    """
    return importlib.import_module(".".join(("", room, kind, *inside)), __package__)


def plan_type(kind: str) -> Any:
    """Returns the type of a kind's plans: slide.Plan, ..."""
    return importlib.import_module(f".{kind}", __package__).Plan


def stages_of(plan: Any) -> list[Any]:
    """Returns the stages of a chain, or the plan itself. The first one's task has the object."""
    stages: list[Any] = getattr(plan, "stages", [plan])
    return stages


def missing_motion(plan: Any) -> str:
    """Returns what a solved plan lacks to move anything; an empty text if it lacks nothing."""
    stages = stages_of(plan)
    for stage in stages:
        joints = getattr(stage, "joint_segments", ())
        if stage and getattr(stage._task, "arm", None) is not None and not joints:
            return f"the {stage.kind} plan has no joint paths"
        for segment in [*stage.segments, *joints]:
            if not len(segment):
                return f"segment '{segment.name}' of the {stage.kind} plan has no rows"
        if not stage.segments:
            return f"the {stage.kind} plan has no segments"
    return "" if stages else f"the {plan.kind} plan has no stages"


def require_motion(plan: Any, purpose: str) -> None:
    """Raises TaskError if a solved plan lacks something; the message ends with the purpose."""
    missing = missing_motion(plan)
    if missing:
        raise TaskError(f"{missing}: nothing to {purpose}")
