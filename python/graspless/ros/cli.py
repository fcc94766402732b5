# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless ros`."""

from __future__ import annotations

import argparse

from .._commands import FOUND, INTERRUPTED
from ..errors import TaskError
from . import require_ros

WHAT = {
    "node": "Run the actions plan_task and pick_object and the service check_plan. "
    "`ros2 param describe /graspless NAME` says what a parameter means.",
    "fake-robot": "Run a simulated robot with the controllers of ros2_control and a depth camera.",
    "demo": "Run the simulated robot and the node on this computer alone, and pick up a bar: from "
    "the image to the lift.",
}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds description and arguments of `ros`."""
    parser.description = (
        "Run graspless in ROS 2. node: the actions plan_task and pick_object and the service "
        "check_plan; fake-robot: a simulated robot with the controllers of ros2_control; demo: "
        "both, and a pick from the image to the lift. See docs/howto/ros2.md."
    )
    parser.add_argument("what", choices=WHAT, nargs="?")
    _add_rest(parser)
    parser.set_defaults(run=_run)


def _add_rest(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "arguments",
        nargs=argparse.REMAINDER,
        metavar="--ros-args ...",
        help="arguments of ROS, such as --ros-args --params-file FILE",
    )


def _run(options: argparse.Namespace) -> int:
    if options.what is None:
        raise TaskError(f"ros: needs the name of what to run (one of: {', '.join(WHAT)})")
    if {"-h", "--help"} & set(options.arguments):
        own = argparse.ArgumentParser(
            prog=f"graspless ros {options.what}", description=WHAT[options.what]
        )
        _add_rest(own)
        own.print_help()
        return FOUND
    require_ros()
    if options.what == "demo":
        from .demo import demo

        return demo(options.arguments)
    from .spinning import run_fake_robot, run_node

    run = run_node if options.what == "node" else run_fake_robot
    return FOUND if run(options.arguments) else INTERRUPTED
