# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Commands `graspless bench all` and `graspless bench profile`."""

from __future__ import annotations

import contextlib
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..arguments import add_output, finish

if TYPE_CHECKING:
    import argparse


def add_parsers(experiments: Any) -> None:
    """Adds `all` and `profile` to the experiments."""
    times = experiments.add_parser(
        "all",
        help="times of all planners, beside those of another build",
        description="Asks the queries whose times matter. With --against, two processes answer "
        "them in turn, one with each build, never at the same time. Times are those of the "
        "processor, or wall clock for threads; the least of up to five runs counts for each "
        "problem. The ratio is that of neighbouring runs: median and quartiles. Exit 1 when a "
        "query cannot be answered, or has fewer results than before.",
    )
    profile = experiments.add_parser(
        "profile",
        help="instructions of each planner, by the room of the library",
        description="Counts the instructions inside the planners by valgrind's callgrind, for up "
        "to 20 problems each. Inlined code counts where it is inlined.",
    )
    for parser, run in ((times, _times), (profile, _profile)):
        parser.add_argument(
            "--against",
            type=Path,
            metavar="BUILD",
            help="a wheel of graspless, or a folder that contains the package",
        )
        parser.add_argument("--query", metavar="NAME", help="only those whose names begin so (all)")
        add_output(parser, run, "write the result and speed.md there")


def _times(options: argparse.Namespace) -> int:
    from ..bar import Bar
    from . import builds, measure, report
    from .queries import chosen

    load, queries = os.getloadavg(), chosen(options.query)
    with contextlib.ExitStack() as stack, Bar("bench all", len(queries)) as bar:
        folders = _folders(options, stack)
        asked = {n: stack.enter_context(builds.Build(at)) for n, at in folders.items()}
        rows, is_complete = measure.run(queries, asked, bar.tell)
    result = report.as_result("all", rows, is_complete, load, _name(options.against))
    return finish(options, result, report)


def _profile(options: argparse.Namespace) -> int:
    from ..bar import Bar
    from . import profile, report
    from .queries import chosen

    profile.needs_valgrind()
    load, queries = os.getloadavg(), [query for query in chosen(options.query) if query.room]
    with contextlib.ExitStack() as stack, Bar("bench profile", len(queries)) as bar:
        rows, is_complete = profile.run(queries, _folders(options, stack), bar.tell)
    result = report.as_result("profile", rows, is_complete, load, _name(options.against))
    return finish(options, result, report)


def _folders(options: argparse.Namespace, stack: contextlib.ExitStack) -> dict[str, Path | None]:
    """Returns the folders of the builds by name; None stands for the installed one."""
    from .builds import unpacked

    if options.against is None:
        return {"new": None}
    folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
    return {"old": unpacked(options.against, folder), "new": None}


def _name(against: Path | None) -> str:
    return "" if against is None else against.resolve().name
