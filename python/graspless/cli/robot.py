# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless robot`: a group of commands about robots, each in a module of its own."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import argparse

# name: line of help, and module with add_arguments(parser)
COMMANDS = {
    "inspect": ("propose arm, hand, frames and states from a URDF", ".robot_inspect"),
    "check": ("check a robot's SRDF and hand description", ".robot_check"),
    "join": ("join an arm and a gripper into one URDF", ".robot_join"),
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the commands of the group."""
    parser.description = "Prepare a robot for planning."
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    for name, (about, module) in COMMANDS.items():
        subparser = commands.add_parser(name, help=about)
        importlib.import_module(module, __package__).add_arguments(subparser)
