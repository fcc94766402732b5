# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless robot check`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

from .._commands import FOUND, NOT_FOUND
from ..errors import TaskError
from .robot_inspect import add_robot, faults_of, read_robot

if TYPE_CHECKING:
    import argparse

    from ..robot import Robot

EXAMPLE = "example: graspless robot check my_arm.urdf"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `robot check`."""
    parser.description = (
        "Check a robot's SRDF, .hand.yaml and .clasp.yaml against its shapes. Reports frames that "
        "are not on the fingers' surface, axes that point elsewhere, corners outside the links, "
        "and states that touch or do not close. The exit code is 1 if there is a fault."
    )
    parser.epilog = EXAMPLE
    add_robot(parser)
    parser.add_argument(
        "--hand", metavar="FILE", help="the hand's file (default: those beside the URDF)"
    )
    parser.add_argument("--json", action="store_true", help="print the faults as JSON")
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    from ..tasks.robots import stem

    robot, path = read_robot(options, "robot check")
    given = Path(options.hand) if options.hand else None
    beside = [path.with_name(f"{stem(path)}.{end}.yaml") for end in ("hand", "clasp")]
    files = [file for file in beside if file.is_file()] if given is None else [given]
    if not files:
        raise TaskError(
            f"robot check: neither {beside[0]} nor {beside[1]} exists; {_instead(robot)}"
        )
    found = [f"{file}: {fault}" for file in files for fault in faults_of(robot, file)]
    if options.json:
        print(json.dumps({"holds": not found, "faults": found}))
    else:
        shown = ", ".join(str(file) for file in files)
        print("\n".join(found) or f"{shown}: nothing is wrong")
    return NOT_FOUND if found else FOUND


def _instead(robot: Robot) -> str:
    """Returns how a robot gets the file of a hand, or why it has no hand."""
    from ..inspection.palm import find_palm
    from ..inspection.tree import Tree

    try:
        find_palm(Tree(robot))
    except ValueError as error:
        return str(error)
    return "graspless robot inspect writes them"
