# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Strategies tumble and push: fingertips move a block to where a pinch or a slide grasps it."""

from __future__ import annotations

import itertools
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import limits, pinch
from .._api import check
from ..tasks import task_from_dict
from .block import Block, block_of, level, wish_at
from .fingertips import Fingertips, fingertips_of
from .hidden import covered, cut_off
from .moves import MOVES, Move, misplaced
from .result import FILE
from .strategies import THIN, WAYS, chain_of, explained, refusal, searched

if TYPE_CHECKING:
    from .. import planning
    from ..chain import Plan
    from .wish import Wish

MOVING = tuple(MOVES)
GRASPS = ("pinch", "slide")  # that can follow, in this order
# Placements that the fingertip planner likes best are often out of a hand's reach; others are found
# with other bounds on the distance of the fingertips, as parts of that when the hand is open.
SPANS = (1.25, 1.0, 0.75, 1.6)
# In MuJoCo, 66 of 68 tumbles held within these limits. Some were lost with 0.5 N, with a fingertip
# that slips by 2 mm, and, of those for single values of friction, at a friction lower by a tenth.
STABILITIES = (2.0, 1.0)  # least disturbance that every moment withstands [N]
MOST_SCRUB = 0.0015  # slip of a fingertip on its contact [m]
TIP_FRICTION, FLOOR_FRICTION = [0.63, 0.77], [0.45, 0.55]
REALIZE = {"restarts": 20, "solutions": 8, "plans": 1}  # other plans come from SPANS
ATTEMPTS = 2  # of a chain: with another seed, the grasp may continue from the motion
TRIAL_SECONDS = 1.0  # for a grasp where a motion would end
TRIAL_ITERATIONS = 2000


@dataclass(frozen=True)
class Found:
    """A chain that passes its check.

    Attributes
    ----------
    plan : chain.Plan
    document : dict
        Its task.
    wish : Wish
        The wish with the block where it is grasped.
    words : str
        Description of the motion and of what fits the hand after it.
    """

    plan: Plan
    document: dict[str, Any]
    wish: Wish
    words: str


def moving_of(
    strategy: str, wish: Wish, opening: float | None, budget: planning.Budget
) -> Moving | str:
    """Returns what can be planned, or why lengths or the robot rule it out, in one sentence.

    `opening` is that of the hand, as far as another strategy knows it [m]. If none does, a pinch is
    tried, which stop() of `budget` ends.
    """
    if reason := covered(wish) or cut_off(wish):
        return reason
    flat = level(wish)
    if isinstance(flat, str):
        return flat
    block = block_of(flat)
    if isinstance(block, str):
        return block
    pinching = _trial_task("pinch", flat, 1, min(budget.seconds, TRIAL_SECONDS))
    if opening is None:
        first: Any = searched(pinching, time.monotonic(), budget).stages[0]
        opening = float(first.opening)
    base = np.asarray(wish.model.X_WB)[:2, 3]
    every = [(move, _grasps(move.goal, wish, opening)) for move in MOVES[strategy](block, base)]
    fitting = sorted((one for one in every if one[1]), key=lambda one: GRASPS.index(one[1][0]))
    if not fitting:
        return _fits_nowhere(strategy, block, opening)
    tips = fingertips_of(pinching.problem.first.problem)
    if isinstance(tips, str):
        return f"needs fingertips of two fingers: {tips}"
    if wish.mass is None:
        return "its mass is needed (`mass`): the fingertips bear a part of its weight"
    wrong = [misplaced(move, flat) for move, _ in fitting]
    if all(wrong):
        return f"{fitting[0][0].words}, {wrong[0]}"
    return Moving(strategy, flat, block, tips, opening, fitting)


def _grasps(goal: Block, wish: Wish, opening: float) -> list[str]:
    """Returns the grasps that lengths allow at a goal."""
    fits = ["pinch"] if min(goal.sides) <= opening - 2 * pinch.Options().margin else []
    is_low = goal.height <= min(opening, THIN * min(goal.sides))
    return [*fits, "slide"] if is_low and wish.real_edges else fits


def _fits_nowhere(strategy: str, block: Block, opening: float) -> str:
    what = f"{block.text}: no side fits the {1000 * opening:.0f} mm hand"
    if strategy == "push":
        what += " as it stands"
    narrowest = float(min(block.sides if strategy == "push" else block.size))
    needed = narrowest + 2 * pinch.Options().margin
    more = needed - opening
    return f"{what}; one that opens {1000 * needed:.0f} mm (+{1000 * more:.0f} mm) would do"


def _trial_task(grasp: str, wish: Wish, seed: int, seconds: float) -> Any:
    """Returns the task of a grasp and lift of the object where it stands."""
    document = chain_of(grasp, wish, seed, seconds, WAYS[grasp][0])
    task = task_from_dict(document, FILE, resolve=True, trust=wish.trust)
    return task.with_changes(iterations=TRIAL_ITERATIONS)


def _scrubbing(plan: Plan) -> list[str]:
    """Says by how far a fingertip slips on its contact, if that is too far."""
    first: Any = plan.stages[0]
    scrub = max(float(segment.scrub) for segment in first.joint_segments)
    if scrub <= MOST_SCRUB:
        return []
    most = f"at most {1000 * MOST_SCRUB:.1f} mm are allowed"
    return [f"a fingertip slips by {1000 * scrub:.1f} mm on its contact, {most}"]


