# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The force of fingers, by the effort limits of their joints."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from .robots import given_field

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from .._core.clasp import Hand as ClaspHand
    from .._core.robot import Robot
    from .._core.slide import Hand
    from ..frames import Matrix
    from .source import Source

STRONGEST = 500.0  # of most grippers of arms; above it, limits are often placeholders [N]
_STEP = 1e-4  # of a joint [rad or m]
_IDLE = 1e-3  # a joint that moves the fingers less does not press [m/rad or 1]
_MIRROR = np.diag([1.0, -1.0, 1.0, 1.0])

End = tuple[str, "Matrix"]  # of a finger: a link, and a point in its frame [m]


def forces(
    robot: Robot, joints: Iterable[str], half: Matrix, gap: Callable[[Matrix], float]
) -> dict[str, float]:
    """Returns the force of each finger at the effort limit of each joint that presses [N].

    Parameters
    ----------
    robot : Robot
    joints : list of str
        Names of joints of the hand.
    half : array [dof]
        Configuration with the hand half way closed [rad or m].
    gap : callable
        Distance between the ends of both fingers at a configuration [m].
    """
    found, start = {}, gap(half)
    for name in joints:
        moved = half.copy()
        moved[robot.joint(name)] += _STEP
        rate = abs(gap(moved) - start) / _STEP
        if rate > _IDLE:
            found[name] = float(robot.max_effort[robot.joint(name)]) / rate
    return found


def weakest_joint(
    robot: Robot, joints: Iterable[str], half: Matrix, ends: tuple[End, End]
) -> tuple[str, float] | None:
    """Returns the joint that limits the force of two fingers, and that force [N].

    None if no effort limit is known. The arguments are as in `forces`.
    """
    found = forces(robot, joints, half, lambda q: _distance(robot, ends, q))
    known = [(force, name) for name, force in found.items() if math.isfinite(force)]
    return min(known)[::-1] if known else None


def warn_of_grip(
    robot: Robot,
    hand: Hand | ClaspHand,
    pairs: Iterable[tuple[End, End]],
    source: Source,
    instead: str = "",
) -> None:
    """Warns of an effort limit with which a finger presses harder than most grippers do.

    Parameters
    ----------
    robot : Robot
    hand : slide.Hand or clasp.Hand
    pairs : iterable of (End, End)
        Ends of fingers that press against each other.
    source : Source
    instead : str
        Says what else than the limit may be given.
    """
    field = given_field(source)
    if field == "urdf_text":  # a plan was made in spite of it
        return
    opened, closed = (np.array(robot.state(name)) for name in (hand.open, hand.closed))
    moving = [robot.joint_names[i] for i in np.flatnonzero(opened != closed)]
    found = [weakest_joint(robot, moving, (opened + closed) / 2, ends) for ends in pairs]
    name, force = max((f for f in found if f), key=lambda f: f[1], default=("", 0.0))
    if force <= STRONGEST:
        return
    index, place = robot.joint(name), "gripper" if "gripper" in source.given("robot") else field
    presses = "a finger presses" if len(found) > 1 else "each finger presses"
    unit = "N" if robot.step_weights[index] > 1 else "Nm"
    source.warn(
        ("robot", place),
        f"joint '{name}' has an effort limit of {robot.max_effort[index]:g} {unit}, with which "
        f"{presses} with {force:.0f} N; few grippers are stronger than "
        f"{STRONGEST:g} N: write the real limit into the URDF{instead}",
    )


def ends_of_jaws(robot: Robot, hand: Hand) -> tuple[End, End] | None:
    """Returns the end of the sliding finger, and its mirror image on the other one, if any."""
    others = [link for link in hand.fingers if link not in hand.sliding_finger]
    if not others:
        return None
    q = np.array(robot.state(hand.open))
    X_WH, X_WF = robot.pose(hand.grasp_frame, q), robot.pose(hand.fingertip, q)
    X_WT = X_WH @ _MIRROR @ np.linalg.inv(X_WH) @ X_WF
    X_LT = np.linalg.inv(robot.pose(others[-1], q)) @ X_WT
    return (hand.fingertip, np.zeros(3)), (others[-1], X_LT[:3, 3])


def ends_of_curves(hand: ClaspHand, finger: Any) -> tuple[End, End]:
    """Returns the ends of a finger and of the thumb of a hand that clasps."""
    first, second = finger.nodes[-1], hand.thumb.nodes[-1]
    return (first.link, np.asarray(first.p_L)), (second.link, np.asarray(second.p_L))


def _distance(robot: Robot, ends: tuple[End, End], q: Matrix) -> float:
    first, second = (frames.transform(robot.pose(link, q), p_L[None])[0] for link, p_L in ends)
    return float(np.linalg.norm(first - second))
