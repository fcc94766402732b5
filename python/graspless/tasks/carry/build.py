# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Conversion of a resolved task to the planner's types."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ... import collision, frames, geometry
from ..._core import carry
from ..blame import blamed
from ..clasp.build import build_object as build_clasp_object
from ..obstacles import build_obstacles, placed_parts
from ..robots import build_home, build_robot, require_srdf
from ..shapes import pose_matrix
from ..slide.build import build_object as build_slide_object
from ..slide.build import build_support
from ..slide.resolve import support_pose
from ..source import Source, at

if TYPE_CHECKING:
    from ...frames import Matrix
    from ..source import Location
    from . import model

SUPPORT = "support"
FARTHEST = 0.03  # of an object from the hand that holds it [m]
UP = np.array([0.0, 0.0, 1.0])


def build(task: model.CarryTask, source: Source) -> carry.Problem:
    """Returns the problem of a resolved task. Error messages name the place in `source`."""
    for field in ("robot", "frame", "object", "pose"):
        if getattr(task, field) is None:
            raise source.error((field,), "missing")
    given: Any = task  # all of it is there now
    robot = build_robot(given.robot, source)
    require_srdf(given.robot, source)
    with at(source, "arm"):
        robot.group(task.arm)
    with at(source, "frame"):
        robot.frame(given.frame)
    X_WO = pose_matrix(given.pose)
    obstacles = build_obstacles(task.obstacles or [], source)
    rests = dict.fromkeys(task.rests_on, UP)
    if task.support is not None:
        obstacles.append(_support(task.support, source))
        rests[SUPPORT] = support_pose(task.support)[:3, 2]
    shapes = object_shapes(given.object, source)
    problem = carry.Problem(
        robot=robot,
        arm=task.arm,
        frame=given.frame,
        object=collision.Obstacle(given.object.name, shapes, X_WO),
        X_WO_goal=None if task.place is not None else goal(task, X_WO),
        q_start=build_home(given.robot, robot, source),
        obstacles=obstacles,
        rests_on=rests,
        places=None if task.place is None else places(task, source),
        X_WO_hanging=None if task.hanging is None else pose_matrix(task.hanging),
    )
    try:
        carry.validate(problem)
    except ValueError as error:
        raise blamed(source, str(error), _places(task)) from None
    _warn_of_distance(problem, source)
    return problem


def _warn_of_distance(problem: carry.Problem, source: Source) -> None:
    """Warns of an object that nothing in the hand can hold."""
    X_WF = np.asarray(problem.robot.pose(problem.frame, problem.q_start))
    point = geometry.PlacedShape(geometry.Sphere(1e-6), X_WF)
    distance = _distance(problem.object, {problem.frame: [point]})
    if distance <= FARTHEST:  # quicker than all shapes of the hand
        return
    distance = min(distance, _distance(problem.object, _hand(problem)))
    if distance > FARTHEST:
        what = f"the object is at least {distance:.2g} m away from '{problem.frame}' and the links"
        advice = "nothing there holds it; check pose and robot.home"
        source.warn(("pose",), f"{what} that move with it: {advice}")


def _hand(problem: carry.Problem) -> dict[str, list[geometry.PlacedShape]]:
    """Returns the shapes, in W, of each link that keeps its pose relative to the frame."""
    robot = problem.robot
    q = np.array(problem.q_start)
    poses = [np.asarray(robot.forward(q))]
    arm = robot.group(problem.arm)
    q[arm] += 0.1 + 0.013 * np.arange(len(arm))  # any values that differ between joints
    poses.append(np.asarray(robot.forward(q)))
    frame = robot.frame(problem.frame)
    now, then = (np.linalg.inv(X[frame]) @ X for X in poses)
    moves_along = np.abs(now - then).max(axis=(1, 2)) < 1e-9
    shapes: dict[str, list[geometry.PlacedShape]] = {}
    for link, placed in robot.shapes:
        if moves_along[link]:
            at_W = geometry.PlacedShape(placed.shape, poses[0][link] @ np.asarray(placed.X_BG))
            shapes.setdefault(robot.frame_names[link], []).append(at_W)
    return shapes


