# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `graspless bench`. Imports what runs only when it runs."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import argparse

    from .grid import Trial

# Runs (of a method, range or N*; in the paper grid of the frozen section), and time limit [s]: the
# paper's numbers of runs; its limit was 60 s.
DEFAULTS = {
    "paper": (1000, 10.0),
    "reconfiguration": (500, 10.0),
    "baselines": (200, 1.0),
    "roots": (100, 2.0),
}
FOUND, NOT_FOUND, INTERRUPTED = 0, 1, 130


def add_parser(commands: Any) -> None:
    """Adds `bench` to the commands of the command line."""
    parser = commands.add_parser("bench", help="repeat the papers' experiments")
    planners = parser.add_subparsers(metavar="PLANNER", required=True)
    slide = planners.add_parser(
        "slide",
        help="Hang, Morgan and Dollar 2019",
        description="Plans on a frozen grid of problems, checks every plan, and tells how long it "
        "took. Times are wall clock around one call; a query that is not solved, or whose plan "
        "fails its check, counts as infinite (null in JSON). Exit 1 when a plan of ours failed.",
    )
    slide.add_argument("--grid", choices=list(DEFAULTS), default="paper", help="(%(default)s)")
    defaults = ", ".join(f"{grid} {runs}" for grid, (runs, _) in DEFAULTS.items())
    slide.add_argument(
        "--runs", type=_positive(int), metavar="N", help=f"of each curve ({defaults})"
    )
    slide.add_argument(
        "--seed", type=int, default=1, metavar="S", help="of the poses (%(default)s)"
    )
    limits = ", ".join(f"{grid} {limit:g}" for grid, (_, limit) in DEFAULTS.items())
    slide.add_argument(
        "--time", type=_positive(float), metavar="S", help=f"limit of each query [s] ({limits})"
    )
    slide.add_argument(
        "--search",
        choices=["fast", "paper"],
        help="paper: Algorithm 1 as written (paper grid: fast; other grids: both)",
    )
    slide.add_argument("--json", action="store_true", help="print the result as JSON")
    slide.add_argument(
        "--out", type=Path, metavar="DIR", help="write results, pictures and slide.md there"
    )
    slide.set_defaults(run=_slide)


def _positive(kind: type) -> Any:
    def number(text: str) -> Any:
        value = kind(text)
        if not value > 0:
            raise ValueError
        return value

    number.__name__ = f"positive {kind.__name__}"
    return number


def _slide(options: argparse.Namespace) -> int:
    from . import report, run, summary
    from .bar import Bar
    from .grid import OMPL_PEERS

    if options.out is not None:
        report.check_writable(options.out)
    runs, limit = DEFAULTS[options.grid]
    runs, limit = options.runs or runs, options.time or limit
    trials = _trials(options.grid, runs, options.seed, options.search)
    load = os.getloadavg()
    bar = Bar(f"bench slide, {options.grid}", len(trials))
    result = run.run(trials, limit, lambda done, _: bar.tell(done, trials[done - 1].label))
    bar.close()
    table = summary.as_result(options.grid, result, options.seed, limit, load)
    table["search"] = options.search or ("fast" if options.grid == "paper" else "both")
    if options.out is not None and result.is_complete:
        report.write(table, options.out)
    if options.json:
        print(json.dumps({key: value for key, value in table.items() if key != "curves"}))
    else:
        print(report.as_text(table))
    if not result.is_complete:
        print("interrupted: the results are partial, and not written", file=sys.stderr)
        return INTERRUPTED
    ours = [fault for fault in table["failed_checks"] if fault["method"] not in OMPL_PEERS]
    return NOT_FOUND if ours else FOUND


def _trials(grid: str, runs: int, seed: int, search: str | None) -> list[Trial]:
    from . import grid as grids

    if grid == "paper":
        return list(grids.paper(runs, seed, search or "fast"))
    if grid == "baselines":
        return list(grids.baselines(runs, seed))
    searches = [search] if search else ["fast", "paper"]
    make = grids.reconfiguration if grid == "reconfiguration" else grids.roots
    return list(make(runs, seed, searches))
