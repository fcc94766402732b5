# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planning manipulation of things that a robot cannot simply grasp.

>>> import graspless
>>> task = graspless.load_task("examples/01_slide_card.yaml")  # doctest: +SKIP
>>> plan = graspless.plan(task, seed=1)  # doctest: +SKIP
>>> assert plan and not graspless.check(plan)  # doctest: +SKIP
>>> plan.save("plan.json")  # doctest: +SKIP

`graspless.slide`, `graspless.pinch`, `graspless.fingertip`, `graspless.clasp` and
`graspless.carry` have the planners themselves, for problems that are made in Python.
"""

from __future__ import annotations

import importlib

TYPE_CHECKING = False  # that of `typing` takes time, in which Ctrl-C would be a traceback
if TYPE_CHECKING:
    from typing import Any

    from . import (
        carry,
        chain,
        clasp,
        collision,
        fingertip,
        following,
        frames,
        geometry,
        mechanics,
        perception,
        pinch,
        planning,
        robot,
        scene,
        slide,
        view,
    )
    from ._api import certify, check, plan
    from ._load import load_task
    from ._plan import Plan
    from .batches import batch
    from .errors import GrasplessWarning, TaskError
    from .formats import export
    from .perception import perceive
    from .picking import pick
    from .plan_files import load_plan
    from .simulation import simulate
    from .tasks import Task
    from .timing import Trajectory, time

__version__ = "0.1.0"

__all__ = [
    "GrasplessWarning",
    "Plan",
    "Task",
    "TaskError",
    "Trajectory",
    "__version__",
    "batch",
    "carry",
    "chain",
    "certify",
    "check",
    "clasp",
    "collision",
    "export",
    "fingertip",
    "following",
    "frames",
    "geometry",
    "load_plan",
    "load_task",
    "mechanics",
    "perceive",
    "perception",
    "pick",
    "pinch",
    "plan",
    "planning",
    "robot",
    "scene",
    "simulate",
    "slide",
    "time",
    "view",
]

_HOMES = {
    "batch": "batches",
    "Plan": "_any_plan",
    "certify": "_api",
    "check": "_api",
    "export": "formats",
    "load_plan": "plan_files",
    "perceive": "perception",
    "pick": "picking",
    "plan": "_api",
    "simulate": "simulation",
    "Trajectory": "timing",
    "time": "timing",
    "Task": "tasks",
    "load_task": "_load",
    "GrasplessWarning": "errors",
    "TaskError": "errors",
}


def __getattr__(name: str) -> Any:
    """Imports on first use: `import graspless` alone takes a millisecond."""
    if name not in __all__:
        raise AttributeError(f"module 'graspless' has no attribute '{name}'")
    if name in _HOMES:
        return getattr(importlib.import_module(f".{_HOMES[name]}", __name__), name)
    return importlib.import_module(f".{name}", __name__)


def __dir__() -> list[str]:
    return __all__
