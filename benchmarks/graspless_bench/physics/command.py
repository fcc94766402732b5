# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench physics`."""

from __future__ import annotations

import json
import os
import sys
from typing import TYPE_CHECKING, Any

from graspless._commands import FOUND, INTERRUPTED, NOT_FOUND

from ..arguments import add_output, positive

if TYPE_CHECKING:
    import argparse


def add_parser(experiments: Any) -> None:
    """Adds `physics` to the experiments."""
    parser = experiments.add_parser(
        "physics",
        help="plans of all kinds in an independent physics engine",
        description="Plans, executes the plans in MuJoCo and judges the object. Rows are kept as "
        "they come: after Ctrl-C the same command goes on. Exit 1 when a plan fails its check.",
    )
    parser.add_argument("--kind", choices=["slide", "fingertip", "clasp"], required=True)
    parser.add_argument(
        "--runs",
        type=positive(int),
        metavar="N",
        help="plans (slide 200, fingertip 54, clasp 60; with --mutants 5)",
    )
    parser.add_argument(
        "--trials",
        type=positive(int),
        default=11,
        metavar="T",
        help="of each: one nominal, the others varied (%(default)s)",
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="S", help="of problems and trials (%(default)s)"
    )
    parser.add_argument(
        "--jobs", type=positive(int), default=1, metavar="J", help="processes (%(default)s)"
    )
    parser.add_argument(
        "--ablation", action="store_true", help="slide: the paper's formula on the commanded tip"
    )
    parser.add_argument(
        "--disturb",
        action="store_true",
        help="fingertip: instead of trials, the smallest wrench that breaks the weakest row (slow)",
    )
    parser.add_argument(
        "--withstands",
        action="store_true",
        help="fingertip: instead of trials, the smallest wrenches that break rows of plans for "
        "other objects, against the disturbance that the rows withstand",
    )
    parser.add_argument(
        "--closed-loop",
        action="store_true",
        help="slide: instead of trials, each condition in open and in closed loop",
    )
    parser.add_argument(
        "--prove",
        type=positive(int),
        metavar="N",
        help="instead of trials, plan until a plan holds as planned and in N varied trials",
    )
    parser.add_argument(
        "--mutants",
        action="store_true",
        help="instead of trials, break every plan on purpose, and see what check and simulate find",
    )
    parser.add_argument(
        "--locked",
        action="store_true",
        help="clasp: instead of trials, certificates against hands with locked motors",
    )
    add_output(parser, _run, "write physics_KIND.json and physics.md there")


def _run(options: argparse.Namespace) -> int:
    from graspless.batches.cli import bar
    from graspless.simulation import simulation_kind

    from . import report
    from .mutants import PLANS
    from .run import BREAK_RUNS, RUNS, Grid, run

    of_part = PLANS if options.mutants else BREAK_RUNS if options.withstands else None
    runs = options.runs or of_part or RUNS[options.kind]
    alone = options.disturb or options.closed_loop or options.mutants or options.locked
    alone = alone or options.withstands
    trials = 1 if alone else options.trials
    trials = trials if options.prove is None else 1 + options.prove
    proves = options.prove is not None
    others = (options.mutants, options.locked, options.withstands)
    flags = options.ablation, options.disturb, options.closed_loop, proves, *others
    grid = Grid(options.kind, runs, trials, options.seed, *flags)
    grid.check()
    simulation_kind(grid.kind)  # there is one
    log = None
    if options.out is not None:
        options.out.mkdir(parents=True, exist_ok=True)
        log = options.out / f"physics_{grid.part}.rows"
    load = os.getloadavg()
    with bar(f"bench physics, {grid.part}") as tell:
        found = run(grid, options.jobs, log, tell)
    result = report.as_result(found, load)
    if log is not None and found.is_complete:
        report.write(result, options.out)
        log.unlink(missing_ok=True)
    print(json.dumps(result) if options.json else report.as_text(result))
    if not found.is_complete:
        kept = "" if log is None else f"; the same command goes on from {log}"
        print(f"interrupted: the results are partial{kept}", file=sys.stderr)
        return INTERRUPTED
    return NOT_FOUND if result["complaints"] else FOUND