@dataclass
class Moving:
    """A block that fingertips move before it is grasped.

    Attributes
    ----------
    strategy : str
        tumble or push.
    wish : Wish
        The wish with a level support.
    block : Block
    tips : Fingertips
    opening : float
        Of the hand [m].
    moves : list of (Move, list of str)
        Motions after which the sides of the block fit grasps, and these grasps.
    """

    strategy: str
    wish: Wish
    block: Block
    tips: Fingertips
    opening: float
    moves: list[tuple[Move, list[str]]]
    reasons: list[tuple[int, str]] = field(default_factory=list)

    def plans(self, budget: planning.Budget) -> Iterator[Found]:
        """Yields chains that pass their check.

        What became of the others is in `reasons`.
        """
        began = time.monotonic()
        for move, grasps in self.moves:
            if wrong := misplaced(move, self.wish):
                self._note(0, f"{move.words}, {wrong}")
                continue
            there = wish_at(self.wish, move.goal)
            for grasp in grasps:
                if limits.is_over(budget, began):
                    self._note(0, "no time was left for the others")
                    return
                if not self._is_graspable(grasp, there, move, limits.rest(budget, began)):
                    continue
                found = self._chain(move, grasp, there, budget, began)
                if found is not None:
                    yield found

    def reason(self) -> str:
        """Returns what became of the motion that came farthest, and the number of all."""
        rank = max(rank for rank, _ in self.reasons)
        texts = [text for one, text in self.reasons if one == rank]
        return f"none of {len(self.reasons)} ways; {texts[0]}"

    def _note(self, rank: int, text: str) -> None:
        self.reasons.append((rank, text))

    def _success(self, move: Move, grasp: str) -> str:
        goal, hand = move.goal, f"the hand opens {1000 * self.opening:.0f} mm"
        if grasp == "pinch":
            return f"{move.words}: {1000 * min(goal.sides):.0f} mm wide there, {hand}"
        return f"{move.words}: {1000 * goal.height:.0f} mm high there, {hand}"

    def _is_graspable(self, grasp: str, there: Wish, move: Move, budget: planning.Budget) -> bool:
        """True if the arm can grasp the block where a motion ends: found out before it is planned.

        A grasp takes milliseconds, a motion by fingertips many times that.
        """
        why = refusal(grasp, there, self.opening)
        if not why:
            seconds = min(budget.seconds, TRIAL_SECONDS)
            task = _trial_task(grasp, there, budget.seed, seconds)
            trial = searched(task, time.monotonic(), budget)
            why = "" if trial else explained(trial, there)
        if why:
            self._note(1, f"{move.words}, {why}")
        return not why

    def _chain(
        self, move: Move, grasp: str, there: Wish, budget: planning.Budget, began: float
    ) -> Found | None:
        """Returns the first chain that passes its check, of several bounds on the fingertips."""
        why, rank = "", 2
        for stability, span in itertools.product(STABILITIES, SPANS):
            left = limits.rest(budget, began)
            document = self._document(move, grasp, there, left, span, stability)
            task = task_from_dict(document, FILE, resolve=True, trust=there.trust)
            plan: Plan = searched(task, time.monotonic(), budget)
            faults = (_scrubbing(plan) or check(plan)) if plan else []
            if plan and not faults:
                return Found(plan, document, there, self._success(move, grasp))
            failed = faults[0] if faults else explained(plan, there)
            reached = len(plan.stages) + (3 if faults else 1)
            why, rank = (failed, reached) if reached >= rank else (why, rank)
            if limits.is_over(budget, began):
                break
        self._note(rank, f"{move.words}, {why}")
        return None

    def _document(
        self, move: Move, grasp: str, there: Wish, budget: planning.Budget, span: float,
        stability: float,
    ) -> dict[str, Any]:  # fmt: skip
        """Returns the chain: fingertips move the block, then it is grasped and lifted."""
        document = chain_of(grasp, there, budget.seed, budget.seconds, WAYS[grasp][0])
        tips = self.tips
        moved = {
            "name": self.strategy,
            "kind": "fingertip",
            "object": {
                "name": there.name,
                "box": [float(side) for side in self.block.size],
                "mass": there.mass,
            },
            "floor": {"height": float(np.asarray(there.support.X_WS)[2, 3])},
            "fingers": {
                "count": 2,
                "radius": tips.radius,
                "max_span": span * tips.apart,
                "friction": TIP_FRICTION,
            },
            "friction": FLOOR_FRICTION,
            "motion": move.motion,
            "obstacles": there.beside,
            "carrier": {"fingertips": tips.frames, "links": [[link] for link in tips.links]},
            "realize": REALIZE,
            "options": {"min_stability": stability, "max_regrasps": 0, "explain": False},
        }
        first, *others = document["stages"]
        thing = {key: value for key, value in first["object"].items() if key != "pose"}
        stages = [moved, {**first, "object": thing}, *others]
        return document | {"stages": stages, "options": {"attempts": ATTEMPTS}}
