# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time and randomness of a task, in every kind alike."""

from __future__ import annotations

from typing import Any

from .. import planning
from .options import described_by
from .shapes import Fields
from .source import Source, at


@described_by(planning.Budget)
class Budget(Fields):
    """Time and randomness: graspless.planning.Budget."""


class Budgeted(Fields):
    """The budget of any task by itself, for validation."""

    budget: Budget


def build_budget(budget: Budget, source: Source) -> planning.Budget:
    with at(source, "budget"):
        return planning.Budget(**budget.model_dump(exclude_none=True))


def with_budget(budget: planning.Budget, changes: dict[str, Any]) -> planning.Budget:
    """Returns a budget with other seconds, iterations or seed."""
    source = Source("budget", {"budget": changes})
    validated = Source("budget", changes).validate(Budget).model_dump(exclude_none=True)
    given = {name: getattr(budget, name) for name in Budget.model_fields} | validated
    with at(source, "budget"):
        return planning.Budget(**given)