def _distance(thing: collision.Obstacle, bodies: dict[str, list[geometry.PlacedShape]]) -> float:
    """Lower bound on the distance of an object from bodies in W; infinite without bodies [m]."""
    world = collision.World()
    held = world.add_body("object", thing.shapes)
    world.set_pose(held, thing.X_WB)
    for name, shapes in bodies.items():
        world.add_pair(held, world.add_body(f"link {name}", shapes))
    return min(world.distance_bounds(), default=np.inf)


def goal(task: model.CarryTask, X_WO: Matrix) -> Matrix:
    """[4, 4] X_WO at the end."""
    if task.goal is not None:
        return pose_matrix(task.goal)
    if task.offset is not None:
        return frames.translation(task.offset) @ X_WO
    assert task.line is not None  # the model has seen to it
    direction = np.array(task.line.direction) / np.linalg.norm(task.line.direction)
    return frames.translation(task.line.distance * direction) @ X_WO


def places(task: model.CarryTask, source: Source) -> carry.Places:
    """Returns the places where the object may be put down."""
    given = task.place
    assert given is not None
    if task.open is None:
        raise source.error(("open",), "missing: the joints of the open hand")
    poses = np.stack([pose_matrix(pose) for pose in given.poses])
    normal = np.array(given.normal) / np.linalg.norm(given.normal)
    way_out = [np.array(q) for q in task.way_out or []]
    down = np.zeros(3) if task.down is None else np.array(task.down)
    return carry.Places(poses, given.on, np.array(task.open), normal, way_out, down)


def object_shapes(thing: model.Object, source: Source) -> list[geometry.PlacedShape]:
    """Returns the shapes of the held object, in O."""
    if thing.box is not None:
        with at(source, "object", "box"):
            return [geometry.PlacedShape(geometry.Box(np.array(thing.box)), np.eye(4))]
    if thing.parts is not None:
        with at(source, "object", "parts"):
            return placed_parts(thing.parts)
    field = "slide" if thing.slide is not None else "clasp"
    given = source.data.get("object", {})
    inner = given.get(field, {}) if isinstance(given, dict) else {}
    below = Source(source.file, {"object": inner})
    if thing.slide is not None:
        return list(build_slide_object(thing.slide, below, thin=False).shapes)
    assert thing.clasp is not None
    surface = build_clasp_object(thing.clasp, below).surface
    return [geometry.PlacedShape(surface, np.eye(4))]


def build_options(task: model.CarryTask, source: Source) -> carry.Options:
    """Returns the options of a task. Missing fields have the defaults of the library."""
    with at(source, "options"):
        options = carry.Options(**task.options.model_dump(exclude_none=True))
        carry.validate(options)
    return options


def _support(support: Any, source: Source) -> collision.Obstacle:
    built = build_support(support, support_pose(support), source)
    return collision.Obstacle(SUPPORT, list(built.shapes), np.asarray(built.X_WS))


def _places(task: model.CarryTask) -> dict[str, Location]:
    """Returns the field of the task file for each part of a problem of the core."""
    way = task.first_of("line", "offset", "goal", "place")
    return {
        "X_WO_goal": (way,),
        "X_WO_hanging": ("hanging",),
        "object": ("object",),
        "object.X_WB": ("pose",),
        "obstacles": ("obstacles",),
        f"obstacles[{len(task.obstacles or [])}]": ("support",),
        "places.X_WO": ("place", "poses"),
        "places.on": ("place", "on"),
        "places.q_open": ("open",),
        "places.way_out": ("way_out",),
        "places.down_O": ("down",),
        "q_start": ("robot", "home"),
        **{f"rests_on[{i}]": ("rests_on",) for i in range(len(task.rests_on) + 1)},  # in any order
        "": ("frame",),
    }
