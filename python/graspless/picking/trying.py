# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""One strategy of a pick: its plan, compared with measured heights, and the place at its end."""

from __future__ import annotations

import dataclasses
import time
from typing import TYPE_CHECKING, Any

from .. import chain, limits
from .._api import check
from ..errors import OutOfTimeError, TaskError
from ..tasks import task_from_dict
from . import loose, over_edge
from .fingertips import Fingertips, fingertips_of
from .measured import doubt
from .moving import MOVING, moving_of
from .result import FAULTY, FILE, INTERRUPTED, NOT_FOUND, REFUSED
from .strategies import LEAST_SECONDS, chain_of, explained, refusal, searched, ways_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from .. import planning
    from ..chain import Plan
    from .place import Target
    from .result import Attempt
    from .wish import Wish

# Slides press at random places, and clasps hold at random places what shall be put down. A pinch is
# the same with every seed.
SEEDS = {"pinch": 1, "rim": 1, "slide": 8, "clasp": 4}
# Of a slide to a place: hundreds of starts, all with the goal that fits them.
SLIDE_ITERATIONS = 800
APART = 2**32  # between their seeds: those of `best_of` follow each other


def attempt_plan(
    attempt: Attempt,
    wish: Wish,
    target: Target | None,
    opening: float | None,
    budget: planning.Budget,
) -> Plan | None:
    """Plans a strategy, and notes what became of it.

    Parameters
    ----------
    attempt : Attempt
        Strategy, whose outcome is written there.
    wish : Wish
    target : Target or None
        Place where the object is put down.
    opening : float or None
        Opening of the hand, if another strategy found it [m].
    budget : planning.Budget
        Seconds and seed. Its stop() ends the search.
    """
    began = time.monotonic()
    try:
        if attempt.strategy in MOVING:
            return _move(attempt, wish, target, opening, budget)
        attempt.reason = refusal(attempt.strategy, wish, opening)
        if attempt.reason:
            attempt.status = REFUSED
            return None
        plan, doubted, faults = _plan(attempt.strategy, wish, target, budget)
    except OutOfTimeError as error:
        attempt.status, attempt.reason = "out_of_time", _in_one_line(error)
        return None
    except TaskError as error:
        attempt.status, attempt.reason = REFUSED, _in_one_line(error)
        attempt.is_mistake = True
        return None
    finally:
        attempt.seconds += time.monotonic() - began
    if plan.stages and plan.stages[0].kind == "pinch":
        first: Any = plan.stages[0]
        attempt.opening = float(first.opening) or None  # 0 if its time was over at once
        attempt.moves = isinstance(fingertips_of(first.task.problem), Fingertips)
    if plan or attempt.status != "solved":
        attempt.status, attempt.reason = str(plan.status), explained(plan, wish)
    if plan and target is not None and not doubted:
        held = [stage for stage in plan.stages if stage.kind == "carry"][-1]
        attempt.reason = str(loose.sway_of(held, wish) or "")
    if doubted:
        attempt.status = INTERRUPTED if budget.is_stopped else REFUSED
        attempt.reason, attempt.is_planned = doubted, True
        return None
    if faults:
        attempt.status, attempt.reason = FAULTY, faults[0]
        return None
    return plan if plan else None


def _in_one_line(error: TaskError) -> str:
    """Returns the faults of a task, which nobody wrote, without its file."""
    return "; ".join(line.removeprefix(f"{FILE}: ") for line in str(error).splitlines())


def _move(
    attempt: Attempt,
    wish: Wish,
    target: Target | None,
    opening: float | None,
    budget: planning.Budget,
) -> Plan | None:
    """Plans a strategy whose object fingertips move before it is grasped."""
    began = time.monotonic()
    moving = moving_of(attempt.strategy, wish, opening, budget)
    if isinstance(moving, str):
        attempt.status, attempt.reason = REFUSED, moving
        return None
    doubted = ""
    for found in moving.plans(budget):
        plan = found.plan
        if target is not None:
            is_same = target.support.name == found.wish.support.name
            support = found.wish.support if is_same else target.support
            there = dataclasses.replace(target, wish=found.wish, support=support)
            plan, doubted = _placed(plan, there, found.document, limits.rest(budget, began))
            faults = [] if doubted else check(plan)
            doubted = doubted or next(iter(faults), "")
        if not doubted:
            attempt.status, attempt.reason = "solved", found.words
            return plan
    if attempt.status != "solved":
        attempt.status = INTERRUPTED if budget.is_stopped else NOT_FOUND
        attempt.reason = doubted or moving.reason()
    return None


