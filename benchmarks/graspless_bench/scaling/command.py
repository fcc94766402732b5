# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench scaling`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ..arguments import add_output, finish

if TYPE_CHECKING:
    import argparse


def add_parser(experiments: Any) -> None:
    """Adds `scaling` to the experiments."""
    parser = experiments.add_parser(
        "scaling",
        help="growth of times with locations, obstacles, points, workers, ...",
        description="Plans problems of growing size and fits a power law to their times. Each "
        "time is the least of some runs: of the processor, or wall clock for threads and workers. "
        "Exit 1 when a query has no result.",
    )
    parser.add_argument("--curve", metavar="NAME", help="only this one (all)")
    add_output(parser, _run, "write results, a picture and scaling.md there")


def _run(options: argparse.Namespace) -> int:
    from ..bar import Bar
    from . import measure, report

    curves = measure.chosen(options.curve)
    load = os.getloadavg()
    with Bar("bench scaling", sum(len(curve.sizes) for curve in curves)) as bar:
        rows, is_complete = measure.run(curves, bar.tell)
    return finish(options, report.as_result(rows, is_complete, load), report)
