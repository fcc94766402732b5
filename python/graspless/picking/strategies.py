# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Strategies: what rules each out at first sight, and the chain that carries it out."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .._api import plan_since
from ..errors import TaskError, should_be
from .hidden import covered, cut_off, sliver
from .measured import top_share, unseen_share
from .wish import cloud_fields, distance_to, heights_fields, object_fields, support_fields

if TYPE_CHECKING:
    from collections.abc import Callable

    from .. import planning
    from ..frames import Matrix
    from .wish import Wish

STRATEGIES = ("pinch", "rim", "slide", "clasp", "tumble", "push")
KINDS = {"rim": "pinch"}  # of the stages of strategies that are not named after theirs
TWIST = 0.5  # of the object about the vertical while it is lifted [rad]
THIN = 0.75  # largest height of what is slid, in its widths
FLAT = 0.9  # part of an object that is as high as its top if it is flat
LEAST_SECONDS = 1e-3


def require_strategies(strategies: Iterable[str]) -> list[str]:
    """Returns the strategies. Raises TaskError unless all are known and each is named once."""
    if not isinstance(strategies, Iterable):
        raise TaskError(f"strategies: {strategies!r}: should be a list of names")
    asked = [strategies] if isinstance(strategies, str) else list(strategies)
    for name in asked:
        if name not in STRATEGIES:
            raise TaskError(f"strategies: {name}: {should_be(name, STRATEGIES)}")
    if not asked or len(set(asked)) < len(asked):
        raise TaskError(f"strategies: {', '.join(asked) or 'none'}: should name each once")
    return asked


@dataclass(frozen=True)
class Way:
    """A way to ask for a strategy.

    Attributes
    ----------
    smooth : float
        Distance by which corners of a noisy outline may be off those that are left [m].
    overhang : float or None
        Least overhang of a slide, if not that of the planner [m].
    iterations : int or None
        Limit of the search.
    cell : float
        Side of the cells if the object is as high as the cameras measured; 0 for a prism [m].
    uneven : float
        Part of the pad's length that may not bear.
    pads : float or None
        Distance of a pinch's contacts from the ends of the pads, and half of their length, if not
        those of the planner [m]. They are as low as possible then. Tried where the others were
        too high.
    opening : float or None
        Opening with which a hand comes to a pinch, as a part of that of the open hand. Tried where
        the open hand had no room.
    hangs : bool
        Clasp handles where the object hangs straightest below the hand.
    """

    smooth: float = 0.0
    overhang: float | None = None
    iterations: int | None = None
    cell: float = 0.0
    uneven: float = 0.0
    pads: float | None = None
    opening: float | None = None
    hangs: bool = False


# The next way is tried if one finds no plan that holds. Faces of small objects come out best by one
# outline or the other. The farther a slide goes, the nearer the hand grips to the centre of mass,
# and the less the weight turns the object in it: 0.2 kg are lost 2 cm from the object's edge.
FAR = 0.025  # largest distance of the middle of the narrowest width from the edge, at first [m]
NEAR_EDGE = 0.035  # least overhang after that [m]
UNEVEN = 0.7  # part of the pad that does not bear: objects are not as flat as their outlines say
SMOOTH = 0.0015
LESS = (0.5, 0.25)  # of the opening of the hand
FINE, COARSE = 0.0025, 0.005  # pixels are about 2 mm apart; boxes of coarse heights are fewer [m]
LOW, PAD_ENDS = 0.03, 0.003  # what is so low is pinched with the ends of the pads, too [m]
WAYS = {
    "pinch": [Way(SMOOTH), Way(), *(Way(SMOOTH, opening=part) for part in LESS)],
    "rim": [Way(cell=FINE), *(Way(cell=FINE, opening=part) for part in LESS)],
    "slide": [
        Way(SMOOTH, NEAR_EDGE, 800, uneven=UNEVEN),
        Way(SMOOTH, NEAR_EDGE, 800),
        Way(SMOOTH),
    ],
    "clasp": [Way()],
}


