# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by all commands: exit codes, common flags, and reading stdin."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

from .errors import TaskError

if TYPE_CHECKING:
    import argparse

ends_with_command = False  # True in a process that runs one command and ends

FOUND, NOT_FOUND, BAD_INPUT, INTERRUPTED, CLOSED_PIPE = 0, 1, 2, 130, 141


def exit_codes(
    failure: str = "no plan was found, or a plan fails its check",
    success: str = "a plan was found, and it passes its check",
    bad_input: str = "bad input, or output that cannot be written",
) -> str:
    """Returns what the exit codes of a command mean, for its help."""
    return f"""exit codes:
  0    success: {success}
  1    {failure}
  2    {bad_input}
  130  interrupted
  141  the reader of the output closed the pipe
  143  terminated (SIGTERM)"""


def add_trust(parser: argparse.ArgumentParser) -> None:
    """Adds the flag --trust, for commands that read tasks."""
    parser.add_argument(
        "--trust",
        action="store_true",
        help="let xacro files read any file and run code (docs/security.md)",
    )


def add_seconds(parser: argparse.ArgumentParser, about: str) -> None:
    """Adds the flag --seconds, named as in task files and in Python; --time is the same."""
    parser.add_argument("--seconds", "--time", type=float, metavar="S", help=about)


def add_packages(parser: argparse.ArgumentParser) -> None:
    """Adds the flag --package, for commands that read a robot."""
    parser.add_argument(
        "--package",
        metavar="NAME=DIR",
        action="append",
        default=[],
        help="folder of package://NAME/; can be given several times",
    )


def given_packages(options: argparse.Namespace) -> dict[str, str]:
    """Returns the folders of --package by name. Raises TaskError unless each is NAME=DIR."""
    packages = {}
    for text in options.package:
        name, separator, folder = text.partition("=")
        if not (name and separator and folder):
            raise TaskError(f"--package: {text}: should be NAME=DIR")
        packages[name] = folder
    return packages


_INPUTS = ("task", "plan", "scene", "file", "files", "robot", "arm", "gripper", "camera")
_OUTPUTS = {"output": "--output", "png": "--png", "html": "--html"}


def require_apart(options: argparse.Namespace) -> None:
    """Raises TaskError if an output of a command would replace one of its inputs, or another one.

    Devices and stdout may be named twice.
    """
    taken: dict[str, str] = {}
    for name in _INPUTS:
        given = getattr(options, name, None) or []
        for path in [given] if isinstance(given, str) else given:
            if os.path.isfile(path):  # not the name of a robot
                taken[os.path.realpath(path)] = "an input of this command"
    for name, flag in _OUTPUTS.items():
        path = getattr(options, name, None)
        if path is None or path == "-" or (os.path.exists(path) and not os.path.isfile(path)):
            continue
        place = os.path.realpath(path)
        if place in taken:
            raise TaskError(f"{flag}: {path}: would replace {taken[place]}")
        taken[place] = f"the file of {flag}"


def read_stdin() -> str:
    """Returns all of stdin; raises TaskError unless it is text."""
    try:
        return sys.stdin.buffer.read().decode("utf-8-sig")
    except (OSError, AttributeError):  # closed
        raise TaskError("stdin: cannot be read") from None
    except UnicodeDecodeError:
        raise TaskError("stdin: not a text file in UTF-8") from None
