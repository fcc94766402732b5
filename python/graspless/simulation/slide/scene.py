# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""World of a slide in MuJoCo: robot, table, obstacles, object.

The object stands on feet, small spheres spread evenly over its underside: faces that lie on each
other would touch in their corners only, and resist turning twice as much as an even pressure.
The table's edge has a row of spheres of its own, on which the object tips.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames, geometry
from ..obstacles import OBSTACLE, numbered
from ..parts import slice_links
from ..robots import apply, compiled, placed_body, robot_spec
from ..settings import Slide, Solver
from ..shapes import add_hull, add_placed, give_inertia
from .fingers import OTHER, PAD, SLIDING, Bits, add_fingers, whole_fingers
from .shapes import add_prism, even_points, plate_inertia, points_along
from .truth import Body, Truth

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ... import slide
    from ...frames import Matrix
    from ...slide import Plan
    from ..variation import Variation

OBJECT, TABLE, NEIGHBOUR = "object", "table", "neighbour"
FOOT, EDGE, HAND = "foot", "edge", "hand"
COLUMN_STEP = 5e-4  # by which columns are higher than heights at most: a finger presses on them [m]

# Collision bits. Feet, edge and pad touch in explicit pairs with their own friction.
_ROBOT, _TABLE, _OBSTACLE, _OBJECT, _FINGER, _GRASP, _NEIGHBOUR = 1, 2, 4, 8, 16, 32, 64
FINGER_SLIDES = Bits(_FINGER, _ROBOT)
FINGER_GRASPS = Bits(_FINGER | _GRASP, _ROBOT)
_BITS = {
    TABLE: Bits(_TABLE, _ROBOT | _GRASP),
    OBSTACLE: Bits(_OBSTACLE, _ROBOT | _FINGER),
    OBJECT: Bits(_OBJECT, _ROBOT | _OBSTACLE | _GRASP),
    NEIGHBOUR: Bits(_NEIGHBOUR, _ROBOT | _FINGER | _OBJECT | _NEIGHBOUR),
}


@dataclass(frozen=True)
class Scene:
    """A model, and the indices of its parts."""

    model: Any
    X_WO: Matrix  # initial pose of the object
    groups: dict[str, Any]  # indices of geoms by role


def build_scene(
    plan: Plan,
    variation: Variation,
    settings: Slide | None = None,
    obstacles: Sequence[Any] | None = None,
    truth: Truth | None = None,
    standing: str | None = None,
    later: Plan | None = None,
) -> Scene:
    """Makes the varied model of the task of a plan.

    `obstacles` replace those of the task, and `truth` its object and them, except the obstacle
    `standing`, which the object may touch as it touches the table. `later` is another slide of it.
    """
    settings = settings or Slide()
    problem = plan.task.problem
    spec = robot_spec(problem.robot, plan.task.fields.robot)
    slice_links(spec, problem.robot, whole=whole_fingers(problem.robot, problem.hand))
    solver = dataclasses.replace(Solver(), impratio=settings.impratio)
    apply(spec, solver)
    spec.option.timestep = solver.timestep * variation.timestep
    hand = varied_hand(problem, variation)
    add_fingers(spec, problem.robot, hand, settings, {SLIDING: FINGER_SLIDES, OTHER: FINGER_GRASPS})
    X_WO = varied_start(problem, variation)
    _add_table(spec, plan, variation.table, settings, later)
    for i, obstacle in enumerate(problem.obstacles if obstacles is None else obstacles):
        what = TABLE if obstacle.name == standing else OBSTACLE
        if truth is None or what == TABLE:
            _add_obstacle(spec, obstacle, numbered(obstacle, i, what), what)
    if truth is None:
        _add_object(spec, problem.object, X_WO, variation, settings)
    else:
        _add_truth(spec, truth, X_WO, variation)
    _add_pairs(spec, problem, settings, variation)
    for geom in spec.geoms:
        if geom.priority == 1:
            geom.friction = [variation.friction * geom.friction[0], *geom.friction[1:]]
    model = compiled(spec)
    return Scene(model, X_WO, _groups(model, problem.hand))


def varied_start(problem: Any, variation: Variation) -> Matrix:
    """Returns X_WO, shifted with and on the support, and turned about the origin of O."""
    X_WS = np.array(problem.support.X_WS)
    X_SO = np.linalg.inv(X_WS) @ problem.X_WO_start
    moved = frames.translation([variation.x, variation.y, variation.table])
    X_WO: Matrix = X_WS @ moved @ X_SO @ frames.planar(0.0, 0.0, variation.yaw)
    return X_WO


