# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless robot inspect`."""

from __future__ import annotations

import json
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from .._commands import FOUND, NOT_FOUND, add_packages, add_trust, given_packages
from ..errors import TaskError, one_of

if TYPE_CHECKING:
    import argparse

    from ..robot import Robot
    from ..tasks.source import Source

PORT = 8080
EXAMPLE = "example: graspless robot inspect panda.urdf -o panda"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `robot inspect`."""
    parser.description = (
        "Propose what a URDF does not contain: joints of arm and hand, open and closed states, "
        "frames of fingertip and grasp, a home, and pairs of links not to be tested. The files "
        "that are written are ready for tasks. The exit code is 1 if `robot check` finds a fault "
        "in them."
    )
    parser.epilog = EXAMPLE
    add_robot(parser)
    parser.add_argument(
        "--palm", metavar="LINK", help="link of the palm, if there are several hands"
    )
    parser.add_argument(
        "-o", "--output", metavar="DIR", help="folder to write to (default: the robot's name)"
    )
    parser.add_argument("--json", action="store_true", help="print the proposal as JSON")
    parser.add_argument(
        "--serve", type=int, metavar="PORT", nargs="?", const=PORT,
        help=f"then serve a viewer with a slider per joint until Ctrl-C (default port: {PORT})",
    )  # fmt: skip
    parser.set_defaults(run=_run)


def add_robot(parser: argparse.ArgumentParser) -> None:
    """Adds the arguments that name a robot."""
    parser.add_argument("file", metavar="FILE", nargs="?", help=".urdf or .xacro file")
    parser.add_argument(
        "--name", metavar="NAME", help="instead of FILE: name of a robot in robot_descriptions"
    )
    add_packages(parser)
    add_trust(parser)


def read_robot(options: argparse.Namespace, command: str) -> tuple[Robot, Path]:
    """Returns the robot that the arguments name, and its file."""
    from ..tasks import robots, source
    from ..tasks.robot_files import resolve_robot

    if not options.file and not options.name:
        raise TaskError(f"{command}: give either FILE or --name")
    if options.file and options.name:
        raise TaskError(f"{command}: give either FILE or --name, not both")
    field = "urdf" if options.file else "name"
    fields = {field: options.file or options.name, "packages": given_packages(options)}
    given = source.Source(command, {"robot": fields}, is_trusted=options.trust)
    resolved, path = resolve_robot(robots.Robot.model_validate(fields), given, Path())
    assert path is not None
    require_used(options, path)
    robot = robots.build_robot(resolved, given)
    _warn_of_sizes(robot, given, field)
    return robot, path


def _warn_of_sizes(robot: Robot, given: Source, field: str) -> None:
    """Warns of collision shapes that look like millimetres."""
    from ..inspection.points import large_shapes

    found = large_shapes(robot)
    if found:
        link, size, is_mesh = found[0]
        more = f", and {len(found) - 1} more are like it" if len(found) > 1 else ""
        hint = ': a mesh in millimetres needs scale="0.001 0.001 0.001"' if is_mesh else ""
        shape = f"link '{link}' has a collision shape of {' x '.join(f'{n:.3g}' for n in size)} m"
        given.warn(("robot", field), f"{shape}{more}; lengths are in metres{hint}")


def require_used(options: argparse.Namespace, *urdfs: Path) -> None:
    """Raises TaskError if a --package has no effect. Of xacro files nobody knows which they use."""
    from ..tasks.meshes import packages_of
    from ..tasks.robots import stem

    if not options.package:
        return
    beside = [path.with_name(f"{stem(path)}.srdf.xacro") for path in urdfs]
    if any(path.suffix == ".xacro" and path.is_file() for path in (*urdfs, *beside)):
        return
    used = sorted(set().union(*(packages_of(path.read_text("utf-8")) for path in urdfs)))
    for name in given_packages(options):
        if name not in used:
            where = " or ".join(path.name for path in urdfs)
            choices = one_of(name, used) if used else ""
            raise TaskError(
                f"--package: {name}: has no effect: no package://{name}/ in {where}{choices}"
            )


def faults_of(robot: Robot, file: Path) -> list[str]:
    """Returns what is wrong with a file of a hand, for slides or for clasps."""
    from ..inspection import check
    from ..tasks.clasp.hand import Hand as ClaspHand
    from ..tasks.clasp.hand import build_hand as build_clasp_hand
    from ..tasks.clasp.hand import stated_hand
    from ..tasks.reading import read_yaml
    from ..tasks.slide.build import build_hand
    from ..tasks.slide.model import Hand

    source = read_yaml(file)
    if "thumb" in source.given():
        fields = source.validate(ClaspHand)
        build_clasp_hand(fields, robot, source, ())  # raises if it is not valid
        return check.clasp_faults(robot, stated_hand(fields))
    given = source.validate(Hand)
    return check.faults(robot, build_hand(given, robot, source), given.pitch)


def _run(options: argparse.Namespace) -> int:
    from .. import files, progress
    from ..robot import inspect
    from ..tasks import robots

    if options.serve is not None:
        from ..view import check_viewer

        check_viewer(options.serve)
    robot, path = read_robot(options, "robot inspect")
    name = robots.stem(path)
    folder = Path(options.output or name)
    if (folder / f"{name}.urdf").resolve() == path.resolve():
        raise TaskError(f"--output: {folder}: would replace {path}; choose another folder")
    with progress.waiting(f"inspecting {name}"):
        try:
            found = inspect(robot, palm=options.palm, name=name)
        except ValueError as error:
            raise TaskError(f"{name}: {error}") from None
    kept = _kept(found.files(), folder)
    written = found.write(folder)
    hands = [path for path in written if path.suffix == ".yaml"]
    faults = [f"{path}: {fault}" for path in hands for fault in faults_of(found.robot, path)]
    if find_spec("matplotlib") is not None:
        from ..view import figures

        picture = folder / f"{name}.png"
        files.write(picture, figures.as_png(found.plot()))
        written.append(picture)
    if options.json:
        paths = {"files": [*map(str, written)], "kept": [*map(str, kept)]}
        print(json.dumps(found.to_dict() | paths | {"faults": faults}))
    else:
        print(found)
        print("\n".join(f"written: {path}" for path in written))
        for path in kept:
            print(f"kept: {path}, as it was before")
        for fault in faults:
            print(f"fault: {fault}")
    if options.serve is not None:
        found.serve(options.serve)
    return NOT_FOUND if faults else FOUND


def _kept(texts: dict[str, str], folder: Path) -> list[Path]:
    """Renames files that differ from what takes their place, as somebody may have edited them."""
    from .. import files

    kept = []
    for name, text in texts.items():
        path = folder / name
        if path.is_file() and path.read_bytes() != text.encode():
            kept.append(files.set_aside(path))
    return kept