def _plan(
    strategy: str, wish: Wish, target: Target | None, budget: planning.Budget
) -> tuple[Plan, str, list[str]]:
    """Plans a strategy in its ways, until a plan fits the measured heights and passes its check.

    Returns a plan, what speaks against it, and its faults. If no plan holds, they are those of the
    last way that had a plan, or of the last way, before the object was in the way of the hand.
    """
    began = time.monotonic()
    kept: tuple[Plan, str, list[str]] | None = None
    is_too_high = has_no_room = False
    opening: float | None = None
    for way in ways_of(strategy, wish, target is not None):
        if way.pads is not None and not (is_too_high or has_no_room):
            continue
        if way.opening is not None and not has_no_room:
            continue
        seconds = budget.seconds / 2 if way.hangs else budget.seconds
        document = chain_of(strategy, wish, budget.seed, seconds, way, opening)
        task = task_from_dict(document, FILE, resolve=True, trust=wish.trust)
        task = task.with_changes(iterations=way.iterations)
        faults: list[str] = []
        tried: list[tuple[Plan, str]] = []
        for plan in _grasps(strategy, task, budget, began, wish if target else None):
            doubted = doubt(plan, wish) if plan else ""
            if plan and not doubted and target is not None:
                plan, doubted = _placed(plan, target, document, limits.rest(budget, began))
            tried.append((plan, doubted))
            if not doubted or limits.is_over(budget, began):
                break
        if doubted and target is not None:  # what came farthest says most
            plan, doubted = max(tried, key=lambda one: len(one[0].stages))
        if not plan and not doubted:  # a plan of an earlier seed says more
            plan, doubted = next((one for one in reversed(tried) if one[0]), (plan, doubted))
        if plan and not doubted:
            faults = check(plan)
        holds = plan and not doubted and not faults
        says_more = kept is None or bool(plan) or not kept[0]
        if holds or (says_more and not has_no_room):
            kept = plan, doubted, faults
        if holds:
            break
        first: Any = plan.stages[0] if plan.stages else None
        if first is not None and first.kind == "pinch" and first.opening > 0:
            opening = float(first.opening)  # 0 if the time was over at once
        is_too_high = is_too_high or bool(doubted) or str(plan.status) == "too_flat"
        has_no_room = has_no_room or _is_crowded(plan)
        if limits.is_over(budget, began):
            break
    assert kept is not None  # there is a first way
    return kept


def _is_crowded(plan: Plan) -> bool:
    """Returns True if the object was in the way of the hand that should pinch it."""
    first: Any = plan.stages[0] if plan.stages else None
    if plan or first is None or first.kind != "pinch":
        return False
    in_the_way = any(why.endswith("with object") for why in first.statistics.refusals)
    return str(first.status) == "no_room" or in_the_way


def _grasps(
    strategy: str, task: Any, budget: planning.Budget, began: float, steady: Wish | None
) -> Iterator[Plan]:
    """Yields plans of a strategy with several seeds.

    If a clasp is to be put down, these are the first `SEEDS`, or as many as half of the time allows
    or as it takes to find one that hangs still. The one that hangs most still comes first. `steady`
    is then the wish.
    """
    seeds = ((budget.seed + k * APART) % 2**64 for k in range(SEEDS[strategy]))
    plans: Iterator[Plan] = (
        searched(task.with_changes(seed=seed), began, budget) for seed in seeds
    )
    if strategy != "clasp" or steady is None:
        yield from plans
        return
    found: list[tuple[float, int, Plan]] = []
    for plan in plans:
        sway = loose.sway_of(plan.stages[-1], steady) if plan else None
        found.append((0.0 if sway is None else sway.off, len(found), plan))
        is_late = time.monotonic() - began > budget.seconds / 2
        if not plan or is_late or found[-1][0] < loose.LITTLE:
            break
    solved = [one for one in found if one[2]]
    for _, _, plan in sorted(solved) if solved else found:
        yield plan


def _placed(plan: Plan, target: Target, document: Any, budget: planning.Budget) -> tuple[Plan, str]:
    """Adds the stages that put the object down. Returns the plan, and why it has none."""
    began = time.monotonic()
    grasp, lift = plan.stages[-2:]
    ways = over_edge.ways_down(target, grasp, lift, document["stages"][-2])
    if isinstance(ways, str):
        return plan, f"picked up, but not put down: {ways}"
    waiting = sum(1 + len(slides) for _, slides in ways)
    failed: list[tuple[int, Plan, str]] = []  # by the stages that were reached

    def longer(plan: Plan, *stages: Any) -> Plan:
        seconds = limits.rest(budget, began).seconds / waiting
        part = budget.part(
            seconds=max(LEAST_SECONDS, seconds),
            seed=plan.task.budget.seed,
            iterations=SLIDE_ITERATIONS if stages[-1]["kind"] == "slide" else None,
        )
        whole = document | {"stages": [*document["stages"], *stages]}
        task = task_from_dict(whole, FILE, resolve=True, trust=target.wish.trust)
        return chain.continued(plan, task, part)

    for put, slides in ways:
        if failed and limits.is_over(budget, began):
            break
        there = longer(plan, put)
        waiting -= 1
        if there and not slides:
            return there, ""
        if not there:
            failed.append((1, there, there.reason))
            waiting -= len(slides)
        for slide in slides if there else []:
            if failed and limits.is_over(budget, began):
                break
            found = longer(there, put, slide)
            waiting -= 1
            doubted = doubt(found, target.wish) if found else found.reason
            if not doubted:
                return found, ""
            failed.append((2, found, doubted))
    _, best, why = max(failed, key=lambda one: one[0])
    return best, f"picked up, but not put down: {why}"
