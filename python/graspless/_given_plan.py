# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plan that a command is given: from a file or stdin, as it is or checked."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._commands import read_stdin
from .errors import TaskError

if TYPE_CHECKING:
    import argparse

    from ._plan import Plan


def given_plan(path: str) -> Plan:
    """Returns the plan in a file; - stands for stdin."""
    from . import plan_files

    if path != "-":
        return plan_files.load_plan(path)
    return plan_files.read_plan(read_stdin(), "stdin")


def add_unchecked(parser: argparse.ArgumentParser) -> None:
    """Adds the flag --unchecked, for commands that check their plan first."""
    parser.add_argument(
        "--unchecked",
        action="store_true",
        help="do not check the plan first: accept one that graspless check refuses",
    )


def checked_plan(options: argparse.Namespace) -> Plan:
    """Returns the plan in a file, which may have been edited since it was written.

    A plan without a solution is returned as it is; the caller reports it.

    Raises
    ------
    TaskError
        The plan fails its check, and --unchecked was not given.
    """
    from . import _api, progress

    plan = given_plan(options.plan)
    if not plan or options.unchecked:
        return plan
    with progress.waiting("checking"):
        faults = _api.check(plan)
    if faults:
        name = options.plan if options.plan != "-" else "stdin"
        more = f" and {len(faults) - 1} more" if len(faults) > 1 else ""
        hint = "add --unchecked to continue anyway"
        raise TaskError(f"{name}: does not hold: {faults[0]}{more}; {hint}")
    return plan
