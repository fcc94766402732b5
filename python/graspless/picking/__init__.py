# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pick up an object of a scene, by whichever way of grasping works."""

from __future__ import annotations

import itertools
import math
import time
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import limits, planning
from .._arguments import (
    require_above_zero,
    require_finite,
    require_integer,
    require_number,
    require_type,
)
from ..errors import TaskError, warn
from ..report import least_seconds
from . import place as places
from .hidden import warnings_of
from .moving import MOVING
from .obstacles import obstacles_of
from .result import FILE, NOT_TRIED, REFUSED, STALE, Attempt, Pick
from .robots import labelled, require_found
from .strategies import LEAST_SECONDS, STRATEGIES, require_strategies
from .trying import attempt_plan
from .wish import read_scene, stale, wish_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ..chain import Plan
    from ..perception import Scene
    from ..tasks.scenes import Respect
    from .wish import Wish


_RAN_OUT = 0.9  # of its share of the time: a search that took more had not ended


def pick(
    scene: Scene | str | Path,
    name: str,
    robot: str | Mapping[str, Any] | Sequence[str | Mapping[str, Any]],
    *,
    strategies: Sequence[str] = STRATEGIES,
    place: Mapping[str, Any] | None = None,
    lift: float = 0.1,
    respect: Respect = "objects",
    padding: float = 0.0,
    obstacles: Sequence[Mapping[str, Any]] = (),
    mass: float | None = None,
    grip_force: float | None = None,
    max_age: float | None = None,
    best_of: int = 1,
    seconds: float | None = None,
    seed: int | None = None,
    budget: planning.Budget | None = None,
    trust: bool = False,
) -> Pick:
    """Plans how a robot picks up an object of a scene.

    The strategies are tried in the order of the time that they usually take: pinch the object where
    it stands; pinch a wall of it as the camera saw it, one finger inside and one outside; slide it
    to a real edge of its support and grasp it there; clasp a hole or handle; tumble or push it with
    two fingertips to where it can be pinched or slid. Each plan ends with a lift, and holds in
    `check`. A strategy that cannot work is refused by lengths alone, with the length that is
    missing. Not finding a plan is a result, never an exception. Warnings of the scene about the
    object are given again.

    Parameters
    ----------
    scene : Scene, str or Path
        Result of `graspless.perceive`, or a scene file.
    name : str
        Name of the object in the scene.
    robot : str, dict or sequence of these
        A robot that comes with graspless, the path of a URDF, or the field `robot` of a task file.
        Of several robots, each tries a strategy before the next one is tried; `Pick.robot` is the
        one of the plan.
    strategies : sequence of str
        Strategies to try, in this order: pinch, rim, slide, clasp, tumble, push.
    place : dict, optional
        Where the object is put down after the lift, as in task files: a pose, a region or a
        support of the scene. Otherwise the plan ends with the object in the hand.
    lift : float
        Height of the lift [m].
    respect : str
        Obstacles besides the support: nothing, objects or unseen, as in task files.
    padding : float
        Distance that the robot and the object keep from the other objects [m].
    obstacles : sequence of dict
        Further bodies, such as walls that no camera saw: the field `obstacles` of a task file.
        Neither moving links nor the object may touch them; the robot's base is not tested.
    mass : float, optional
        Mass of the object [kg], which grasps must bear and slides count with. Needed to tumble and
        push it.
    grip_force : float, optional
        Force of each finger of the hand when it pinches [N]. Otherwise that of half the effort
        limits of the joints that close it; walls are not pinched by a hand without such limits.
    max_age : float, optional
        Largest age of the images of the scene [s]. An older scene, and one without a `stamp`, is
        refused.
    best_of : int
        Maximum number of plans. After the first plan, the strategies that follow are tried, and
        then all again with other seeds, `best_of` times at most. Returned is the plan of the
        shortest duration at the joints' speed limits. `max_mass` is not compared.
    seconds : float, optional
        Limit of the time, 10 by default [s]. What is left is shared evenly among the strategies
        that are left.
    seed : int, optional
        Seed of all random numbers, 1 by default. The same seed gives the same plan unless the time
        ends a search.
    budget : planning.Budget, optional
        Replaces `seconds` and `seed`. Another thread may call its stop(): the pick then ends after
        the check or the reading that runs, with the best plan that was found.
    trust : bool
        Let xacro files of the robot read any file and run code, see docs/security.md.

    Returns
    -------
    Pick
        True if a plan was found. `plan` is a plan of kind chain, and `attempts` says what became of
        each strategy.

    Raises
    ------
    TaskError
        The scene is empty or not valid, it has no such object or support, there is no such robot or
        strategy, the robot has no hand that one of the strategies could use, or a number is out of
        range.
    OutOfTimeError
        A TaskError: the time limit was reached while the robot or its meshes were read.
    """
    began = time.monotonic()
    budget = _budget_of(budget, seconds, seed)
    asked = require_strategies(strategies)
    best_of = require_integer("best_of", best_of, least=1)
    require_number("lift", lift)
    require_number("padding", padding)
    for field, value in (("mass", mass), ("grip_force", grip_force), ("max_age", max_age)):
        if value is not None:
            require_number(field, value)
    with limits.reading(budget.seconds, what="robot and the scene were read"):
        scene, file = read_scene(scene)
        robots = labelled(robot)
        require_found(list(robots.values()))
        further = obstacles_of(obstacles, name)
        wishes = {
            label: wish_of(
                scene, file, name, one,
                obstacles=further, lift=lift, respect=respect, padding=padding, mass=mass,
                grip_force=grip_force, trust=trust,
            )
            for label, one in robots.items()
        }  # fmt: skip
    tries = [Attempt(strategy, NOT_TRIED, robot=label) for strategy in asked for label in wishes]
    found = Pick(name, tries)
    first = next(iter(wishes.values()))
    for warning in warnings_of(first):
        warn(f"{file}: {name}: {warning}")
    target = None if place is None else places.target_of(first, place)
    old = "" if max_age is None else stale(scene, max_age)
    nowhere = "" if target is None or old else places.refusal(target)
    if old or nowhere:
        what = Attempt("scene", STALE, old) if old else Attempt("place", REFUSED, nowhere)
        found.attempts = [what, *tries]
    else:
        _search(found, wishes, target, best_of, budget, began)
        _require_usable(found)
    found.seconds = time.monotonic() - began
    return found