def varied_hand(problem: Any, variation: Variation) -> slide.Hand:
    """Returns the hand with other flexures."""
    hand: slide.Hand = problem.hand  # a copy
    hand.flexure_length *= variation.flexure_length
    hand.flexure_stiffness *= variation.flexure_stiffness
    return hand


def _add_table(spec: Any, plan: Plan, height: float, settings: Slide, later: Plan | None) -> None:
    support = plan.task.problem.support
    body = placed_body(spec, TABLE, support.X_WS @ frames.translation([0.0, 0.0, height]))
    for i, part in enumerate(support.polygon.convex_parts()):
        _mark(add_prism(spec, body, part, (-support.slab, 0.0), name=f"{TABLE}{i}"), TABLE)
    for i, p in enumerate(_edge_points(plan, settings, later)):
        _add_foot(body, f"{EDGE}{i}", [*p, -settings.foot_radius], settings)


def _edge_points(plan: Plan, settings: Slide, later: Plan | None) -> Matrix:
    """Returns points [N, 2] in S along the outline of the table, where the object may come."""
    problem = plan.task.problem
    points = points_along(problem.support.polygon, settings.rim_spacing)
    reach = np.linalg.norm(np.array(problem.object.outline.vertices), axis=1).max() + 0.02
    X_SW = np.linalg.inv(problem.support.X_WS)
    segments = [*plan.segments, *([] if later is None else later.segments)]
    poses = np.concatenate([segment.object_poses for segment in segments])
    centers = np.unique(frames.transform(X_SW, poses[:, :3, 3])[:, :2].round(3), axis=0)
    nearest = np.linalg.norm(points[:, None] - centers[None], axis=2).min(axis=1)
    near: Matrix = points[nearest < reach]
    return near


def _add_obstacle(spec: Any, obstacle: Any, name: str, what: str) -> None:
    body = placed_body(spec, name, obstacle.X_WB)
    for i, placed in enumerate(obstacle.shapes):
        _mark(add_placed(spec, body, placed, name=f"{name} {i}"), what)


def _add_object(spec: Any, thing: Any, X_WO: Matrix, variation: Variation, settings: Slide) -> None:
    mass = float(thing.mass) * variation.mass
    thickness = float(thing.thickness) * variation.thickness
    com = thing.com * [1, 1, variation.thickness] + [variation.com_x, variation.com_y, 0]
    body = placed_body(spec, OBJECT, X_WO)
    give_inertia(body, mass, com, plate_inertia(thing.outline, thickness, mass))
    body.add_freejoint(name=OBJECT)
    if thing.heights is None:
        for i, part in enumerate(thing.outline.convex_parts()):
            _mark(add_prism(spec, body, part, (0.0, thickness), name=f"{OBJECT}{i}"), OBJECT)
    else:
        for i, placed in enumerate(geometry.columns(thing.heights, COLUMN_STEP)):
            column = _stretched(placed, variation.thickness)
            _mark(add_placed(spec, body, column, name=f"{OBJECT}{i}"), OBJECT)
    r = settings.foot_radius
    for i, p in enumerate(even_points(thing.outline, settings.feet)):
        _add_foot(body, f"{FOOT}{i}", [*p, r], settings)
    for i, p in enumerate(points_along(thing.outline, settings.rim_spacing)):
        _add_foot(body, f"{FOOT} of rim {i}", [*p, r + settings.rim_rise], settings)


def _stretched(placed: Any, factor: float) -> geometry.PlacedShape:
    """Returns a box of the heights of an object, higher by a factor."""
    scale = np.array([1.0, 1.0, factor])
    p_OG = scale * np.asarray(placed.X_BG)[:3, 3]
    return geometry.PlacedShape(geometry.Box(scale * placed.shape.size), frames.translation(p_OG))


def _add_truth(spec: Any, truth: Truth, X_WO: Matrix, variation: Variation) -> None:
    com = truth.object.com + np.array([variation.com_x, variation.com_y, 0.0])
    mass, inertia = truth.object.mass * variation.mass, truth.object.inertia * variation.mass
    _add_body(spec, Body(truth.object.parts, mass, com, inertia), X_WO, OBJECT, OBJECT)
    up = frames.translation([0.0, 0.0, variation.table])
    for i, other in enumerate(truth.others):
        X_WB = up @ frames.translation(other.com)
        own = other.moved(frames.translation(-other.com))
        _add_body(spec, own, X_WB, f"{NEIGHBOUR} {i}", NEIGHBOUR)


