# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless pick`, which plans how an object of a scene is picked up."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from .. import _data
from .._commands import EXIT_CODES, FOUND, NOT_FOUND
from ..errors import TaskError

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
    parser.epilog = (
        f"{EXIT_CODES}\n\nexample: graspless pick scene.yaml object_0 --robot wam_t42 -o plan.json"
    )
    parser.add_argument(
        "scene",
        metavar="SCENE.yaml",
        help="scene file that `graspless see` wrote, or a task file of kind pick",
    )
    parser.add_argument(
        "name", metavar="NAME", nargs="?", help="name of the object in the scene; not with a task"
    )
    parser.add_argument(
        "--robot",
        metavar="ROBOT",
        help="robot that comes with graspless, or a URDF; needed unless a task file names it",
    )
    parser.add_argument(
        "--strategies",
        metavar="LIST",
        help="strategies to try, in this order (default: pinch,slide,clasp)",
    )
    parser.add_argument(
        "--lift", type=float, metavar="M", help="height of the lift [m] (default: 0.1)"
    )
    parser.add_argument(
        "--respect",
        choices=["nothing", "objects", "unseen"],
        help="obstacles besides the support (default: objects)",
    )
    parser.add_argument("--mass", type=float, metavar="KG", help="mass in simulations [kg]")
    parser.add_argument(
        "--best-of", type=int, metavar="N", help="find N plans and keep the shortest (default: 1)"
    )
    parser.add_argument("--time", type=float, metavar="S", help="time limit [s] (default: 10)")
    parser.add_argument(
        "--seed", type=int, metavar="N", help="seed of the random numbers (default: 1)"
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
    from .. import files
    from ..cli import check_pictures, draw
    from . import pick

    files.check_writable(options.output)
    check_pictures(options)
    given = _given(options)
    found = pick(**given)
    written: list[str] = []
    if found.plan is not None:
        found.plan.save(options.output)
        written = [options.output, *draw(found.plan, options)]
    if options.json:
        print(json.dumps(found.as_dict() | {"faults": [], "written": written}))
    else:
        print("\n".join(_lines(found, given["robot"], written)))
    return FOUND if found else NOT_FOUND


def _given(options: argparse.Namespace) -> dict[str, Any]:
    """Returns the arguments of `pick`: of the task file, and in their place those of the flags."""
    from .task import read_pick

    given = read_pick(options.scene)
    if given is not None and options.name is not None:
        raise TaskError(f"NAME: {options.name}: must not be given: {options.scene} names it")
    if given is None:
        if options.name is None:
            raise TaskError(f"NAME: missing: {options.scene} is not a task file of kind pick")
        given = {"scene": options.scene, "name": options.name}
    flags = {name: getattr(options, name) for name in ("robot", "lift", "respect", "mass", "seed")}
    flags |= {"best_of": options.best_of, "seconds": options.time}
    if options.strategies is not None:
        flags["strategies"] = options.strategies.split(",")
    given |= {name: value for name, value in flags.items() if value is not None}
    if "robot" not in given:
        known = ", ".join(_data.robots())
        raise TaskError(f"--robot: missing: should be the path of a URDF, or one of {known}")
    return given


def _lines(found: Pick, robot: Any, written: list[str]) -> list[str]:
    """Returns the summary as text."""
    from .. import report

    took = f"{1000 * found.seconds:.0f} ms"
    what = "no way to pick it up was found" if not found else f"{found.strategy}, then lift"
    shown = robot.get("urdf") or robot.get("name") if isinstance(robot, dict) else robot
    lines = [f"{found.name} with {shown}: {what}, in {took}"]
    lines += [f"  {line}" for line in found.table().splitlines()]
    if found.plan is not None:
        plan: Any = found.plan
        lines.append(report.verdict(plan, []))
    return lines + [f"written: {path}" for path in written]