def _budget_of(
    budget: planning.Budget | None, seconds: float | None, seed: int | None
) -> planning.Budget:
    """Returns the budget, or that of seconds and seed. Raises TaskError if it is not valid."""
    if budget is None:
        require_above_zero("seconds", seconds := 10.0 if seconds is None else seconds)
        if not math.isfinite(seconds):
            raise TaskError(f"seconds: {seconds}: should be finite")
        seed = require_integer("seed", 1 if seed is None else seed, least=0, most=2**64 - 1)
        return planning.Budget(seconds=seconds, seed=seed)
    if (seconds, seed) != (None, None):
        raise TaskError("budget: seconds and seed must not be given beside it")
    require_type("budget", budget, planning.Budget)
    require_finite(budget)
    if budget.iterations is not None:
        what = "should be None: a pick runs several searches"
        raise TaskError(f"budget.iterations: {budget.iterations}: {what}")
    return budget


def _search(
    found: Pick,
    wishes: Mapping[str, Wish],
    target: places.Target | None,
    best_of: int,
    budget: planning.Budget,
    began: float,
) -> None:
    """Tries the strategies until there are `best_of` plans, and keeps the shortest one.

    While there is none, those whose searches ran out of their time are tried again with other
    seeds.
    """
    plans: list[tuple[Plan, str]] = []
    asked = found.attempts
    for k in itertools.count():
        unfinished: list[Attempt] = []
        for i, attempt in enumerate(asked):
            left = budget.seconds - (time.monotonic() - began)
            is_over = left <= 0 or budget.is_stopped
            if attempt.status == REFUSED or is_over or len(plans) == best_of:
                continue
            same = (other for other in found.attempts if other.robot == attempt.robot)
            opening = next((a.opening for a in same if a.opening is not None), None)
            share = left / (_waiting(asked, i) + len(unfinished))
            spent = attempt.seconds
            part = budget.part(seconds=share, seed=(budget.seed + k) % 2**64)
            plan = attempt_plan(attempt, wishes[attempt.robot], target, opening, part)
            if plan is not None:
                plans.append((plan, attempt.robot))
            elif attempt.seconds - spent >= _RAN_OUT * share:
                unfinished.append(attempt)
        if k + 1 >= best_of:
            asked = [] if plans else unfinished
        left = budget.seconds - (time.monotonic() - began)
        if not asked or left < LEAST_SECONDS or budget.is_stopped:
            break
    if plans:
        found.plan, found.robot = min(plans, key=lambda one: duration(one[0]))
    else:
        _note_end(found.attempts, budget)


def _note_end(attempts: Sequence[Attempt], budget: planning.Budget) -> None:
    """Notes why strategies were not tried, for the first in full."""
    tried = [a.strategy for a in attempts if a.status != NOT_TRIED]
    last = f"after '{tried[-1]}'" if tried else "when robot and scene had been read"
    reason = f"the time limit of {budget.seconds:g} s was over {last}; give more seconds"
    others = "no time was left"
    if budget.is_stopped:
        reason = others = "the pick was stopped"
    for attempt in attempts[len(tried) :]:
        attempt.reason, reason = reason, others


def _waiting(attempts: Sequence[Attempt], i: int) -> int:
    """Returns the number of attempts from one on, without those whose hand cannot do them."""
    still = {a.robot for a in attempts if not a.moves}
    return sum(k == i or a.strategy not in MOVING or a.robot not in still
               for k, a in enumerate(attempts) if k >= i)  # fmt: skip


def _require_usable(found: Pick) -> None:
    """Raises TaskError if no strategy came to a search, and one because of a mistake."""
    mistakes = [attempt for attempt in found.attempts if attempt.is_mistake]
    if mistakes and all(a.status == REFUSED and not a.is_planned for a in found.attempts):
        which = f"{mistakes[0].robot}: " if len({a.robot for a in found.attempts}) > 1 else ""
        raise TaskError(f"{FILE}: {which}{mistakes[0].reason}")


def duration(plan: Plan) -> float:
    """Returns the least duration of a plan at the speed limits of the joints [s]."""
    stages: tuple[Any, ...] = plan.stages
    motions = [
        (stage, stage.joint_segments if stage.kind == "fingertip" else stage.segments)
        for stage in stages
    ]
    return sum(
        least_seconds(stage, segment) or 0.0 for stage, segments in motions for segment in segments
    )


__all__ = ["STRATEGIES", "Attempt", "Pick", "duration", "pick"]


def __dir__() -> list[str]:
    return __all__
