# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time and randomness of a task, in every kind alike."""

from __future__ import annotations

from .. import planning
from .options import described_by
from .shapes import Fields
from .source import Source, at


@described_by(planning.Budget)
class Budget(Fields):
    """Time and randomness: graspless.planning.Budget."""


def build_budget(budget: Budget, source: Source) -> planning.Budget:
    with at(source, "budget"):
        return planning.Budget(**budget.model_dump(exclude_none=True))
