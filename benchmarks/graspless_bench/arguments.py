# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments and exits that the experiments share."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from graspless._commands import FOUND, INTERRUPTED, NOT_FOUND
from graspless.errors import TaskError

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable

    from .machine import Row


def positive(kind: type) -> Any:
    """Type of an argument for argparse: a number of this kind above 0."""

    def number(text: str) -> Any:
        value = kind(text)
        if not value > 0:
            raise ValueError
        return value

    number.__name__ = f"positive {kind.__name__}"
    return number


def add_output(
    parser: argparse.ArgumentParser, run: Callable[[argparse.Namespace], int], about: str
) -> None:
    """Adds --json, --out with its line of help, and `run`, which begins if --out can be written."""

    def checked(options: argparse.Namespace) -> int:
        if options.out is not None:
            check_writable(options.out)
        return run(options)

    parser.add_argument("--json", action="store_true", help="print the result as JSON")
    parser.add_argument("--out", type=Path, metavar="DIR", help=about)
    parser.set_defaults(run=checked)


def check_writable(directory: Path) -> None:
    """Raises TaskError where results could not be written: before hours of work, not after."""
    parent = next(p for p in (directory, *directory.absolute().parents) if p.exists())
    if not parent.is_dir() or not os.access(parent, os.W_OK):
        raise TaskError(f"--out: {directory}: cannot be written")


def say_partial() -> int:
    """Prints that an interrupted run is not written; returns the exit code."""
    print("interrupted: the results are partial, and not written", file=sys.stderr)
    return INTERRUPTED


def finish(options: argparse.Namespace, result: Row, report: Any) -> int:
    """Writes the result of an experiment, prints it, and returns the exit code.

    Parameters
    ----------
    options : argparse.Namespace
        With `out` and `json`.
    result : dict
        With `complete` and `complaints`. A partial result is not written.
    report : module
        With `write` and `as_text`.
    """
    if options.out is not None and result["complete"]:
        report.write(result, options.out)
    print(json.dumps(result) if options.json else report.as_text(result))
    if not result["complete"]:
        return say_partial()
    return NOT_FOUND if result["complaints"] else FOUND
