# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless bench edges`."""

from __future__ import annotations

import itertools
import json
import math
from collections import Counter
from typing import TYPE_CHECKING, Any

from graspless._commands import FOUND, NOT_FOUND

from ..arguments import positive

if TYPE_CHECKING:
    import argparse

KINDS = ("slide", "clasp", "pinch", "carry", "fingertip")


def add_parser(experiments: Any) -> None:
    """Adds `edges` to the experiments."""
    parser = experiments.add_parser(
        "edges",
        help="certificates of plans, and what samples miss",
        description="Plans tasks of a kind, certifies the plans, samples some certified edges "
        "at 0.0001 rad, and puts a ball beside the way of each hand: counts the edges that samples "
        "let through and the certificate refutes. Exit 1 when a sample violates a certificate.",
    )
    parser.add_argument("--kind", choices=KINDS, default="slide", help="(%(default)s)")
    parser.add_argument("--plans", type=positive(int), default=300, metavar="N", help="(300)")
    parser.add_argument("--json", action="store_true", help="print the result as JSON")
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    import numpy as np

    from ..bar import Bar
    from .kinds import MAKERS
    from .measure import measure

    counts: Counter[str] = Counter({"violations": 0})
    rng = np.random.default_rng(14)
    times = []
    with Bar(f"bench edges, {options.kind}", options.plans) as bar:
        for done, case in enumerate(itertools.islice(MAKERS[options.kind](), options.plans)):
            bar.tell(done)
            times.append(measure(case, rng, counts))
    solved = [1e3 * seconds for seconds in times if seconds is not None]
    median, most = (float(np.quantile(solved, q)) if solved else math.nan for q in (0.5, 0.99))
    if options.json:
        print(json.dumps(dict(counts) | {"median_ms": median, "p99_ms": most}))
    else:
        for name, count in sorted(counts.items()):
            print(f"{count:8}  {name}")
        print(f"CPU time of a certificate: median {median:.1f} ms, 99 % {most:.1f} ms")
    return NOT_FOUND if counts["violations"] else FOUND
