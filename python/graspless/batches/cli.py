# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `graspless batch`. Imports what runs only when it runs."""

from __future__ import annotations

import contextlib
import json
import logging
import shlex
import sys
from typing import TYPE_CHECKING

from .._commands import EXIT_CODES, FOUND, INTERRUPTED, NOT_FOUND

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Iterator

EXAMPLE = """after Ctrl-C the same command goes on

example: graspless batch tasks/ -o plans --jobs 2"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `batch`."""
    import argparse

    parser.description = (
        "Plans many tasks, checks every plan, and writes both as they come: "
        "DIR/NAME.plan.json, a row of each task in DIR/batch.jsonl, and DIR/summary.json. A task "
        "whose plan is there, and that says the same as then, is not planned again."
    )
    parser.epilog = f"{EXIT_CODES}\n\n{EXAMPLE}"
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument(
        "tasks", metavar="TASKS", nargs="+", help="task files, globs, or folders of them"
    )
    parser.add_argument("-o", "--output", metavar="DIR", required=True, help="made where missing")
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--jobs", type=int, default=1, metavar="N", help="processes, a thread each (%(default)s)"
    )
    where.add_argument(
        "--dask", metavar="ADDRESS", help="of a scheduler whose workers do it: tcp://host:8786"
    )
    parser.add_argument("--seed", type=int, metavar="N", help="instead of every task's own")
    parser.add_argument("--time", type=float, metavar="S", help="likewise: stop after so long [s]")
    parser.add_argument("--iterations", type=int, metavar="N", help="likewise: after so many")
    parser.add_argument(
        "--patience",
        type=float,
        default=600,
        metavar="S",
        help="end a task that takes so much longer than its own budget [s] (%(default)s)",
    )
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")
    parser.set_defaults(run=_batch)


def _batch(options: argparse.Namespace) -> int:
    from . import batch

    if options.dask is not None:
        _quiet_dask()
    with bar("planning") as progress:
        summary = batch(
            options.tasks,
            options.output,
            jobs=options.jobs,
            dask=options.dask,
            seed=options.seed,
            seconds=options.time,
            iterations=options.iterations,
            patience=options.patience,
            progress=progress,
        )
    print(json.dumps(summary.as_dict()) if options.json else summary.as_text())
    if not summary.is_complete:
        command = shlex.join(["graspless", *sys.argv[1:]])
        print(f"interrupted; this goes on: {command}", file=sys.stderr)
        return INTERRUPTED
    return FOUND if summary else NOT_FOUND


def _quiet_dask() -> None:
    """What goes wrong is ours to say, in a line; Dask would add tracebacks."""
    with contextlib.suppress(ImportError):
        import distributed  # noqa: F401  which sets the levels of its loggers
    for name in ("distributed", "distributed.client", "tornado.application"):
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)


@contextlib.contextmanager
def bar(what: str) -> Iterator[Callable[[int, int], None] | None]:
    """A progress bar on stderr, only at a terminal and with rich; gives what is called with done
    and total.
    """
    if not sys.stderr.isatty() or not _has_rich():
        yield None
        return
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

    columns = (*Progress.get_default_columns()[:-1], MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as shown:
        task = shown.add_task(what, total=None)
        yield lambda done, total: shown.update(task, completed=done, total=total)


def _has_rich() -> bool:
    try:
        import rich.progress  # noqa: F401
    except ImportError:  # a bar is no reason to end work that needs none
        return False
    return True
