# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ways to break a clasp."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from graspless import frames
from graspless.robot import Robot

from . import Mutant, bend, block, keep_rows, segments

if TYPE_CHECKING:
    from collections.abc import Callable

    from ...machine import Row

ARM = 6  # joints of the arm, the first ones


def stay_open(document: Row) -> None:
    """Keeps the joints of the hand as they are at the start."""
    start = document["segments"][0]["positions"][0]
    for segment in document["segments"]:
        for row in segment["positions"]:
            row[ARM:] = start[ARM:]


def one_finger_stays_open(document: Row) -> None:
    """Keeps the last joint that closes, and its finger, as they are at the start."""
    start = document["segments"][0]["positions"][0]
    end = document["segments"][-1]["positions"][-1]
    names = document["joint_names"]
    moved = [i for i in range(ARM, len(start)) if abs(end[i] - start[i]) > 1e-3]
    finger = names[moved[-1]].rsplit("_", 2)[0]
    for segment in document["segments"]:
        for row in segment["positions"]:
            for i in moved:
                if names[i].startswith(finger):
                    row[i] = start[i]


def do_not_reach(document: Row) -> None:
    """Keeps the arm where it stands, so that the hand closes on air."""
    first = document["segments"][0]["positions"][0]
    for segment in document["segments"]:
        for row in segment["positions"]:
            row[:ARM] = first[:ARM]


def close_partly(share: float) -> Callable[[Row], None]:
    """Returns a change that keeps the first rows of the closing, at least one."""

    def change(document: Row) -> None:
        close = document["segments"][-1]
        keep_rows(close, slice(0, max(1, round(share * len(close["positions"])))))

    return change


def _aside(document: Row) -> None:
    reach, close = document["segments"]
    bend(0, 0.12, [reach])
    for row in close["positions"]:
        row[0] += 0.12


def _jump(document: Row) -> None:
    (reach,) = segments(document, "reach")
    half = len(reach["positions"]) // 2
    for row in reach["positions"][half : half + 2]:
        row[1] += 0.5


def _elsewhere(document: Row) -> None:
    """Moves the object across its loop. Along it, the hand would clasp another part."""
    pose = document["task"]["object"]["pose"]
    along = frames.from_rpy(pose["rpy"])[:3, :3] @ document["target"]["tangent"]
    across = np.cross([0.0, 0.0, 1.0], along)
    pose["position"] = (pose["position"] + 0.08 * across / np.linalg.norm(across)).tolist()


def _turned(document: Row) -> None:
    document["task"]["object"]["pose"]["rpy"][2] += 0.8


def _cut(document: Row) -> None:
    """Opens the handle: removes the points within 40 mm of the target."""
    thing = document["task"]["object"]
    points = np.array(thing["points"])
    apart = np.linalg.norm(points - np.array(document["target"]["point"]), axis=1)
    thing["points"] = points[apart > 0.04].tolist()


def _weak_motors(document: Row) -> None:
    """Gives the joints of the hand a twentieth of their effort."""
    robot = document["task"]["robot"]
    hand = "|".join(document["joint_names"][ARM:])

    def weaken(found: re.Match[str]) -> str:
        return re.sub(
            r'effort="([^"]*)"', lambda m: f'effort="{float(m[1]) / 20:g}"', found[0], count=1
        )

    pattern = rf'<joint name="(?:{hand})".*?</joint>'
    robot["urdf_text"] = re.sub(pattern, weaken, robot["urdf_text"], flags=re.DOTALL)


def _obstacle(document: Row) -> None:
    """Puts a cube where the outermost link of the closed hand is."""
    robot = Robot.from_urdf(document["task"]["robot"]["urdf_text"])
    q = document["segments"][-1]["positions"][-1]
    tip = robot.pose(robot.frame_names[-1], q)
    block(document, tip[:3, 3].tolist(), 0.03)


def _safer(document: Row) -> None:
    document["stability"] |= {"margin": 1.0, "escapes": 0}


def _stronger(document: Row) -> None:
    document["stability"]["withstands"] *= 3


MOTION = "the motion is as before"
MUTANTS = [
    Mutant("stays open", "the hand does not close", stay_open),
    Mutant("a finger stays open", "one finger does not close", one_finger_stays_open),
    Mutant("half closed", "the second half of `close` is missing", close_partly(0.5)),
    Mutant("no reach", "the arm stays where it stands", do_not_reach),
    Mutant("aside", "the arm is turned by 0.12 rad, little by little on its way", _aside),
    Mutant("jump", "a joint is 0.5 rad off for two rows of `reach`", _jump),
    Mutant("elsewhere", "the object stands 80 mm aside, across its loop", _elsewhere),
    Mutant("turned", "the object is turned by 0.8 rad", _turned),
    Mutant(
        "cut handle", "the handle is cut: the points within 40 mm of the target are missing", _cut
    ),
    Mutant("weak motors", "the motors of the hand have a twentieth of their effort", _weak_motors),
    Mutant("obstacle", "a cube of 30 mm is where the hand closes", _obstacle),
    Mutant("margin", "the plan claims the largest margin", _safer, MOTION),
    Mutant("withstands", "the plan claims to withstand 3 times the force", _stronger, MOTION),
]
