# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `graspless bench`. Imports what runs only when it runs."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._commands import FOUND, INTERRUPTED, NOT_FOUND
from .physics_cli import add_parser as _add_physics

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
FINGERTIP_GRIDS = ("paper", "weak", "scaling", "fingers", "se2", "faces")
CLASP_GRIDS = ("paper", "chair", "tolerance", "grasp_rrt", "loops")


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
    _add_fingertip(planners)
    _add_clasp(planners)
    _add_physics(planners, _positive)


def _add_fingertip(planners: Any) -> None:
    parser = planners.add_parser(
        "fingertip",
        help="Maeda and Arai 2005",
        description="Plans the paper's four cases and its cork cuboid, or what lies beyond them, "
        "and checks every plan. The least time of some runs counts: wall clock around one call. "
        "Exit 1 when a plan fails its check, has another cost than is known, or engines differ.",
    )
    parser.add_argument("--grid", choices=FINGERTIP_GRIDS, default="paper", help="(%(default)s)")
    parser.add_argument(
        "--engine",
        choices=["fast", "paper", "dijkstra"],
        help="of the search (paper grid: all three; other grids: fast)",
    )
    parser.add_argument(
        "--runs",
        type=_positive(int),
        metavar="N",
        help="of each trial (until a second is spent, at most 5)",
    )
    parser.add_argument(
        "--time",
        type=_positive(float),
        metavar="S",
        help="limit of each query [s] (fast 60, paper 300, dijkstra 900)",
    )
    parser.add_argument("--json", action="store_true", help="print the result as JSON")
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="write results, pictures and fingertip.md there"
    )
    parser.set_defaults(run=_fingertip)


def _add_clasp(planners: Any) -> None:
    parser = planners.add_parser(
        "clasp",
        help="Stork, Pokorny and Kragic 2013",
        description="Clasps five objects with four hands in three poses, or what the paper tries "
        "beside that, and checks every plan. Exit 1 when a plan fails its check.",
    )
    parser.add_argument("--grid", choices=CLASP_GRIDS, default="paper", help="(%(default)s)")
    parser.add_argument(
        "--seeds", type=_positive(int), default=1, metavar="N", help="runs of a task (%(default)s)"
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="S", help="of the first run (%(default)s)"
    )
    parser.add_argument(
        "--time", type=_positive(float), metavar="S", help="limit of each query [s] (10)"
    )
    parser.add_argument("--json", action="store_true", help="print the result as JSON")
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="write results, pictures and clasp.md there"
    )
    parser.set_defaults(run=_clasp)


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


def _fingertip(options: argparse.Namespace) -> int:
    from . import fingertip_report, fingertip_run, report
    from .bar import Bar
    from .fingertip_grid import GRIDS

    if options.out is not None:
        report.check_writable(options.out)
    make, engines = GRIDS[options.grid]
    trials = list(make([options.engine] if options.engine else engines))
    load = os.getloadavg()
    bar = Bar(f"bench fingertip, {options.grid}", len(trials))
    result = fingertip_run.run(trials, options.runs, options.time, bar.tell)
    bar.close()
    table = fingertip_report.as_result(options.grid, result, load)
    if options.out is not None and result.is_complete:
        fingertip_report.write(table, result, options.out)
    print(json.dumps(table) if options.json else fingertip_report.as_text(table))
    if not result.is_complete:
        print("interrupted: the results are partial, and not written", file=sys.stderr)
        return INTERRUPTED
    return NOT_FOUND if table["complaints"] else FOUND


def _clasp(options: argparse.Namespace) -> int:
    from . import clasp_bench, clasp_report, report
    from .bar import Bar

    if options.out is not None:
        report.check_writable(options.out)
    load = os.getloadavg()
    bar = Bar(f"bench clasp, {options.grid}", clasp_bench.count(options.grid, options.seeds))
    run = clasp_bench.run(options.grid, options.seeds, options.seed, options.time, bar.tell)
    bar.close()
    table = clasp_report.as_result(run, load)
    if options.out is not None and run.is_complete:
        clasp_report.write(table, options.out)
    print(json.dumps(table) if options.json else clasp_report.as_text(table))
    if not run.is_complete:
        print("interrupted: the results are partial, and not written", file=sys.stderr)
        return INTERRUPTED
    return NOT_FOUND if table["complaints"] else FOUND


def _trials(grid: str, runs: int, seed: int, search: str | None) -> list[Trial]:
    from . import grid as grids

    if grid == "paper":
        return list(grids.paper(runs, seed, search or "fast"))
    if grid == "baselines":
        return list(grids.baselines(runs, seed))
    searches = [search] if search else ["fast", "paper"]
    make = grids.reconfiguration if grid == "reconfiguration" else grids.roots
    return list(make(runs, seed, searches))
