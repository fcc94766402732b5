# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless batch`. The planners are imported when it runs."""

from __future__ import annotations

import contextlib
import json
import logging
import shlex
import sys
from typing import TYPE_CHECKING

from .._commands import FOUND, INTERRUPTED, NOT_FOUND, add_seconds, add_trust, exit_codes

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Iterator

EXAMPLE = """after Ctrl-C, the same command resumes the batch

example: graspless batch tasks/ -o plans --jobs 2"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `batch`."""
    import argparse

    from ..proving.cli import add_prove

    parser.description = (
        "Plan many tasks and check every plan. Results are written as they arrive: plans\n"
        "to DIR/NAME.plan.json, one row per task to DIR/batch.jsonl, and DIR/summary.json\n"
        "at the end. A task that already has a plan and has not changed since is not\n"
        "planned again."
    )
    codes = exit_codes(
        "a plan was not found, or fails its check or, with --prove, a trial;\n"
        "       or a task file is bad",
        "all plans were found, and all pass their checks",
        "the batch cannot run, for instance because there are no tasks, or output\n"
        "       cannot be written",
    )
    parser.epilog = f"{codes}\n\n{EXAMPLE}"
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument(
        "tasks",
        metavar="TASKS",
        nargs="+",
        help="task files, glob patterns, or folders of task files",
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="DIR",
        required=True,
        help="folder to write to; created if missing",
    )
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--jobs",
        type=int,
        default=1,
        metavar="N",
        help="number of worker processes (default: %(default)s)",
    )
    where.add_argument(
        "--dask",
        metavar="ADDRESS",
        help="address of a Dask scheduler whose workers plan: tcp://host:8786",
    )
    parser.add_argument(
        "--seed", type=int, metavar="N", help="seed of the random numbers, overrides every task"
    )
    add_seconds(parser, "time limit [s], overrides every task")
    parser.add_argument(
        "--iterations",
        type=int,
        metavar="N",
        help="maximum number of iterations, overrides every task",
    )
    add_prove(parser)
    parser.add_argument(
        "--patience",
        type=float,
        default=600,
        metavar="S",
        help="time beyond its budget after which a task is stopped [s] (default: %(default)s)",
    )
    add_trust(parser)
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
            seconds=options.seconds,
            iterations=options.iterations,
            prove=options.prove,
            patience=options.patience,
            trust=options.trust,
            progress=progress,
        )
    print(json.dumps(summary.as_dict()) if options.json else summary.as_text())
    if not summary.is_complete:
        command = shlex.join(["graspless", *sys.argv[1:]])
        print(f"interrupted; this command resumes the batch: {command}", file=sys.stderr)
        return INTERRUPTED
    return FOUND if summary else NOT_FOUND


def _quiet_dask() -> None:
    """Silences Dask, whose tracebacks would bury the error message of graspless."""
    with contextlib.suppress(ImportError):
        import distributed  # noqa: F401  which sets the levels of its loggers
    for name in ("distributed", "distributed.client", "tornado.application"):
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)


@contextlib.contextmanager
def bar(what: str) -> Iterator[Callable[[int, int], None] | None]:
    """Shows a progress bar on stderr, if that is a terminal and rich is installed.

    Yields a function of the numbers of finished and of all tasks, or None without a bar.
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
    except ImportError:  # the bar is optional
        return False
    return True
