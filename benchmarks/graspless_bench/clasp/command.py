# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench clasp`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ..arguments import add_output, finish, positive
from . import GRIDS

if TYPE_CHECKING:
    import argparse


def add_parser(experiments: Any) -> None:
    """Adds `clasp` to the experiments."""
    parser = experiments.add_parser(
        "clasp",
        help="Stork, Pokorny and Kragic 2013",
        description="Clasps five objects with four hands in three poses, or what the paper tries "
        "beside that, and checks every plan. Exit 1 when a plan fails its check.",
    )
    parser.add_argument("--grid", choices=GRIDS, default="paper", help="(%(default)s)")
    parser.add_argument(
        "--seeds", type=positive(int), default=1, metavar="N", help="runs of a task (%(default)s)"
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="S", help="of the first run (%(default)s)"
    )
    parser.add_argument(
        "--time",
        type=positive(float),
        metavar="S",
        help="limit of each query [s] (10; small: none, but 1200 cycles)",
    )
    add_output(parser, _run, "write results, pictures and clasp.md there")


def _run(options: argparse.Namespace) -> int:
    from ..bar import Bar
    from . import report
    from .run import count, run

    load = os.getloadavg()
    with Bar(f"bench clasp, {options.grid}", count(options.grid, options.seeds)) as bar:
        result = run(options.grid, options.seeds, options.seed, options.time, bar.tell)
    return finish(options, report.as_result(result, load), report)
