# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of a resolved task to the planner's types."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from ... import frames, geometry
from ..._core import pinch, slide
from ..blame import blamed
from ..obstacles import build_obstacles
from ..robots import build_home, build_robot, given_field, require_srdf
from ..shapes import regular_polygon
from ..source import at, shorten
from . import model
from .resolve import support_pose

if TYPE_CHECKING:
    from collections.abc import Callable

    from ..._core import robot as robots
    from ..source import Location, Source


FARTHEST = 1e4  # of a support from the origin [m], as of all that the core takes
_PLACES: dict[str, Location] = {
    "q_home": ("robot", "home"),
    "X_WO_end": ("end",),
    "obstacles": ("obstacles",),
    "support": ("support",),
    "X_WO_start": ("object", "pose"),
    "": ("object", "pose"),
}

ProblemT = TypeVar("ProblemT", bound=slide.Problem)


def build(
    task: model.OnSupport, source: Source, hand_source: Source, problem_type: type[ProblemT]
) -> ProblemT:
    """Returns the problem of a resolved task.

    Parameters
    ----------
    task : SlideTask or PinchTask
        Resolved.
    source, hand_source : Source
        Sources of the task and of the hand's fields, for error messages.
    problem_type : type
        slide.Problem or pinch.Problem.
    """
    robot = build_robot(task.robot, source)
    require_srdf(task.robot, source)
    if not isinstance(task.hand, model.Hand):
        raise source.error(("hand",), "missing")
    hand = build_hand(task.hand, robot, hand_source, source)
    X_WS = support_pose(task.support)
    pose = task.object.pose
    assert pose is not None
    end = task.end if isinstance(task, model.SlideTask) else None
    problem = problem_type(
        robot,
        hand,
        build_object(task.object, source, thin=problem_type is slide.Problem),
        build_support(task.support, X_WS, source),
        X_WS @ frames.planar(pose.x, pose.y, pose.yaw),
        build_home(task.robot, robot, source, others=hand.open),
        build_obstacles(task.obstacles, source),
        None if end is None else X_WS @ frames.planar(end.x, end.y, end.yaw),
    )
    try:
        (slide if problem_type is slide.Problem else pinch).validate(problem)
    except ValueError as error:
        if str(error).startswith("hand."):
            field = re.split(r"\W", str(error))[1]
            owner, place = _owner(field, hand_source, source)
            raise blamed(owner, str(error), {f"hand.{field}": place, "": place}) from None
        shown = f"X_WO_start {shorten(pose.model_dump())}: "
        message = re.sub(r"^(X_WO_start |(?=object '))", shown, str(error))
        places = _PLACES | {"robot": ("robot", given_field(source))}
        raise blamed(source, message, places) from None
    return problem


def _owner(field: str, source: Source, task: Source | None) -> tuple[Source, Location]:
    """Returns where a field of the hand stands: in the task, or else in its own `source`."""
    if task is not None and (source is task or field in task.given("hand")):
        return task, ("hand", field)
    return source, (field,)


def build_hand(
    fields: model.Hand, robot: robots.Robot, source: Source, task: Source | None = None
) -> slide.Hand:
    """Returns the hand of its fields, which name parts of the robot; some may be in the task."""
    given = fields.model_dump(exclude_none=True)
    if "finger_model" not in given:
        choices = ", ".join(slide.FingerModel.__members__)
        what = f"must be given: how the sliding finger yields (one of: {choices})"
        owner, place = _owner("finger_model", source, task)
        raise owner.error(place, what)
    if given["finger_model"] == "flexure":
        for field in ("flexure_length", "flexure_stiffness"):
            if field not in given:
                owner, (*above, _) = _owner("finger_model", source, task)
                raise owner.error((*above, field), "must be given with finger_model flexure")
    given["finger_model"] = slide.FingerModel.__members__[given["finger_model"]]
    hand = slide.Hand(**given)
    _check_hand(hand, robot, source, task)
    return hand


def _check_hand(hand: slide.Hand, robot: robots.Robot, source: Source, task: Source | None) -> None:
    """Raises TaskError unless the robot has all that the hand names."""
    looked_up: dict[str, Callable[[str], Any]] = {
        "fingertip": robot.frame,
        "grasp_frame": robot.frame,
        "sliding_finger": robot.frame,
        "fingers": robot.frame,
        "open": robot.state,
        "closed": robot.state,
        "arm": robot.group,
    }
    for field, look_up in looked_up.items():
        names, (owner, place) = getattr(hand, field), _owner(field, source, task)
        for name in [names] if isinstance(names, str) else names:
            with at(owner, *place):
                look_up(name)


