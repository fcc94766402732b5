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

KINDS = ("slide", "pinch", "fingertip", "clasp", "carry", "chain")


def part(room: str, kind: str, *inside: str) -> Any:
    """Returns the module of a package that handles a kind: `tasks.slide`, `view.slide.picture`.

    It is imported at the first call.
    """
    return importlib.import_module(".".join(("", room, kind, *inside)), __package__)


def plan_type(kind: str) -> Any:
    """Returns the type of a kind's plans: slide.Plan, ..."""
    return importlib.import_module(f".{kind}", __package__).Plan


def missing_motion(plan: Any) -> str:
    """Returns the first part of a plan that has no rows; an empty text if all have some."""
    for stage in getattr(plan, "stages", [plan]):
        if not stage.segments:
            return f"segments: []: the {stage.kind} plan has none"
        for segment in stage.segments:
            if not len(segment):
                return f"segment '{segment.name}' of the {stage.kind} plan has no rows"
    return ""
