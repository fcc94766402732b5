# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flags of commands whose plans are simulated."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..errors import TaskError

if TYPE_CHECKING:
    import argparse

    from .._plan import Plan


def add_prove(parser: argparse.ArgumentParser) -> None:
    """Adds the flag --prove."""
    parser.add_argument(
        "--prove",
        type=int,
        metavar="N",
        help="simulate each plan as planned and in N varied trials, and search with other seeds "
        "until all trials hold (docs/howto/prove.md); exit code 1 if they do not",
    )


def add_jobs(parser: argparse.ArgumentParser) -> None:
    """Adds the flag --jobs of a command that plans one task."""
    parser.add_argument(
        "--jobs",
        type=int,
        default=1,
        metavar="J",
        help="number of processes for the trials of --prove (default: %(default)s)",
    )


def searched(task: Any, began: float, options: argparse.Namespace) -> Plan:
    """Returns the plan of a task that was read since `began`, with the trials of --prove."""
    from .. import _api, progress
    from . import limit_of, prove

    plan: Plan
    if options.prove is None:
        if options.jobs != 1:
            raise TaskError(f"--jobs: {options.jobs}: needs --prove, whose trials it distributes")
        with progress.waiting(f"planning, at most {task.budget.seconds:g} s"):
            plan = (_api.plan_certified if options.certify else _api.plan_since)(task, began)
        return plan
    if options.certify:
        raise TaskError("--certify: cannot be combined with --prove: each searches by its own rule")
    limit = limit_of(options.seconds)
    with progress.waiting(f"planning and simulating, at most {limit:g} s"):
        plan = prove(task, options.prove, jobs=options.jobs, seconds=options.seconds, began=began)
    return plan
