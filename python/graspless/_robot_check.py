# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless robot check`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

from ._commands import FOUND, NOT_FOUND
from ._robot_inspect import add_robot, read_robot
from .errors import TaskError

if TYPE_CHECKING:
    import argparse

EXAMPLE = "example: graspless robot check my_arm.urdf"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `robot check`."""
    parser.description = (
        "Tell what is wrong with a robot's SRDF and .hand.yaml: frames that are not on the "
        "fingers' surface, axes that point elsewhere, states that touch or do not close. The exit "
        "code is 1 if something is."
    )
    parser.epilog = EXAMPLE
    add_robot(parser)
    parser.add_argument(
        "--hand", metavar="FILE", help="the hand's file (default: the .hand.yaml beside the URDF)"
    )
    parser.add_argument("--json", action="store_true", help="print the faults as JSON")
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    from .inspection.check import faults
    from .tasks.robots import stem
    from .tasks.slide.build import build_hand
    from .tasks.slide.model import Hand
    from .tasks.source import read_yaml

    robot, path = read_robot(options, "robot check")
    beside = path and path.with_name(f"{stem(path)}.hand.yaml")
    file = Path(options.hand) if options.hand else beside
    if file is None or not file.is_file():
        raise TaskError(f"robot check: {file}: no such file; graspless robot inspect writes one")
    source = read_yaml(file)
    hand = build_hand(source.validate(Hand), robot, source)
    found = [f"{file}: {fault}" for fault in faults(robot, hand)]
    if options.json:
        print(json.dumps({"holds": not found, "faults": found}))
    else:
        print("\n".join(found) or f"{file}: nothing is wrong")
    return NOT_FOUND if found else FOUND
