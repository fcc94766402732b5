# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Result of a pick: a plan, and what became of each strategy."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ..chain import Plan

NOT_TRIED, REFUSED, FAULTY, STALE = "not_tried", "refused", "faulty", "stale"
NOT_FOUND, INTERRUPTED = "not_found", "interrupted"
FILE = "pick"  # stands for the file of all its tasks, in messages


@dataclass
class Attempt:
    """A strategy, and what became of it.

    Attributes
    ----------
    strategy : str
        pinch, rim, slide, clasp, tumble or push; scene or place if this rules out all of them.
    status : str
        solved; refused: lengths or the description of the robot rule it out; not_tried: another
        strategy was found before, no time was left, or the pick was stopped; faulty: its plan does
        not pass `check`; stale: the scene is too old; not_found: no tumble or push leads to a
        grasp; interrupted: the budget was stopped; otherwise the status of its plan.
    reason : str
        One sentence; empty if another strategy was found before. Of those that were solved, a clasp
        has a warning, and a tumble or push says which one it is.
    robot : str
        Name of the robot that tried it.
    seconds : float
        Time that it took [s].
    opening : float or None
        Gap between the fingers of the open hand, if a pinch or a rim was tried [m].
    moves : bool
        False if a pinch was tried and its hand cannot tumble or push: it has no round fingertips.
    is_mistake : bool
        True if the description of robot, hand or object was refused.
    is_planned : bool
        True if a grasp was planned, and was refused after that.
    """

    strategy: str
    status: str
    reason: str = ""
    robot: str = ""
    seconds: float = 0.0
    opening: float | None = field(default=None, repr=False)
    moves: bool = field(default=True, repr=False)
    is_mistake: bool = field(default=False, repr=False)
    is_planned: bool = field(default=False, repr=False)


@dataclass
class Pick:
    """A plan that picks up an object, or why there is none. False unless there is a plan.

    Attributes
    ----------
    name : str
        Name of the object.
    attempts : list of Attempt
        Strategies in the order in which they were tried.
    plan : chain.Plan or None
        Plan of the best strategy: it ends with the object lifted, or put down.
    robot : str or None
        Name of the robot of the plan.
    seconds : float
        Time of all strategies together [s].
    """

    name: str
    attempts: list[Attempt]
    plan: Plan | None = None
    robot: str | None = None
    seconds: float = 0.0

    def __bool__(self) -> bool:
        return self.plan is not None

    @property
    def strategy(self) -> str | None:
        """Strategy of the plan."""
        return None if self.plan is None else self.plan.names[0]

    @property
    def reason(self) -> str:
        """Results of all strategies in one line; empty if there is a plan."""
        if self:
            return ""
        return "; ".join(
            f"{self._who(a)}{a.strategy}: {a.reason or a.status}" for a in self.attempts
        )

    def _who(self, attempt: Attempt) -> str:
        """Returns the name of an attempt's robot if there are several."""
        several = len({a.robot for a in self.attempts if a.robot}) > 1
        return f"{attempt.robot} " if several and attempt.robot else ""

    def as_dict(self) -> dict[str, Any]:
        """Returns a summary in plain types."""
        return {
            "name": self.name,
            "strategy": self.strategy,
            "robot": self.robot,
            "seconds": self.seconds,
            "attempts": [
                {
                    "strategy": a.strategy,
                    "status": a.status,
                    "reason": a.reason,
                    "robot": a.robot,
                    "seconds": a.seconds,
                }
                for a in self.attempts
            ],
        }

    def table(self) -> str:
        """Returns one line per strategy."""
        lines = []
        for a in self.attempts:
            what = f"{a.status}: {a.reason}" if a.reason else a.status
            took = f"  ({1000 * a.seconds:.0f} ms)" if a.seconds else ""
            lines.append(f"{self._who(a)}{a.strategy:6} {what}{took}")
        return "\n".join(lines)
