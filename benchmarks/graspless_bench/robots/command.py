# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench robots`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ..arguments import add_output, chosen, finish, positive

if TYPE_CHECKING:
    import argparse


def add_parser(experiments: Any) -> None:
    """Adds `robots` to the experiments."""
    parser = experiments.add_parser(
        "robots",
        help="robots of packages on PyPI",
        description="Inspects arms with hands from packages on PyPI, from their URDF alone, and "
        "plans slides and clasps with each. Needs the packages in docs/results/robots.md, "
        "without their dependencies. Exit 1 when a plan failed its check.",
    )
    parser.add_argument("--robot", action="append", metavar="NAME", help="only this one; repeat")
    for name, count in (("slides", 20), ("clasps", 5)):
        parser.add_argument(
            f"--{name}", type=positive(int), default=count, metavar="N", help=f"({count})"
        )
    parser.add_argument(
        "--time", type=positive(float), default=4.0, metavar="S", help="limit of a slide [s] (4)"
    )
    parser.add_argument(
        "--clasp-time", type=positive(float), default=10.0, metavar="S", help="of a clasp [s] (10)"
    )
    add_output(parser, _run, "write results and robots.md there")


def _run(options: argparse.Namespace) -> int:
    from ..bar import Bar
    from . import report
    from .fleet import FLEET
    from .run import run

    fleet = chosen("robot", options.robot, {member.name: member for member in FLEET}).values()
    load = os.getloadavg()
    limits = (options.time, options.clasp_time)
    with Bar("bench robots", len(fleet)) as bar:
        rows = run(fleet, options.slides, options.clasps, limits, bar.tell)
    return finish(options, report.as_result(rows, load), report)
