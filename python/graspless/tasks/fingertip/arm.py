# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robot that carries a plan's fingertips."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..._core import fingertip
from ..robots import build_home, build_robot
from ..source import at

if TYPE_CHECKING:
    from ..._core import robot as robots
    from ...frames import Matrix
    from ..source import Source
    from . import model


@dataclass(frozen=True)
class Arm:
    """Robot that carries fingertips, with its start and the parts that are fingertips.

    Attributes
    ----------
    robot : robot.Robot
    carrier : fingertip.Carrier
        Frames of the fingertips.
    q_home : array [dof]
        Start configuration [rad or m].
    options : fingertip.RealizeOptions
        Options of the search for joint paths.
    """

    robot: robots.Robot
    carrier: fingertip.Carrier
    q_home: Matrix
    options: fingertip.RealizeOptions


def build_arm(task: model.FingertipTask, source: Source) -> Arm | None:
    """Returns the robot of a resolved task, if it has one."""
    if task.robot is None:
        return None
    robot = build_robot(task.robot, source)
    fields = {} if task.carrier is None else task.carrier.model_dump(exclude_none=True)
    carrier = fingertip.Carrier(**fields)
    for field, frames in (
        ("fingertips", carrier.fingertips),
        ("links", [link for links in carrier.links for link in links]),
    ):
        for frame in frames:
            with at(source, "carrier", field):
                robot.frame(frame)
    if not len(carrier.fingertips) == len(carrier.links) == task.fingers.count:
        what = f"{len(carrier.fingertips)} fingertips and {len(carrier.links)} lists of links"
        needed = f"; one of each is needed for each of {task.fingers.count} fingers"
        raise source.error(("carrier",), what + needed)
    given = {} if task.realize is None else task.realize.model_dump(exclude_none=True)
    with at(source, "realize"):
        options = fingertip.RealizeOptions(**given)
    return Arm(robot, carrier, build_home(task.robot, robot, source), options)