def _add_body(spec: Any, given: Body, X_WB: Matrix, name: str, what: str) -> None:
    body = placed_body(spec, name, X_WB)
    give_inertia(body, given.mass, given.com, given.inertia)
    body.add_freejoint(name=name)
    for i, points in enumerate(given.parts):
        _mark(add_hull(spec, body, points, {"name": f"{name} {i}"}), what)


def _add_foot(body: Any, name: str, place: list[float], settings: Slide) -> None:
    size = [settings.foot_radius, 0, 0]
    body.add_geom(
        name=name, type=mujoco.mjtGeom.mjGEOM_SPHERE, size=size, pos=place, contype=0, conaffinity=0
    )


def _mark(geom: Any, what: str) -> None:
    geom.contype, geom.conaffinity = _BITS[what].contype, _BITS[what].conaffinity


def _add_pairs(spec: Any, problem: Any, settings: Slide, variation: Variation) -> None:
    """Adds the sliding contact pairs, each with its friction."""
    names = [geom.name for geom in spec.geoms]
    of = {what: [n for n in names if n.startswith(what)] for what in (FOOT, EDGE, PAD, TABLE)}
    parts = [n for n in names if n.startswith(OBJECT)]
    others = [n for n in names if n.startswith(NEIGHBOUR)]
    table = {
        "friction": _coulomb(problem.support.friction * variation.support_friction),
        "solref": [settings.table_solref, 1.0],
        "solreffriction": [settings.table_slip, 1.0],
        "solimp": [*settings.table_solimp, 0.5, 2.0],
    }
    tip = {
        "friction": _coulomb(problem.hand.pad_friction * variation.friction),
        "solref": [settings.tip_solref, 1.0],
    }
    for one, other, given in (
        (of[FOOT], of[TABLE], table),
        (of[EDGE], parts, table),
        (of[PAD], parts, tip),
        (of[PAD], of[TABLE], tip),
        ([] if of[FOOT] else parts, of[TABLE], table),
        (others, of[TABLE], table),
    ):
        for a in one:
            for b in other:
                spec.add_pair(geomname1=a, geomname2=b, condim=3, **given)


def _coulomb(friction: float) -> list[float]:
    return [friction, friction, 0.0, 0.0, 0.0]


def _groups(model: Any, hand: slide.Hand) -> dict[str, Any]:
    """Returns the indices of geoms by role.

    All links of a finger belong to it. The rest of the hand is the palm and what else it carries.
    """
    names = [model.geom(i).name for i in range(model.ngeom)]
    bodies = [model.body(model.geom_bodyid[i]).name for i in range(model.ngeom)]
    groups = {
        what: np.array([i for i, name in enumerate(names) if name.startswith(what)], dtype=int)
        for what in (OBJECT, TABLE, OBSTACLE, NEIGHBOUR, FOOT, EDGE, PAD)
    }
    others = set(hand.fingers) - set(hand.sliding_finger)
    rest = _links_of_hand(model, hand) - {*hand.fingers, SLIDING, OTHER}
    groups[HAND] = np.array([i for i, body in enumerate(bodies) if body in rest], dtype=int)
    for what, links in ((SLIDING, {SLIDING, *hand.sliding_finger}), (OTHER, {OTHER, *others})):
        own = [i for i, body in enumerate(bodies) if body in links and model.geom_contype[i]]
        groups[what] = np.array(own, dtype=int)
    return groups


def _links_of_hand(model: Any, hand: slide.Hand) -> set[str]:
    """Returns the nearest link that carries all fingers, and all links that it carries.

    Nothing if that is the world.
    """
    above = [_chain(model, model.body(name).id) for name in hand.fingers]
    palm = next(i for i in above[0] if all(i in other for other in above))
    if palm == 0:
        return set()
    return {model.body(i).name for i in range(model.nbody) if palm in _chain(model, i)}


def _chain(model: Any, body: int) -> list[int]:
    """Returns a body and those that carry it, up to the world."""
    found = [body]
    while found[-1] != 0:
        found.append(int(model.body_parentid[found[-1]]))
    return found
