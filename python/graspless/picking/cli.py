# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless pick`, which plans how an object of a scene is picked up."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from .._commands import EXIT_CODES, FOUND, NOT_FOUND

if TYPE_CHECKING:
    import argparse

    from .result import Pick


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `pick`."""
    import argparse as parsers

    parser.formatter_class = parsers.RawDescriptionHelpFormatter
    parser.description = (
        "Plan how a robot picks up an object of a scene: pinch it where it stands, slide it to an\n"
        "edge and grasp it there, or clasp a hole or handle of it, and lift it. The plan is a\n"
        "chain; if there is none, the table says why not for each strategy."
    )
    parser.epilog = f"{EXIT_CODES}\n\nexample: graspless pick scene.yaml object_0 -o plan.json"
    parser.add_argument("scene", metavar="SCENE.yaml", help="scene file that `graspless see` wrote")
    parser.add_argument("name", metavar="NAME", help="name of the object in the scene")
    parser.add_argument(
        "--robot",
        metavar="ROBOT",
        default="wam_t42",
        help="robot that comes with graspless, or a URDF (default: %(default)s)",
    )
    parser.add_argument(
        "--strategies",
        metavar="LIST",
        default="pinch,slide,clasp",
        help="strategies to try, in this order (default: %(default)s)",
    )
    parser.add_argument(
        "--lift", type=float, default=0.1, metavar="M", help="height of the lift [m] (default: 0.1)"
    )
    parser.add_argument(
        "--respect",
        choices=["nothing", "objects", "unseen"],
        default="objects",
        help="obstacles besides the support (default: %(default)s)",
    )
    parser.add_argument("--mass", type=float, metavar="KG", help="mass in simulations [kg]")
    parser.add_argument(
        "--best-of",
        type=int,
        default=1,
        metavar="N",
        help="find N plans and keep the shortest (default: 1)",
    )
    parser.add_argument(
        "--time", type=float, default=10.0, metavar="S", help="time limit [s] (default: 10)"
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="N", help="seed of the random numbers (default: 1)"
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        default="plan.json",
        help="plan file to write if a plan is found (default: %(default)s)",
    )
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")
    parser.add_argument("--png", metavar="FILE", help="write a picture to FILE")
    parser.add_argument(
        "--html", metavar="FILE", help="write a replay to FILE: a single page for any browser"
    )
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    from .. import _api, files
    from ..cli import check_pictures, draw
    from . import pick

    files.check_writable(options.output)
    check_pictures(options)
    found = pick(
        options.scene,
        options.name,
        options.robot,
        strategies=options.strategies.split(","),
        lift=options.lift,
        respect=options.respect,
        mass=options.mass,
        best_of=options.best_of,
        seconds=options.time,
        seed=options.seed,
    )
    written: list[str] = []
    faults: list[str] = []
    if found.plan is not None:
        faults = _api.check(found.plan)
        found.plan.save(options.output)
        written = [options.output, *draw(found.plan, options)]
    if options.json:
        print(json.dumps(found.as_dict() | {"faults": faults, "written": written}))
    else:
        print("\n".join(_lines(found, options.robot, faults, written)))
    return FOUND if found and not faults else NOT_FOUND


def _lines(found: Pick, robot: str, faults: list[str], written: list[str]) -> list[str]:
    """Returns the summary as text."""
    from .. import report

    took = f"{1000 * found.seconds:.0f} ms"
    what = "no way to pick it up was found" if not found else f"{found.strategy}, then lift"
    lines = [f"{found.name} with {robot}: {what}, in {took}"]
    lines += [f"  {line}" for line in found.table().splitlines()]
    if found.plan is not None:
        plan: Any = found.plan
        lines.append(report.verdict(plan, faults))
    return lines + [f"written: {path}" for path in written]
