# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless simulate`. The simulation is imported when it runs."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from .._commands import FOUND, NOT_FOUND
from .._given_plan import add_unchecked, checked_plan

if TYPE_CHECKING:
    import argparse


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `simulate`."""
    parser.description = (
        "Execute a plan in MuJoCo and judge it by the motion of the object. The first trial is "
        "nominal. The others vary friction, mass, the pose of the object and the time step; "
        "for slides, pinches, and chains that begin with them, also thickness, centre of mass, the "
        "height of the support and the flexures. "
        "For fingertip plans they vary friction by 10 %, the positions of the fingers (with an "
        "arm: of the object) by 0.1 mm, and the time step. The exit code is 1 if a trial failed."
    )
    parser.add_argument("plan", metavar="PLAN", help="plan file; - for stdin")
    parser.add_argument(
        "--trials", type=int, default=1, metavar="N", help="number of trials (default: %(default)s)"
    )
    parser.add_argument(
        "--seed",
        type=int,
        default=0,
        metavar="S",
        help="seed of the variations (default: %(default)s)",
    )
    parser.add_argument(
        "--closed-loop",
        action="store_true",
        help="for slides: follow the plan by a camera that is late, noisy and biased",
    )
    parser.add_argument(
        "--condition",
        metavar="C",
        help="for slides: a single difference from the plan for all trials: none, friction, "
        "start, kick, mass, thickness or table",
    )
    parser.add_argument("--html", metavar="FILE", help="write a replay of the first trial to FILE")
    parser.add_argument(
        "--disturb",
        action="store_true",
        help="for fingertip plans: also find the smallest disturbance that breaks the weakest row "
        "(slow); the object is held by bare fingertips, even if the plan has an arm",
    )
    add_unchecked(parser)
    parser.add_argument("--json", action="store_true", help="print the trials as JSON")
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    from .. import progress, view
    from ..errors import TaskError
    from ..report import count
    from ..report import simulation as report
    from . import simulate

    if options.html is not None:
        view.check_html(options.html)
    plan = checked_plan(options)
    if options.disturb and plan.kind != "fingertip":
        raise TaskError(
            f"--disturb: {plan.kind} plans have no stability margin (fingertip plans do)"
        )
    with progress.waiting(f"simulating, {count(options.trials, 'trials')}"):
        found = simulate(
            plan,
            options.trials,
            options.seed,
            closed_loop=options.closed_loop,
            condition=options.condition,
            record=options.html is not None,
        )
    disturbed = _disturb(plan) if options.disturb else None
    if options.html is not None:
        with progress.waiting(f"drawing {options.html}"):
            view.write_html(plan, options.html, recording=found.trials[0].recording)
    if options.json:
        document = found.as_dict() | ({"disturbed": disturbed} if disturbed else {})
        print(json.dumps(document, allow_nan=False))
    else:
        print(report.as_text(found, disturbed))
        if options.html is not None:
            print(f"written: {options.html}")
    return FOUND if found else NOT_FOUND


def _disturb(plan: Any) -> dict[str, Any]:
    from .. import progress
    from ..kinds import part

    with progress.waiting("looking for the least disturbance that breaks it"):
        found: dict[str, Any] = part("simulation", "fingertip").disturb(plan)
    return found
