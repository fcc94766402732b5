# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ways down for an object with a finger below it: over an edge, and from there in by a slide.

The hand cannot open below an object that lies flat. It puts it down as it was grasped, over a real
edge of the support, and leaves. If the object belongs elsewhere, a finger then presses on it from
above and slides it there.
"""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import frames
from ..tasks import scenes
from . import place as places
from .obstacles import documents
from .wish import support_fields

if TYPE_CHECKING:
    from .. import geometry
    from ..frames import Matrix
    from .place import Target

ALONG = 0.03  # of places along an edge [m]
MOST_EDGES = 3  # that are tried, the nearest first, and the one over which it was grasped
MOST_FREE = 32  # poses at the place, of which slides take those that turn the object least
MOST_ENDS = 4  # of slides from an edge

Way = tuple[dict[str, Any], list[dict[str, Any]]]


def ways_down(target: Target, grasp: Any, lift: Any, slid: dict[str, Any]) -> list[Way] | str:
    """Returns ways to put down what a chain has grasped and lifted, in order, or a reason.

    A way is the stage that puts the object down, and stages of which one slides it to its place; it
    is there already if these are none.

    Parameters
    ----------
    target : Target
    grasp, lift : plans of these stages
    slid : dict
        Fields of the stage that grasped it.
    """
    if grasp.kind != "slide":
        stage = places.stage_of(target, grasp, lift)
        return stage if isinstance(stage, str) else [(stage, [])]
    edges = _along_edges(target, grasp)
    ways: list[Way] = []
    if target.place.pose is None:
        there = [X for poses in edges for X in poses if not target.fault(X)[1]]
    else:
        there = [X for X in target.asked() if _is_over_edge(target, X) and _stays(target, X)]
    if there:
        ways.append((places.put_down(target, there[: places.MOST], "slide"), []))
    ends = target.spread() if target.place.pose is None else iter(target.asked())
    free = list(itertools.islice((X for X in ends if not target.fault(X)[1]), MOST_FREE))
    for poses in edges if free else []:
        put = places.put_down(target, poses[: places.MOST], "slide")
        ordered = _least_turned(free, poses)[:MOST_ENDS]
        spreads = dict.fromkeys([slid["options"]["pad_spread"], 0.0])
        slides = [_slide_in(target, slid, X_SO, part) for part in spreads for X_SO in ordered]
        ways.append((put, slides))
    if ways:
        return ways
    return (
        f"a finger is below the object: it must lie over a real edge of {target.support.name}, "
        "as it was grasped, and no such place is free"
    )


def _along_edges(target: Target, grasp: Any) -> list[list[Matrix]]:
    """Returns free poses X_SO over real edges, the nearest edge and the nearest pose first.

    The edge over which the object was grasped is among them: the arm reaches it.
    """
    near = target.middle if target.place.pose is None else target.asked()[0][:2, 3]
    X_EO, grasped = _at_edge(grasp), target.polygon.nearest_edge(_hand_in(target, grasp))

    def away(X_SO: Matrix) -> float:
        return float(np.linalg.norm(X_SO[:2, 3] - near))

    found = []
    for i, label in enumerate(target.support.edges):
        if str(label) != "real":
            continue
        edge = target.polygon.edge(i)
        a, b = np.asarray(edge.a), np.asarray(edge.b)
        count = max(1, int(float(np.linalg.norm(b - a)) / ALONG)) + 2
        poses = [edge_frame(edge, a + t * (b - a)) @ X_EO for t in np.linspace(0, 1, count)[1:-1]]
        free = [X_SO for X_SO in poses if _stays(target, X_SO)]
        is_own = target.is_same and i == grasped.index
        if free:
            found.append((is_own, sorted(free, key=away)))
    found.sort(key=lambda one: away(one[1][0]))
    return [poses for k, (is_own, poses) in enumerate(found) if k < MOST_EDGES or is_own]


def _is_over_edge(target: Target, X_SO: Matrix) -> bool:
    """Returns True if the object sticks out over a real edge at a pose, and over no other."""
    ring = target.ring @ X_SO[:2, :2].T + X_SO[:2, 3]
    out = [p for p in ring if float(target.polygon.depth(p)) < 0]
    edges = {target.polygon.nearest_edge(p).index for p in out}
    return bool(edges) and all(str(target.support.edges[i]) == "real" for i in edges)


def _stays(target: Target, X_SO: Matrix) -> bool:
    """Returns True if a place is free, and the object does not tip over the edge there."""
    com: Matrix = X_SO[:2, :2] @ np.asarray(target.wish.com[:2]) + X_SO[:2, 3]
    is_free = not target.fault(X_SO, in_region=False)[1]
    return is_free and float(target.polygon.depth(com)) >= places.MARGIN


def _least_turned(ends: list[Matrix], poses: list[Matrix]) -> list[Matrix]:
    """Returns the ends of a slide from the first of some poses, those that turn it least first."""
    return sorted(ends, key=lambda X_SO: -float(np.trace(poses[0][:2, :2].T @ X_SO[:2, :2])))


def _slide_in(target: Target, slid: dict[str, Any], X_SO: Matrix, spread: float) -> dict[str, Any]:
    """Returns the stage that slides the object from an edge to a pose, and leaves it there.

    `spread` is the part of the pad that need not bear.
    """
    wish, obstacles = target.wish, slid["obstacles"]
    if not target.is_same:
        others = [one for one in obstacles if one["name"] != target.obstacle]
        obstacles = [*others, *documents([scenes.slab(wish.support)])]
    return {
        "name": "slide_in",
        "kind": "slide",
        "object": {key: value for key, value in slid["object"].items() if key != "pose"},
        "support": support_fields(target.support, None),
        "obstacles": obstacles,
        "end": scenes.planar_pose(np.eye(4), X_SO),
        "options": {"pad_spread": spread},
    }


def edge_frame(edge: geometry.Edge, p: Matrix) -> Matrix:
    """[4, 4] pose in S of a frame on an edge: x along it, y into the polygon, at p."""
    inward = np.asarray(edge.inward)
    return frames.planar(float(p[0]), float(p[1]), float(np.arctan2(-inward[0], inward[1])))


def _hand(slide: Any) -> Matrix:
    """[4, 4] pose X_WH of the hand that has grasped."""
    problem = slide.task.problem
    X_WH: Matrix = problem.robot.pose(problem.hand.grasp_frame, slide.segments[-1].positions[-1])
    return X_WH


def _hand_in(target: Target, slide: Any) -> Matrix:
    """[2] position of that hand in the support of the place [m]."""
    p_S: Matrix = (np.linalg.inv(target.support.X_WS) @ _hand(slide))[:2, 3]
    return p_S


def _at_edge(slide: Any) -> Matrix:
    """[4, 4] X_EO of the object at the edge over which a slide grasps it, by the hand."""
    problem = slide.task.problem
    X_SW = np.linalg.inv(problem.support.X_WS)
    X_SO = X_SW @ slide.segments[-1].object_poses[-1]
    edge = problem.support.polygon.nearest_edge((X_SW @ _hand(slide))[:2, 3])
    a, b = np.asarray(edge.a), np.asarray(edge.b)
    along = (b - a) / np.linalg.norm(b - a)
    foot = a + along * float((X_SO[:2, 3] - a) @ along)
    return np.asarray(np.linalg.inv(edge_frame(edge, foot)) @ X_SO)