def ways_of(strategy: str, wish: Wish, puts: bool) -> list[Way]:
    """Returns the ways to ask for a strategy; `puts` if the object is put down at the end.

    Only what is flat on top is slid as a prism.
    """
    ways = WAYS[strategy]
    if strategy == "pinch" and float(wish.thing.thickness) < LOW:
        ways = [*ways, replace(ways[0], pads=PAD_ENDS)]
    if strategy == "rim":
        ways = [*ways, replace(ways[0], pads=PAD_ENDS)]
    if strategy == "clasp" and puts:
        ways = [Way(hangs=True), *ways]
    if strategy != "slide":
        return ways
    far = _narrowest(np.asarray(wish.thing.outline)) / 2 - FAR
    if far > NEAR_EDGE:
        ways = [replace(ways[0], overhang=far), *ways]
    is_flat = top_share(wish) >= FLAT
    return [way if is_flat else replace(way, cell=COARSE) for way in ways]


def chain_of(
    strategy: str,
    wish: Wish,
    seed: int,
    seconds: float,
    way: Way | None = None,
    opening: float | None = None,
) -> dict[str, Any]:
    """Returns the task of a strategy: grasp the object, and lift it.

    `opening` is that of the hand, which ways that open it less need [m].
    """
    way = way or WAYS[strategy][-1]
    lift = {
        "name": "lift",
        "kind": "carry",
        "line": {"direction": [0, 0, 1], "distance": wish.lift},
        "options": {"max_twist": TWIST},
    }
    kind = KINDS.get(strategy, strategy)
    grasp = {"name": strategy, "kind": kind, **_FIELDS[strategy](wish)}
    if way.smooth > 0:
        grasp["object"] = {**grasp["object"], **object_fields(wish, way.smooth)}
    if way.cell > 0:
        grasp["object"] = {**grasp["object"], "heights": heights_fields(wish, way.cell)}
    if kind == "pinch":
        force = {} if wish.grip_force is None else {"grip_force": wish.grip_force}
        pads = {} if way.pads is None else {"depth": way.pads, "patch": way.pads, "height": 0.0}
        less = {} if way.opening is None or opening is None else {"opening": way.opening * opening}
        grasp["options"] = force | pads | less
    if way.hangs:
        grasp["clasp"] = {"pull": [0.0, 0.0, 1.0]}
    if strategy == "slide":
        overhang = {} if way.overhang is None else {"min_overhang": way.overhang}
        grasp["options"] = {"pad_spread": way.uneven, "deep_grasp": True, **overhang}
    return {
        "kind": "chain",
        "robot": wish.robot,
        "stages": [grasp, lift],
        "budget": {"seconds": max(seconds, LEAST_SECONDS), "seed": seed},
    }


def searched(task: Any, began: float, budget: planning.Budget) -> Any:
    """Plans a task within its own limits since `began`; stop() of `budget` ends the search."""
    own = task.budget
    part = budget.part(seconds=own.seconds, seed=own.seed, iterations=own.iterations)
    return plan_since(task, began, part)


def refusal(strategy: str, wish: Wish, opening: float | None) -> str:
    """Returns why lengths rule a strategy out, in one sentence, or an empty text.

    `opening` is that of the hand, as far as another strategy knows it [m].
    """
    height = float(wish.thing.thickness)
    if strategy == "slide" and opening is not None and height > opening:
        return f"{1000 * height:.0f} mm high, the hand opens {1000 * opening:.0f} mm at the edge"
    return covered(wish) or _REFUSALS[strategy](wish)


def _pinch(wish: Wish) -> dict[str, Any]:
    return {
        "object": object_fields(wish),
        "support": support_fields(wish.support, None),
        "obstacles": wish.beside,
    }


