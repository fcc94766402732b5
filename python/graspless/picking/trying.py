# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""One strategy of a pick: its plan, compared with measured heights, and the place at its end."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from .. import chain, planning
from .._api import check, plan_since
from ..errors import OutOfTimeError, TaskError
from ..tasks import task_from_dict
from . import place as places
from .measured import doubt
from .result import FAULTY, REFUSED
from .strategies import LEAST_SECONDS, chain_of, explained, refusal

if TYPE_CHECKING:
    from ..chain import Plan
    from .place import Target
    from .result import Attempt
    from .wish import Wish

# Slides press at random places; a pinch is the same with every seed, and so is a clasp's hole.
SEEDS = {"pinch": 1, "slide": 8, "clasp": 1}
APART = 2**32  # between their seeds: those of `best_of` follow each other
# A hand that grips an object 2 cm from its edge loses one of 0.2 kg: the weight turns it. Least
# overhangs of slides, tried in this order [m]; None is that of the planner.
DEEP_FIRST = (0.035, None)
FEW = 2000  # iterations of all but the last


def attempt_plan(
    attempt: Attempt,
    wish: Wish,
    target: Target | None,
    opening: float | None,
    seed: int,
    seconds: float,
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
    seed : int
    seconds : float
        Limit of the time [s].
    """
    began = time.monotonic()
    try:
        attempt.reason = refusal(attempt.strategy, wish, opening)
        if attempt.reason:
            attempt.status = REFUSED
            return None
        plan, doubted = _measured_plan(attempt.strategy, wish, target, seed, seconds)
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


def _measured_plan(
    strategy: str, wish: Wish, target: Target | None, seed: int, seconds: float
) -> tuple[Plan, str]:
    """Plans a strategy, and with other seeds while heights that were measured speak against it.

    A slide is planned with a deep grasp first, and with a shallow one if there is none. Returns the
    plan and what speaks against the last one, if anything does.
    """
    began = time.monotonic()
    for overhang in DEEP_FIRST if strategy == "slide" else (None,):
        document = chain_of(strategy, wish, seed, seconds, overhang)
        task = task_from_dict(document, strategy, resolve=True)
        if overhang is not None:
            task = task.with_changes(iterations=FEW)
        for k in range(SEEDS[strategy]):
            plan: Plan = plan_since(task.with_changes(seed=(seed + k * APART) % 2**64), began)
            doubted = doubt(plan, wish) if plan else ""
            if plan and not doubted and target is not None:
                left = max(LEAST_SECONDS, seconds - (time.monotonic() - began))
                plan, doubted = _placed(plan, target, document, left)
            if plan and not doubted:
                return plan, ""
            if not doubted or time.monotonic() - began >= seconds:
                break
        if time.monotonic() - began >= seconds:
            break
    return plan, doubted


def _placed(plan: Plan, target: Target, document: Any, seconds: float) -> tuple[Plan, str]:
    """Adds the stage that puts the object down. Returns the plan, and why it has no such stage."""
    stage = places.stage_of(target, plan.stages[0])
    if isinstance(stage, str):
        return plan, f"picked up, but not put down: {stage}"
    whole = document | {"stages": [*document["stages"], stage]}
    task = task_from_dict(whole, "place", resolve=True)
    budget = planning.Budget(seconds=seconds, seed=plan.task.budget.seed)
    found = chain.continued(plan, task, budget)
    return found, "" if found else f"picked up, but not put down: {found.reason}"


__all__ = ["attempt_plan"]
