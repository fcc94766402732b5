# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pick up an object of a scene, by whichever way of grasping works."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from .. import planning
from .._api import check, plan_since
from .._arguments import require_integer
from ..errors import OutOfTimeError, TaskError
from ..report import least_seconds
from ..tasks import task_from_dict
from .measured import doubt
from .result import FAULTY, NOT_TRIED, REFUSED, Attempt, Pick
from .strategies import STRATEGIES, chain_of, explained, refusal, require_strategies
from .wish import wish_of

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from ..chain import Plan
    from ..perception import Scene
    from ..tasks.scenes import Respect
    from .wish import Wish

# Slides press at random places; a pinch is the same with every seed, and so is a clasp's hole.
SEEDS = {"pinch": 1, "slide": 8, "clasp": 1}
APART = 2**32  # between their seeds: those of `best_of` follow each other


def pick(
    scene: Scene | str | Path,
    name: str,
    robot: str | Mapping[str, Any],
    *,
    strategies: Sequence[str] = STRATEGIES,
    lift: float = 0.1,
    respect: Respect = "objects",
    mass: float | None = None,
    best_of: int = 1,
    seconds: float = 10.0,
    seed: int = 1,
) -> Pick:
    """Plans how the robot picks up an object of a scene.

    The strategies are tried in the order of the time that they usually take: pinch the object where
    it stands; slide it to a real edge of its support and grasp it there; clasp a hole or handle.
    Each plan ends with a lift, and holds in `check`. A strategy that cannot work is refused by
    lengths alone, with the length that is missing. Not finding a plan is a result, never an
    exception.

    Parameters
    ----------
    scene : Scene, str or Path
        Result of `graspless.perceive`, or a scene file.
    name : str
        Name of the object in the scene.
    robot : str or dict
        A robot that comes with graspless, the path of a URDF, or the field `robot` of a task file.
    strategies : sequence of str
        Strategies to try, in this order: pinch, slide, clasp.
    lift : float
        Height of the lift [m].
    respect : str
        Obstacles besides the support: nothing, objects or unseen, as in task files.
    mass : float, optional
        Mass of the object for simulations [kg].
    best_of : int
        Number of plans to find, from which the one of the shortest duration at the joints' speed
        limits is returned. More than one takes the whole time if fewer are found.
    seconds : float
        Limit of the time [s]. What is left is shared evenly among the strategies that are left.
    seed : int
        Seed of all random numbers. The same seed gives the same plan unless the time ends a search.

    Returns
    -------
    Pick
        True if a plan was found. `plan` is a plan of kind chain, and `attempts` says what became of
        each strategy.

    Raises
    ------
    TaskError
        The scene is empty or not valid, it has no such object, there is no such robot or strategy,
        the robot has no hand that one of the strategies could use, or a number is out of range.
    """
    began = time.monotonic()
    asked = require_strategies(strategies)
    best_of = require_integer("best_of", best_of, least=1)
    budget = planning.Budget(seconds=seconds, seed=seed)
    wish = wish_of(scene, name, robot, lift=lift, respect=respect, mass=mass)
    found = Pick(wish.name, [Attempt(strategy, NOT_TRIED) for strategy in asked])
    plans: list[Plan] = []
    for k in range(best_of):
        for i, attempt in enumerate(found.attempts):
            left = budget.seconds - (time.monotonic() - began)
            if attempt.status == REFUSED or left <= 0 or len(plans) == best_of:
                continue
            share = left / (len(asked) - i)
            opening = next((a.opening for a in found.attempts if a.opening is not None), None)
            plan = _attempt(attempt, wish, opening, (budget.seed + k) % 2**64, share)
            if plan is not None:
                plans.append(plan)
    found.plan = min(plans, key=duration, default=None)
    _require_usable(found)
    found.seconds = time.monotonic() - began
    return found


def _attempt(
    attempt: Attempt, wish: Wish, opening: float | None, seed: int, seconds: float
) -> Plan | None:
    """Plans a strategy, and notes what became of it. `opening` is that of the hand, if known."""
    began = time.monotonic()
    try:
        attempt.reason = refusal(attempt.strategy, wish, opening)
        if attempt.reason:
            attempt.status = REFUSED
            return None
        plan, doubted = _measured_plan(attempt.strategy, wish, seed, seconds)
        faults = check(plan) if plan and not doubted else []
    except OutOfTimeError as error:
        attempt.status, attempt.reason = "out_of_time", str(error)
        return None
    except TaskError as error:
        attempt.status, attempt.reason = REFUSED, str(error).removeprefix(f"{attempt.strategy}: ")
        attempt.is_mistake = True
        return None
    finally:
        attempt.seconds += time.monotonic() - began
    if attempt.strategy == "pinch" and plan.stages:
        first: Any = plan.stages[0]
        attempt.opening = float(first.opening)
    if plan or attempt.status != "solved":
        attempt.status, attempt.reason = str(plan.status), explained(plan, wish)
    if doubted:
        attempt.status, attempt.reason = REFUSED, doubted
        return None
    if faults:
        attempt.status, attempt.reason = FAULTY, faults[0]
        return None
    return plan if plan else None


def _measured_plan(strategy: str, wish: Wish, seed: int, seconds: float) -> tuple[Plan, str]:
    """Plans a strategy, and with other seeds while heights that were measured speak against it.

    Returns the plan and what speaks against the last one, if anything does.
    """
    began = time.monotonic()
    task = task_from_dict(chain_of(strategy, wish, seed, seconds), strategy, resolve=True)
    for k in range(SEEDS[strategy]):
        if k > 0 and time.monotonic() - began >= seconds:
            break
        plan: Plan = plan_since(task.with_changes(seed=(seed + k * APART) % 2**64), began)
        doubted = doubt(plan, wish) if plan else ""
        if not doubted:
            break
    return plan, doubted


def _require_usable(found: Pick) -> None:
    """Raises TaskError if no strategy came to a search, and one because of a mistake."""
    mistakes = [attempt for attempt in found.attempts if attempt.is_mistake]
    if mistakes and all(attempt.status == REFUSED for attempt in found.attempts):
        raise TaskError(f"{mistakes[0].strategy}: {mistakes[0].reason}")


def duration(plan: Plan) -> float:
    """Returns the least duration of a plan at the speed limits of the joints [s]."""
    return sum(
        least_seconds(stage, segment) or 0.0 for stage in plan.stages for segment in stage.segments
    )


__all__ = ["STRATEGIES", "Attempt", "Pick", "duration", "pick"]


def __dir__() -> list[str]:
    return __all__