def build_object(thing: model.Object, source: Source, *, thin: bool) -> slide.Object:
    """Returns the object; with `thin`, an outline that is too high for a slide is refused."""
    location = ("object", _outline_field(thing, source, "object"))
    with at(source, *location):
        if thing.points is not None:
            points = np.array(thing.points, dtype=float).reshape(-1, 3)
            built = slide.Object.from_cloud(thing.name, points, thing.thickness or 0.0)
        else:
            polygon = geometry.Polygon(outline(thing), "the outline")
            given: dict[str, Any] = {"thickness": thing.thickness or 0.0}
            if thing.spacing is not None:
                given["spacing"] = thing.spacing
            built = slide.Object.prism(thing.name, polygon, **given)
            if thin and not built.is_thin:
                with at(source, "object", "thickness"):
                    slide.Object.from_polygon(thing.name, polygon, **given)  # says why
        if thing.heights is not None:
            with at(source, "object", "heights"):
                built = built.with_heights(build_heights(thing.heights))
        if thing.hollow:
            built = built.with_hollow(True)
        if thing.scale != 1:
            built = built.scaled(thing.scale)
    mass = _mass(thing, source)
    if mass is not None:
        with at(source, "object", "mass"):
            built = built.with_mass(mass)
    if thing.com is not None:
        with at(source, "object", "com"):
            com = thing.com if len(thing.com) == 3 else [*thing.com, built.com[2]]
            built = built.with_com(np.array(com, dtype=float))
    if thing.masses is not None:
        with at(source, "object", "masses"):
            points = np.array([part.position for part in thing.masses])
            masses = np.array([part.mass for part in thing.masses])
            built = built.with_com(slide.center_of_mass(points, masses))
    return built


def _mass(thing: model.Object, source: Source) -> float | None:
    """Returns the mass, given or the sum of `masses` [kg]."""
    if thing.masses is None:
        return thing.mass
    total = math.fsum(part.mass for part in thing.masses)
    if thing.mass is not None and not math.isclose(thing.mass, total, rel_tol=1e-3):
        what = f"should be {total:g}, the sum of masses, or left out"
        raise source.error(("object", "mass"), what)
    return total if thing.mass is None else thing.mass


def build_heights(heights: model.Heights) -> geometry.HeightMap:
    rows, below = heights.rows, heights.undersides
    undersides = None if below is None else np.array(below, dtype=float)
    return geometry.HeightMap(heights.corner, heights.cell, np.array(rows, dtype=float), undersides)


def build_support(support: model.Support, X_WS: frames.Matrix, source: Source) -> slide.Support:
    if np.abs(X_WS[:3, 3]).max() > FARTHEST:
        field = support.first_of("pose", "height")
        raise source.error(("support", field), f"must be within {FARTHEST:g} m of the origin")
    given = support.model_dump(include={"slab", "band_width", "friction"}, exclude_none=True)
    with at(source, "support", _outline_field(support, source, "support")):
        corners = outline(support)
        polygon = geometry.Polygon(corners, "the support")
    if support.usable_edges is not None:
        given["usable_edges"] = _edges_of(polygon, corners, support.usable_edges)
    with at(source, "support"):
        return slide.Support(polygon, X_WS, **given)


def _edges_of(polygon: geometry.Polygon, corners: frames.Matrix, edges: list[int]) -> list[int]:
    """Returns the indices that edges of a file have in the polygon, which may run the other way."""
    if np.array_equal(polygon.vertices[0], corners[0]):
        return edges
    count = len(corners)
    return [(count - 2 - edge) % count if edge < count else edge for edge in edges]


def outline(shape: model.Object | model.Support) -> frames.Matrix:
    """[N, 2] vertices of the polygon, rectangle or circle that is given."""
    if shape.polygon is not None:
        return np.array(shape.polygon, dtype=float)
    if shape.rectangle is not None:
        corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) / 2
        return np.array(corners * shape.rectangle.size + shape.rectangle.center)
    assert shape.circle is not None
    ring = regular_polygon(shape.circle.radius, shape.circle.points)
    return np.asarray(ring + np.array(shape.circle.center))


def build_options(task: model.SlideTask, problem: slide.Problem, source: Source) -> slide.Options:
    """Returns the options of a task. Missing fields have the defaults of the library."""
    fields = task.options.model_dump(exclude_none=True)
    if "search" in fields:
        fields["search"] = slide.Search.__members__[fields["search"]]
    with at(source, "options"):
        options = slide.Options(**fields)
        slide.validate(options)
    try:
        slide.validate(problem, options)
    except ValueError as error:
        section = str(error).partition(".")[0]
        with at(source, section if section in ("hand", "support") else "options"):
            raise
    return options


def _outline_field(shape: Any, source: Source, section: str) -> str:
    names = ("polygon", "rectangle", "circle", "cloud", "points")
    given = source.given(section)
    return next((name for name in names if name in given), names[0])