def _slide(wish: Wish) -> dict[str, Any]:
    """Returns the fields of a slide. No camera saw the underside of the object."""
    fields = _pinch(wish) | {"support": support_fields(wish.support, wish.real_edges)}
    return fields | {"object": {**fields["object"], "hollow": True}}


def _clasp(wish: Wish) -> dict[str, Any]:
    return {"object": cloud_fields(wish), "obstacles": wish.around}


def _refuse_pinch(wish: Wish) -> str:
    return cut_off(wish) or sliver(wish, SMOOTH)


def _refuse_rim(wish: Wish) -> str:
    return sliver(wish, SMOOTH)


def _refuse_slide(wish: Wish) -> str:
    edges = wish.real_edges
    if not edges:
        seen = Counter(str(label) for label in wish.support.edges)
        counts = ", ".join(f"{n} {label}" for label, n in sorted(seen.items()))
        return f"no real edge of {wish.support.name} was seen ({counts})"
    beyond = _beyond_reach(wish, edges)
    if beyond > 0:
        return f"no edge within reach: the nearest is {100 * beyond:.0f} cm beyond"
    width = _narrowest(np.asarray(wish.thing.outline))
    height = float(wish.thing.thickness)
    if height > THIN * width:
        lengths = f"{1000 * height:.0f} mm high and {1000 * width:.0f} mm wide"
        return f"{lengths}: only what is lower than three quarters of its width is slid"
    return sliver(wish, SMOOTH)


def _beyond_reach(wish: Wish, edges: list[int]) -> float:
    """Returns the distance by which the nearest edge is out of reach, seen from above [m].

    Minus infinity if the arm begins with a sliding joint, or if another joint moves its base: then
    it is not known.
    """
    robot = wish.model
    first = robot.group("arm")[0] if "arm" in robot.group_names else 0
    links = range(len(robot.frame_names))
    q = robot.clamp(np.zeros(robot.dof))
    moved = next(link for link in links if robot.jacobian(link, q)[:, first].any())
    J = robot.jacobian(moved, q)
    if not J[3:, first].any() or np.count_nonzero(J.any(axis=0)) > 1:
        return -np.inf
    reach = max(float(robot.reach(link)[first]) for link in links)
    ring = np.asarray(wish.support.polygon)
    ring_W = np.column_stack([ring, np.zeros(len(ring)), np.ones(len(ring))]) @ wish.support.X_WS.T
    base = np.asarray(robot.pose(moved, q))[:2, 3]  # on the axis of the first joint
    nearest = min(distance_to(base, ring_W[i, :2], ring_W[(i + 1) % len(ring), :2]) for i in edges)
    return nearest - reach


def _refuse_clasp(wish: Wish) -> str:
    if len(wish.thing.points) < 20:
        return f"only {len(wish.thing.points)} points were seen"
    return ""


def explained(plan: Any, wish: Wish) -> str:
    """Returns the reason of a chain that was not found, without the name of a strategy."""
    stage, _, reason = str(plan.reason).partition(": ")
    if stage not in STRATEGIES:
        reason = str(plan.reason)
    if str(plan.status) == "no_reliable_hole":
        reason += f"; {100 * unseen_share(wish):.0f} % of its side unseen"
    return reason


def _narrowest(ring: Matrix) -> float:
    """Returns the least width of a polygon across one of its edges [m]."""
    along = np.roll(ring, -1, axis=0) - ring
    across = np.stack([-along[:, 1], along[:, 0]]) / np.linalg.norm(along, axis=1)
    return float(np.ptp(ring @ across, axis=0).min())


_FIELDS: dict[str, Callable[[Wish], dict[str, Any]]] = {
    "pinch": _pinch,
    "rim": _pinch,
    "slide": _slide,
    "clasp": _clasp,
}
_REFUSALS: dict[str, Callable[[Wish], str]] = {
    "pinch": _refuse_pinch,
    "rim": _refuse_rim,
    "slide": _refuse_slide,
    "clasp": _refuse_clasp,
}
