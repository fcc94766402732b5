# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench physics`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ..arguments import add_output, finish, positive
from .experiments import EXPERIMENTS

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
    group = parser.add_mutually_exclusive_group()
    for name, (*_, about) in EXPERIMENTS.items():
        flag = {"action": "store_const", "dest": "experiment", "const": name, "default": ""}
        how: dict[str, Any] = flag if name != "prove" else {"type": positive(int), "metavar": "N"}
        group.add_argument(f"--{name.replace('_', '-')}", help=about, **how)
    add_output(parser, _run, "write physics_KIND.json and physics.md there")


def _run(options: argparse.Namespace) -> int:
    from graspless.simulation import simulation_kind

    from ..bar import Bar
    from . import report
    from .mutants import PLANS
    from .run import BREAK_RUNS, RUNS, Grid, run

    experiment = "prove" if options.prove else options.experiment
    usual = {"mutants": PLANS, "withstands": BREAK_RUNS}.get(experiment, RUNS[options.kind])
    trials = options.trials if experiment in ("", "ablation") else 1 + (options.prove or 0)
    grid = Grid(options.kind, options.runs or usual, trials, options.seed, experiment)
    grid.check()
    simulation_kind(grid.kind)  # there is one
    log = None if options.out is None else options.out / f"physics_{grid.part}.rows"
    load = os.getloadavg()
    with Bar(f"bench physics, {grid.part}", grid.runs) as bar:
        found = run(grid, options.jobs, log, bar.tell)
    kept = "" if log is None else f"; the same command goes on from {log}"
    code = finish(options, report.as_result(found, load), report, partial=kept)
    if log is not None and found.is_complete:
        log.unlink(missing_ok=True)
    return code
