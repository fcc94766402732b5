# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless robot join`."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._commands import FOUND, add_packages, add_trust, given_packages
from ..errors import TaskError
from .robot_inspect import require_used

if TYPE_CHECKING:
    import argparse

EXAMPLE = "example: graspless robot join ur5e.urdf robotiq.urdf --mount tool0 -o joined.urdf"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `robot join`."""
    parser.description = (
        "Write one URDF of an arm and a gripper, with absolute paths of meshes. If one of them has "
        "an SRDF, one of both is written beside it."
    )
    parser.epilog = EXAMPLE
    for name, what in (("arm", "the arm"), ("gripper", "the gripper or hand")):
        parser.add_argument(
            name,
            metavar=name.upper(),
            help=f".urdf or .xacro file of {what}, a robot that comes with graspless, or a name in "
            "robot_descriptions that ends in _description",
        )
    parser.add_argument(
        "--mount", metavar="LINK", required=True, help="link of the arm that carries the gripper"
    )
    parser.add_argument(
        "--root",
        metavar="LINK",
        default="",
        help="link of GRIPPER to mount, with all that it carries; default: all of GRIPPER",
    )
    for name, about in (("xyz", "position [m]"), ("rpy", "roll, pitch and yaw [rad]")):
        parser.add_argument(
            f"--{name}",
            type=float,
            nargs=3,
            default=[0.0, 0.0, 0.0],
            metavar=("X", "Y", "Z"),
            help=f"{about} of the gripper's root link in the mount (default: 0 0 0)",
        )
    parser.add_argument(
        "--prefix",
        default="",
        help="prefix of all names of the gripper (default: gripper_, only for names that the arm "
        "also has)",
    )
    add_packages(parser)
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        default="joined.urdf",
        help="URDF file to write (default: %(default)s); - for stdout, without the SRDF",
    )
    add_trust(parser)
    parser.set_defaults(run=_join)


def _join(options: argparse.Namespace) -> int:
    from pydantic import create_model

    from .. import files
    from ..tasks import robots, source, units
    from ..tasks.robot_files import find_urdf, resolve_robot

    to_stdout = options.output == "-"
    path = Path(options.output)
    srdf = path.with_suffix(".srdf")
    if not to_stdout:
        if path.suffix != ".urdf":
            raise TaskError(f"--output: {path}: should end in .urdf")
        files.check_writable(path)
        files.check_writable(srdf)
    given = source.Source("robot join", {"robot": _fields(options)}, is_trusted=options.trust)
    asked = given.validate(create_model("Asked", robot=(robots.Robot, ...)))
    units.warn_of_units(asked, given)
    resolved, _ = resolve_robot(asked.robot, given, Path())
    built = robots.build_robot(resolved, given)
    if options.package:
        parts = (options.arm, options.gripper)
        fields = ("name" if _is_name(part) else "file" for part in parts)
        found = (find_urdf(*both, (), given, Path()) for both in zip(parts, fields, strict=True))
        require_used(options, *(part.urdf for part in found))
    if not to_stdout and not resolved.srdf_text and srdf.exists():
        what = "neither robot has an SRDF, and this file would be read instead; remove it"
        raise TaskError(f"--output: {srdf}: {what}")
    if to_stdout:
        files.to_stdout(resolved.urdf_text or "")
    else:
        files.write(path, resolved.urdf_text or "")
        if resolved.srdf_text:
            files.write(srdf, resolved.srdf_text)
    told = sys.stderr if to_stdout else sys.stdout
    print(f"{built.name}: {built.dof} joints, {len(built.frame_names)} links", file=told)
    if not to_stdout:
        print(f"written: {path}")
        if resolved.srdf_text:
            print(f"written: {srdf}")
    return FOUND


def _fields(options: argparse.Namespace) -> dict[str, Any]:
    """Returns the robot as a task file states it."""
    packages = given_packages(options)
    gripper = {
        "name" if _is_name(options.gripper) else "file": options.gripper,
        "mount": options.mount,
        "pose": {"position": options.xyz, "rpy": options.rpy},
        "prefix": options.prefix,
        "root": options.root,
        "packages": packages,
    }
    return {
        "name" if _is_name(options.arm) else "arm": options.arm,
        "gripper": gripper,
        "packages": packages,
    }


def _is_name(text: str) -> bool:
    return text.endswith("_description") and not Path(text).exists()
