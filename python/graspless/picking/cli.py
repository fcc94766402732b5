# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless pick`, which plans how an object of a scene is picked up."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from .. import _data
from .._commands import (
    FOUND,
    NOT_FOUND,
    add_packages,
    add_seconds,
    add_trust,
    exit_codes,
    given_packages,
)
from ..errors import TaskError

if TYPE_CHECKING:
    import argparse

    from .result import Pick


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `pick`."""
    import argparse as parsers

    from .._pictures import add_pictures

    parser.formatter_class = parsers.RawDescriptionHelpFormatter
    parser.description = (
        "Plan how a robot picks up an object of a scene: pinch it where it stands, pinch a wall\n"
        "of it, slide it to an edge and grasp it there, clasp a hole or handle of it, or first\n"
        "tumble or push it with two fingertips, and lift it. The plan is a chain; if there is\n"
        "none, the table says why not for each strategy."
    )
    example = "graspless pick scene.yaml object_0 --robot wam_t42 -o plan.json"
    parser.epilog = f"{exit_codes()}\n\nexample: {example}"
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
        action="append",
        help="robot that comes with graspless, or a URDF; needed unless a task file names it. "
        "Repeat it for several robots, of which any may do it",
    )
    parser.add_argument(
        "--strategies",
        metavar="LIST",
        help="strategies to try, in this order (default: pinch,rim,slide,clasp,tumble,push)",
    )
    parser.add_argument(
        "--place",
        metavar="YAML",
        help="where to put the object down, as in task files: 'on: support_1', "
        "'pose: {x: 0.6, y: 0.2, yaw: 0}' or 'region: {rectangle: {center: [x, y], size: [a, b]}}'",
    )
    parser.add_argument(
        "--lift", type=float, metavar="M", help="height of the lift [m] (default: 0.1)"
    )
    parser.add_argument(
        "--respect",
        choices=["nothing", "objects", "unseen"],
        help="obstacles besides the support (default: objects)",
    )
    parser.add_argument(
        "--padding",
        type=float,
        metavar="M",
        help="distance to keep from the other objects [m] (default: 0)",
    )
    parser.add_argument(
        "--max-age", type=float, metavar="S", help="refuse a scene whose images are older [s]"
    )
    parser.add_argument(
        "--mass",
        type=float,
        metavar="KG",
        help="mass that the fingers must bear; needed to tumble and push [kg]",
    )
    parser.add_argument(
        "--grip-force",
        type=float,
        metavar="N",
        help="force of each finger that pinches [N] (default: by half the hand's effort limits)",
    )
    parser.add_argument(
        "--best-of",
        type=int,
        metavar="N",
        help="find up to N plans, also by later strategies and with other seeds, and keep the one "
        "of the shortest duration (default: 1)",
    )
    add_seconds(parser, "time limit [s] (default: 10)")
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
    add_packages(parser)
    add_trust(parser)
    parser.add_argument("--json", action="store_true", help="print the summary as JSON")
    add_pictures(parser)
    parser.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    from .. import files
    from .._pictures import check_pictures, draw
    from . import pick

    files.check_writable(options.output)
    check_pictures(options)
    given = _given(options)
    found = pick(**given, trust=options.trust)
    written: list[str] = []
    if found.plan is not None:
        found.plan.save(options.output)
        written = [options.output, *draw(found.plan, options)]
    if options.json:
        print(json.dumps(found.as_dict() | {"faults": [], "written": written}))
    else:
        print("\n".join(_lines(found, written)))
    return FOUND if found else NOT_FOUND


def _given(options: argparse.Namespace) -> dict[str, Any]:
    """Returns the arguments of `pick`: of the task file, and in their place those of the flags."""
    from ..tasks.reading import parse_yaml
    from .task import read_pick

    given = read_pick(options.scene)
    if given is not None and options.name is not None:
        raise TaskError(f"NAME: {options.name}: must not be given: {options.scene} names it")
    if given is None:
        if options.name is None:
            raise TaskError(f"NAME: missing: {options.scene} is not a task file of kind pick")
        given = {"scene": options.scene, "name": options.name}
    same = ("robot", "lift", "respect", "padding", "max_age", "mass", "grip_force", "seed")
    flags = {name: getattr(options, name) for name in same}
    flags |= {"best_of": options.best_of, "seconds": options.seconds}
    if options.strategies is not None:
        flags["strategies"] = options.strategies.split(",")
    if options.place is not None:
        given["place"] = parse_yaml(options.place, "--place").data
    given |= {name: value for name, value in flags.items() if value is not None}
    if "robot" not in given:
        known = ", ".join(_data.robots())
        raise TaskError(f"--robot: missing: should be the path of a URDF, or one of {known}")
    if packages := given_packages(options):
        given["robot"] = _with_packages(given["robot"], packages)
    return given


def _with_packages(robot: Any, packages: dict[str, str]) -> Any:
    """Returns one or several robots whose meshes may be in these folders, too."""
    if isinstance(robot, list):
        return [_with_packages(one, packages) for one in robot]
    fields: dict[str, Any] = {"urdf": robot} if isinstance(robot, str) else robot
    return fields | {"packages": fields.get("packages", {}) | packages}


def _way(found: Pick) -> str:
    if found.plan is None:
        return "no way to do it was found"
    return ", then ".join(found.plan.names)


def _lines(found: Pick, written: list[str]) -> list[str]:
    """Returns the summary as text."""
    from .. import report

    took = f"{1000 * found.seconds:.0f} ms"
    what = _way(found)
    shown = found.robot or " or ".join(dict.fromkeys(a.robot for a in found.attempts if a.robot))
    lines = [f"{found.name} with {shown}: {what}, in {took}"]
    lines += [f"  {line}" for line in found.table().splitlines()]
    if found.plan is not None:
        plan: Any = found.plan
        lines.append(report.verdict(plan, []))
    return lines + [f"written: {path}" for path in written]
