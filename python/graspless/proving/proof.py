# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Evidence of a plan that was simulated while it was searched for."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from dataclasses import dataclass
from typing import Any

from ..tasks.digest import digest

ENDS = {
    "proven": "all trials of this plan held",
    "no_other_plan": "no other plan was found",
    "out_of_time": "the time limit was reached",
    "interrupted": "interrupted",
    "error": "the physics engine failed",
}
"""Reasons why the search for a plan that holds in all trials ended."""

_UNTOUCHED = ("stats", "reason", "warnings")  # fields of a plan that nothing executes


@dataclass(frozen=True)
class Proof:
    """Trials of a plan in the physics engine. True if all trials were done, and all held.

    `str()` of it is one sentence, for instance "proven in 5 of 5 trials".

    Attributes
    ----------
    asked : int
        Number of trials that were asked for: one nominal, the others varied.
    trials : int
        Number of trials that were done; less than `asked` only if the search was ended.
    held : int
        Number of trials that held.
    failures : list of list of str
        Names of the failures of each trial, the nominal one first; empty if the trial held.
    varied : dict of str to float
        Half width of each variation: fractions, metres or radians.
    trial_seed : int
        Seed of the variations. `graspless.simulate(plan, asked, trial_seed)` repeats the trials.
    plan_seed : int
        Seed of the plan.
    plans : int
        Number of plans that were simulated. This one held in the most trials.
    ended : str
        Why the search ended, one of `ENDS`.
    engine : str
        Name and version of the physics engine.
    version : str
        Version of graspless.
    digest : str
        Digest of the plan and its task, by `digest_of`.
    error : str
        Error of the trial that ended the search; otherwise empty.
    """

    asked: int
    trials: int
    held: int
    failures: list[list[str]]
    varied: dict[str, float]
    trial_seed: int
    plan_seed: int
    plans: int
    ended: str
    engine: str
    version: str
    digest: str
    error: str = ""

    def __bool__(self) -> bool:
        return self.held == self.trials == self.asked

    def __str__(self) -> str:
        if self:
            return f"proven in {self.held} of {_trials(self.asked)}"
        parts = [f"held in {self.held} of {_trials(self.trials)}"]
        if self.trials < self.asked:
            parts[0] += f" ({self.asked} were asked for)"
        if self.failed:
            failed = (f"{name} in {count}" for name, count in self.failed.items())
            parts.append(f"fails: {', '.join(failed)}")
        best = f"best of {self.plans} plans; " if self.plans > 1 else ""
        why = f": {self.error}" if self.error else ""
        return "; ".join([*parts, best + ENDS[self.ended] + why])

    @property
    def failed(self) -> dict[str, int]:
        """Number of trials by kind of failure, the most frequent first."""
        return dict(Counter(name for trial in self.failures for name in trial).most_common())


def _trials(number: int) -> str:
    return "1 trial" if number == 1 else f"{number} trials"


def digest_of(plan: Any) -> str:
    """Returns the sha256 of everything in a plan that its execution depends on.

    It covers the motion and the task, but not the budget of the search, counters and texts.

    Raises
    ------
    TaskError
        The plan was made for a problem that no task file can state.
    """
    return hashlib.sha256(json.dumps(_executed(plan), sort_keys=True).encode()).hexdigest()


def _executed(plan: Any) -> dict[str, Any]:
    said = {key: value for key, value in plan._fields().items() if key not in _UNTOUCHED}
    task = {key: value for key, value in plan.task.to_dict().items() if key != "budget"}
    if "stages" in said:
        said["stages"] = [_executed(stage) for stage in plan.stages]
    return said | {"task": digest(task)}


def fault_of(plan: Any) -> str | None:
    """Returns the fault of a plan that was changed after its trials, or None."""
    proof = plan.proof
    if proof is None or proof.digest == digest_of(plan):
        return None
    return (
        "proof: the plan or its task was changed after the trials; "
        "remove `proof` from the plan, and simulate it again"
    )


def verdict(plan: Any) -> str:
    """Returns the sentence on a plan's trials; empty if there were none."""
    if plan.proof is None:
        return ""
    return "not proven: changed after its trials" if fault_of(plan) else str(plan.proof)
