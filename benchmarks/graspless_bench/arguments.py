# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments and exits that the experiments share."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from graspless._commands import FOUND, INTERRUPTED, NOT_FOUND
from graspless.errors import TaskError

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Sequence

    from .machine import Row

Item = TypeVar("Item")


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


def chosen(option: str, names: list[str] | None, known: dict[str, Item]) -> dict[str, Item]:
    """Returns the items that the user named, or all. Raises TaskError for an unknown name."""
    for name in names or []:
        if name not in known:
            raise TaskError(f"--{option}: {name}: no such {option} (one of: {', '.join(known)})")
    return {name: known[name] for name in names} if names else known


def finish(
    options: argparse.Namespace,
    result: Row,
    report: Any,
    *,
    complaints: Sequence[Any] | None = None,
    hidden: str = "",
    partial: str = ", and not written",
) -> int:
    """Writes the result of an experiment, prints it, and returns the exit code.

    Parameters
    ----------
    options : argparse.Namespace
        With `out` and `json`.
    result : dict
        If its field `complete` is False, it is partial, and not written.
    report : module
        With `write` and `as_text`.
    complaints : list, optional
        What fails; default: the field `complaints`.
    hidden : str
        Field that --json does not print.
    partial : str
        End of the message about a partial result.
    """
    complaints = result["complaints"] if complaints is None else complaints
    is_complete = result.get("complete", True)
    if options.out is not None and is_complete:
        report.write(result, options.out)
    shown = {name: value for name, value in result.items() if name != hidden}
    print(json.dumps(shown) if options.json else report.as_text(result))
    if not is_complete:
        print(f"interrupted: the results are partial{partial}", file=sys.stderr)
        return INTERRUPTED
    return NOT_FOUND if complaints else FOUND
