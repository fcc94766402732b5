# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench fingertip`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ..arguments import add_output, finish, positive

if TYPE_CHECKING:
    import argparse

GRIDS = ("paper", "weak", "scaling", "fingers", "se2", "faces", "arm")


def add_parser(experiments: Any) -> None:
    """Adds `fingertip` to the experiments."""
    parser = experiments.add_parser(
        "fingertip",
        help="Maeda and Arai 2005",
        description="Plans the paper's four cases and its cork cuboid, or what lies beyond them, "
        "and checks every plan. The least time of some runs counts: wall clock around one call. "
        "Exit 1 when a plan fails its check, has another cost than is known, or engines differ.",
    )
    parser.add_argument("--grid", choices=GRIDS, default="paper", help="(%(default)s)")
    parser.add_argument(
        "--engine",
        choices=["fast", "paper", "dijkstra"],
        help="of the search (paper grid: all three; other grids: fast)",
    )
    parser.add_argument(
        "--runs",
        type=positive(int),
        metavar="N",
        help="of each trial (until a second is spent, at most 5)",
    )
    parser.add_argument(
        "--time",
        type=positive(float),
        metavar="S",
        help="limit of each query [s] (fast 60, paper 300, dijkstra 900)",
    )
    add_output(parser, _run, "write results, pictures and fingertip.md there")


def _run(options: argparse.Namespace) -> int:
    from ..bar import Bar
    from . import report, run
    from .grid import GRIDS as MAKERS

    make, engines = MAKERS[options.grid]
    trials = list(make([options.engine] if options.engine else engines))
    load = os.getloadavg()
    with Bar(f"bench fingertip, {options.grid}", len(trials)) as bar:
        result = run.run(trials, options.runs, options.time, bar.tell)
    code = finish(options, report.as_result(options.grid, result, load), report)
    if options.out is not None and options.grid == "paper" and result.is_complete:
        report.draw(result, options.out)
    return code
