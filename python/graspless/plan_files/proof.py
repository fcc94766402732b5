# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table of the trials that a plan file carries."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Literal

from pydantic import Field, model_validator

from ..proving.proof import ENDS
from ..tasks.shapes import LARGEST_INT, Count, CountOrZero, Fields, NotNegative, Seed

if TYPE_CHECKING:
    End = str
else:
    End = Literal[tuple(ENDS)]
Name = Annotated[str, Field(pattern=r"^\w+$", max_length=64)]


class ProofFields(Fields):
    """Trials of a plan in the physics engine while it was searched for."""

    asked: Annotated[int, Field(ge=2, le=LARGEST_INT)] = Field(
        description="number of trials that were asked for: one nominal, the others varied"
    )
    trials: CountOrZero = Field(description="number of trials that were done")
    held: CountOrZero = Field(description="number of trials that held")
    failures: list[list[Name]] = Field(
        description="(trials,) names of the failures of each trial, the nominal one first"
    )
    varied: dict[str, NotNegative] = Field(
        description="half width of each variation: fractions, metres or radians"
    )
    trial_seed: Seed = Field(description="seed of the variations")
    plan_seed: Seed = Field(description="seed of the plan")
    plans: Count = Field(description="number of plans that were simulated")
    ended: End = Field(description="reason why the search ended")
    engine: str = Field(description="name and version of the physics engine")
    version: str = Field(description="version of graspless")
    digest: Annotated[str, Field(pattern="^[0-9a-f]{64}$")] = Field(
        description="sha256 of the plan and its task, without budget, counters and texts"
    )
    error: str = Field(default="", description="error of the trial that ended the search")

    @model_validator(mode="after")
    def _check(self) -> ProofFields:
        if self.trials > self.asked:
            raise ValueError(f"proof.trials is {self.trials}, but {self.asked} were asked for")
        if len(self.failures) != self.trials:
            counts = f"{len(self.failures)} failures for {self.trials} trials"
            raise ValueError(f"proof has {counts}: one list per trial is needed")
        held = sum(not failed for failed in self.failures)
        if self.held != held:
            raise ValueError(f"proof.held is {self.held}, but {held} trials are without failures")
        if (self.ended == "proven") != (held == self.asked):
            raise ValueError(f"proof.ended is {self.ended}, but {held} of {self.asked} trials held")
        return self
