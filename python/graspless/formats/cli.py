# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless export`. Formats are imported when it runs."""

from __future__ import annotations

import contextlib
import re
import sys
from typing import TYPE_CHECKING

from .. import files
from .._commands import FOUND
from .._given_plan import add_unchecked, checked_plan
from ..errors import TaskError

if TYPE_CHECKING:
    import argparse
    from collections.abc import Iterator

FLAGS = {
    "max_velocity": "--velocity",
    "max_acceleration": "--acceleration",
    "max_jerk": "--jerk",
    "contact_speed": "--contact-speed",
}  # the others are called as in Python
FIELD = rf"^(to|rate|fingers|group)(?=: )|(?<!\S)({'|'.join(FLAGS)})(?=[:, ])"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `export`."""
    parser.description = (
        "Time a plan within the limits of the robot and write it for another program. ros: "
        "trajectory_msgs/JointTrajectory as YAML; mcap: ROS 2 messages; csv: a table; mujoco: MJCF "
        "with keyframes; json: by trajectory.schema.json; drake: model directives and polynomials; "
        "rrd: a recording for rerun. See docs/export.md."
    )
    parser.add_argument("plan", metavar="PLAN", help="plan file; - for stdin")
    parser.add_argument(
        "--to", required=True, choices=["ros", "mcap", "csv", "mujoco", "json", "drake", "rrd"]
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        required=True,
        help="file; mcap: FILE.mcap or a new folder; drake: a new folder; text: - for stdout",
    )
    parser.add_argument(
        "--group", metavar="NAME", help="only the joints of a group of the SRDF: arm, hand"
    )
    for flag, what in (
        (
            "--velocity",
            "velocity limit of every joint [rad/s, m/s]; never above the limits of the URDF",
        ),
        (
            "--acceleration",
            "acceleration limit of every joint [rad/s^2, m/s^2] (default: 5 and 1)",
        ),
        (
            "--jerk",
            "jerk limit of every joint [rad/s^3, m/s^3] (default: 50 times its acceleration)",
        ),
    ):
        parser.add_argument(
            flag,
            type=_limit,
            action="append",
            metavar="V",
            help=f"{what}; JOINT=V limits one joint and may be repeated",
        )
    for flag, unit, what in (
        ("--rate", "HZ", "samples per second (default: 100)"),
        (
            "--contact-speed",
            "V",
            "speed limit of parts in contact [m/s] (default: 0.05; fingertip plans: 0.02; "
            "a held object on its way to a place: 0.2)",
        ),
    ):
        parser.add_argument(flag, type=float, metavar=unit, help=what)
    parser.add_argument(
        "--fingers",
        action="store_true",
        help="export the bare fingertips of a plan that has an arm",
    )
    add_unchecked(parser)
    parser.set_defaults(run=_run)


def _limit(text: str) -> tuple[str, float]:
    """Joint and limit; every joint's has no name."""
    joint, equals, value = text.rpartition("=")
    if equals and not joint:  # a shell's variable that is not set, say
        raise ValueError
    return joint, float(value)


_limit.__name__ = "limit"  # as argparse calls what it is not


def _limits(flag: str, given: list[tuple[str, float]] | None) -> float | dict[str, float] | None:
    """Returns the limits as `time` takes them."""
    if given is None:
        return None
    limits = dict(given)
    if len(limits) < len(given) or ("" in limits and len(limits) > 1):
        raise TaskError(f"{flag}: should be one number, or one JOINT=V of each joint that is named")
    return limits.get("", limits)


def _run(options: argparse.Namespace) -> int:
    from .. import progress
    from . import export, text

    given = {
        "rate": options.rate,
        "max_velocity": _limits("--velocity", options.velocity),
        "max_acceleration": _limits("--acceleration", options.acceleration),
        "max_jerk": _limits("--jerk", options.jerk),
        "contact_speed": options.contact_speed,
        "fingers": options.fingers,
        "group": options.group,
    }
    plan, to_stdout = checked_plan(options), options.output == "-"
    with _naming_flags(), progress.waiting("timing and writing"):
        if to_stdout:
            trajectory, written = text(plan, options.to, **given)
        else:
            trajectory = export(plan, options.output, options.to, **given)
    if to_stdout:
        files.to_stdout(written)
    told = sys.stderr if to_stdout else sys.stdout
    print(f"written: {'stdout' if to_stdout else options.output}", file=told)
    content = "keyframes" if options.to == "mujoco" else f"{len(trajectory)} samples"
    print(f"  {content}, {trajectory.duration:.2f} s", file=told)
    if trajectory.start:
        joints = ", ".join(f"{name} {value:.4f}" for name, value in trajectory.start.items())
        print(f"  move the robot to the first configuration before you start: {joints}", file=told)
    return FOUND


@contextlib.contextmanager
def _naming_flags() -> Iterator[None]:
    """Faults name flags, not arguments of Python."""
    try:
        yield
    except TaskError as error:
        told = re.sub(FIELD, lambda found: FLAGS.get(found[0], f"--{found[0]}"), str(error))
        raise TaskError(told) from None
