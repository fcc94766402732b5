# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time and randomness of a task, in every kind alike."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field

from .shapes import Fields, Positive
from .source import Source, at

if TYPE_CHECKING:
    from .. import planning


class Budget(Fields):
    """Time and randomness: graspless.planning.Budget."""

    seconds: Positive | None = Field(default=None, description="wall clock [s]")
    iterations: Annotated[int, Field(ge=0, lt=2**63)] | None = None
    seed: Annotated[int, Field(ge=0, lt=2**64)] | None = None


def build_budget(budget: Budget, source: Source) -> planning.Budget:
    with at(source, "budget"):
        built: planning.Budget = _planning().Budget(**budget.model_dump(exclude_none=True))
    return built


def _planning() -> Any:
    from .. import planning

    return planning


def with_budget(budget: planning.Budget, changes: dict[str, Any]) -> planning.Budget:
    """Returns a budget with other seconds, iterations or seed."""
    source = Source("budget", {"budget": changes})
    validated = Source("budget", changes).validate(Budget).model_dump(exclude_none=True)
    given = {name: getattr(budget, name) for name in Budget.model_fields} | validated
    with at(source, "budget"):
        built: planning.Budget = _planning().Budget(**given)
    return built
