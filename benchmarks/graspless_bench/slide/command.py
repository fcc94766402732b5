# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench slide`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ..arguments import add_output, finish, positive

if TYPE_CHECKING:
    import argparse

    from .grid import Trial

# Runs (of a method, range or N*; in the paper grid of the frozen section), and time limit [s]: the
# paper's numbers of runs; its limit was 60 s. The frozen grid alone is for the slowest of many.
DEFAULTS = {
    "paper": (1000, 10.0),
    "frozen": (100_000, 1.0),
    "reconfiguration": (500, 10.0),
    "baselines": (200, 1.0),
    "roots": (100, 2.0),
    "ur5e": (50, 1.0),
}


def add_parser(experiments: Any) -> None:
    """Adds `slide` to the experiments."""
    parser = experiments.add_parser(
        "slide",
        help="Hang, Morgan and Dollar 2019",
        description="Plans on a frozen grid of problems, checks every plan, and reports the time "
        "taken. Times are wall clock around one call; a query that is not solved, or whose plan "
        "fails its check, counts as infinite (null in JSON). Exit 1 when a plan of ours failed.",
    )
    parser.add_argument("--grid", choices=list(DEFAULTS), default="paper", help="(%(default)s)")
    defaults = ", ".join(f"{grid} {runs}" for grid, (runs, _) in DEFAULTS.items())
    parser.add_argument(
        "--runs", type=positive(int), metavar="N", help=f"of each curve ({defaults})"
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="S", help="of the poses (%(default)s)"
    )
    limits = ", ".join(f"{grid} {limit:g}" for grid, (_, limit) in DEFAULTS.items())
    parser.add_argument(
        "--time", type=positive(float), metavar="S", help=f"limit of each query [s] ({limits})"
    )
    parser.add_argument(
        "--search",
        choices=["fast", "paper"],
        help="paper: Algorithm 1 as written (paper and frozen grid: fast; other grids: both)",
    )
    add_output(parser, _run, "write results, pictures and slide.md there")


def _run(options: argparse.Namespace) -> int:
    from ..bar import Bar
    from . import report, run, summary
    from .grid import FOREIGN

    runs, limit = DEFAULTS[options.grid]
    runs, limit = options.runs or runs, options.time or limit
    trials = _trials(options.grid, runs, options.seed, options.search)
    load = os.getloadavg()
    with Bar(f"bench slide, {options.grid}", len(trials)) as bar:
        result = run.run(trials, limit, bar.tell)
    table = summary.as_result(options.grid, result, options.seed, limit, load)
    table["search"] = options.search or ("fast" if options.grid in ("paper", "frozen") else "both")
    ours = [fault for fault in table["failed_checks"] if fault["method"] not in FOREIGN]
    return finish(options, table, report, complaints=ours, hidden="curves")


def _trials(grid: str, runs: int, seed: int, search: str | None) -> list[Trial]:
    from . import grid as grids

    if grid == "paper":
        return list(grids.paper(runs, seed, search or "fast"))
    if grid == "frozen":
        return list(grids.frozen(runs, seed, search or "fast"))
    if grid == "baselines":
        return list(grids.baselines(runs, seed))
    if grid == "ur5e":
        return list(grids.arms(runs, seed))
    searches = [search] if search else ["fast", "paper"]
    make = grids.reconfiguration if grid == "reconfiguration" else grids.roots
    return list(make(runs, seed, searches))
