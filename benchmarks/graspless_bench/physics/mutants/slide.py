# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ways to break a slide."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from graspless import frames, geometry

from . import Mutant, bend, block, keep_rows, leave_out, segments
from . import set_task as _set

if TYPE_CHECKING:
    from collections.abc import Callable

    from ...machine import Row

ARM = 7  # joints of the arm
TURN, LIFT, ROLL = 0, 1, 6  # joints of the arm that move the hand aside, up and about its axis
JUDGED = "the joints move as before"
STRAIGHT = "joints move straight between the rows that are left, as between all rows"
WEAK = (
    "where the weaker press still drags the object, the slide is as planned; plans do not claim "
    "that the hand can lift the object"
)


def _bent(joint: int, angle: float) -> Callable[[Row], None]:
    """Returns a change of a joint, little by little while it slides, and back while it lifts."""
    return lambda d: bend(joint, angle, segments(d, "slide"), segments(d, "lift"))


def _grasps_aside(document: Row) -> None:
    bend(TURN, 0.1, segments(document, "grasp", "close"))


def _no_grasp(document: Row) -> None:
    """The arm stays where it is before `grasp`; the hand closes there."""
    leave_out("grasp")(document)
    reach, close = segments(document, "reach", "close")
    for row in close["positions"]:
        row[:ARM] = reach["positions"][-1][:ARM]


def _ends_early(document: Row) -> None:
    (slide,) = segments(document, "slide")
    keep_rows(slide, slice(0, max(1, round(0.6 * len(slide["positions"])))))


def _jumps(document: Row) -> None:
    (slide,) = segments(document, "slide")
    half = len(slide["positions"]) // 2
    for row in slide["positions"][half : half + 3]:
        row[TURN] += 0.5


def _every_other_row(document: Row) -> None:
    for segment in document["segments"]:
        count = len(segment["positions"])
        keep_rows(segment, sorted({*range(0, count, 2), count - 1}))


def _stays_open(document: Row) -> None:
    (close,) = segments(document, "close")
    close["positions"] = [close["positions"][0]] * len(close["positions"])


def _obstacle(document: Row) -> None:
    (slide,) = segments(document, "slide")
    x, y, z, *_ = slide["object_poses"][len(slide["object_poses"]) // 2]
    block(document, [x, y, z + 0.02], 0.03)


def _top_heavy(document: Row) -> None:
    """Puts the centre of mass near the corner that is the farthest outside the support."""
    given, thing = document["task"]["support"], document["task"]["object"]
    X_SO = frames.from_row(document["X_WO_goal"])  # the support of these tasks is at the origin
    support = geometry.Polygon(np.array(given["polygon"]))
    far = min(thing["polygon"], key=lambda corner: support.depth((X_SO @ [*corner, 0, 1])[:2]))
    thing["com"] = [0.9 * x for x in far]


def _elsewhere(document: Row) -> None:
    document["task"]["object"]["pose"]["x"] += 0.03


def _other_goal(document: Row) -> None:
    document["X_WO_goal"][1] += 0.02


def _unturned(document: Row) -> None:
    (slide,) = segments(document, "slide")
    first = slide["object_poses"][0]
    slide["object_poses"] = [pose[:3] + first[3:] for pose in slide["object_poses"]]


def _longer_overhang(document: Row) -> None:
    document["overhang"] += 0.02


_weak = _set("hand", "flexure_stiffness", value=0.92)
SLOWLY = "little by little while it slides"
MUTANTS = [
    Mutant("no slide", "the segment `slide` is missing", leave_out("slide")),
    Mutant("ends early", "the last 40 % of the slide are missing", _ends_early),
    Mutant("jump", "a joint is 0.5 rad off for three rows of the slide", _jumps),
    Mutant("too high", f"the arm is raised by 0.05 rad, {SLOWLY}", _bent(LIFT, -0.05)),
    Mutant("too deep", f"the arm is lowered by 0.05 rad, {SLOWLY}", _bent(LIFT, 0.05)),
    Mutant("aside", f"the arm is turned by 0.05 rad, {SLOWLY}", _bent(TURN, 0.05)),
    Mutant("rolled", f"the wrist is turned by 0.3 rad, {SLOWLY}", _bent(ROLL, 0.3)),
    Mutant("not lifted", "`lift` and `reach` are missing", leave_out("lift", "reach")),
    Mutant("no grasp", "the arm does not go to the grasp; the hand closes before it", _no_grasp),
    Mutant("grasps aside", "the arm turns by 0.1 rad while it grasps and closes", _grasps_aside),
    Mutant("stays open", "the hand does not close", _stays_open),
    Mutant("slippery pad", "friction of the pad is 0.1", _set("hand", "pad_friction", value=0.1)),
    Mutant("rough support", "friction of the support is 2", _set("support", "friction", value=2.0)),
    Mutant("heavy", "the object weighs 2 kg", _set("object", "mass", value=2.0)),
    Mutant("top-heavy", "the centre of mass is near the corner that sticks out", _top_heavy),
    Mutant("elsewhere", "the object starts 30 mm aside", _elsewhere),
    Mutant("obstacle", "a cube of 30 mm stands in the way of the object", _obstacle),
    Mutant(
        "short flexure",
        "the flexure is 100 mm long, not 110",
        _set("hand", "flexure_length", value=0.1),
    ),
    Mutant("other goal", "`X_WO_goal` is 20 mm aside", _other_goal),
    Mutant("weak flexure", "the flexure has a fifth of its stiffness", _weak, WEAK),
    Mutant("every other row", "every other row is missing", _every_other_row, STRAIGHT),
    Mutant("unturned", "`object_poses` of the slide do not turn", _unturned, JUDGED),
    Mutant("overhang", "`overhang` is 20 mm larger than it is", _longer_overhang, JUDGED),
]
