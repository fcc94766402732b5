# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of a resolved task to the planner's types."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from ... import geometry
from ..._core import clasp
from ..blame import blamed
from ..obstacles import build_obstacles
from ..rays import build_rays
from ..robots import build_home, build_robot, given_field, require_srdf
from ..shapes import pose_matrix
from ..source import at
from .hand import Hand, build_hand

if TYPE_CHECKING:
    from ..source import Location, Source
    from . import model


def build(task: model.ClaspTask, source: Source, hand_source: Source) -> clasp.Problem:
    """Returns the problem of a resolved task.

    Parameters
    ----------
    task : ClaspTask
        Resolved.
    source, hand_source : Source
        Sources of the task and of the hand's fields, for error messages.
    """
    robot = build_robot(task.robot, source)
    require_srdf(task.robot, source)
    assert isinstance(task.hand, Hand)
    in_task = hand_source is source
    hand = build_hand(task.hand, robot, hand_source, ("hand",) if in_task else ())
    problem = clasp.Problem(
        robot=robot,
        hand=hand,
        object=build_object(task.object, source),
        X_WO=pose_matrix(task.object.pose),
        q_start=build_home(task.robot, robot, source, others=hand.open),
        obstacles=build_obstacles(task.obstacles, source),
        loops=task.clasp.loops,
        marks=np.array(task.clasp.marks).reshape(-1, 3),
        pull_W=None if task.clasp.pull is None else np.array(task.clasp.pull),
    )
    try:
        clasp.validate(problem)
    except ValueError as error:
        places = _PLACES | {"robot": ("robot", given_field(source))}
        raise blamed(source, str(error), places) from None
    return problem


def build_object(thing: model.Object, source: Source) -> clasp.Object:
    """Returns the object of a resolved task. This searches its loops."""
    given = source.given("object")
    field = next((n for n in ("cloud", "mesh", "sample", "points") if n in given), "points")
    points = np.array(thing.points, dtype=float).reshape(-1, 3)
    options = geometry.LoopOptions(**thing.loops.model_dump(exclude_none=True))
    rays = [build_rays(item, source, ("object", "rays", i)) for i, item in enumerate(thing.rays)]
    try:
        return clasp.Object.from_cloud(thing.name, points, options, rays)
    except ValueError as error:
        named = re.match(r"(?:options\.)?(\w+):? (.*)", str(error), re.DOTALL)
        if named is not None and named[1] in type(thing.loops).model_fields:
            raise source.error(("object", "loops", named[1]), named[2]) from None
        raise source.error(("object", field), str(error).removeprefix("points: ")) from None


_GRAVITY = 9.81  # [m/s^2]
_HEAVIEST = 100.0  # load of the tests of stability, whose forces end at 1000 N [kg]


def build_options(task: model.ClaspTask, source: Source) -> clasp.Options:
    """Returns the options of a task. Missing fields have the defaults of the library, but a hand of
    two fingers must withstand the object's weight, if its mass is given.
    """
    fields = task.options.model_dump(exclude_none=True)
    mass = task.object.mass
    is_jaw = isinstance(task.hand, Hand) and len(task.hand.fingers) == 1
    if mass is not None and is_jaw and "force" not in fields["stability"]:
        if mass > _HEAVIEST:
            what = f"a hand of two fingers is tested with {_HEAVIEST:g} kg at most"
            raise source.error(("object", "mass"), what)
        fields["stability"]["force"] = _GRAVITY * mass
    with at(source, "options", "stability"):
        fields["stability"] = clasp.StabilityOptions(**fields["stability"])
    with at(source, "options", "certificate"):
        fields["certificate"] = clasp.CertificateOptions(**fields["certificate"])
    with at(source, "options"):
        options = clasp.Options(**fields)
        clasp.validate(options)
    return options


# What the core calls a part of a problem, and where it stands in a task file.
_PLACES: dict[str, Location] = {
    "X_WO": ("object", "pose"),
    "loops": ("clasp", "loops"),
    "marks": ("clasp", "marks"),
    "obstacles": ("obstacles",),
    "pull_W": ("clasp", "pull"),
    "q_start": ("robot", "home"),
    "": ("clasp",),
}
