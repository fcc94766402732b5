# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What every planner shares: the budget of a query."""

from ._core.planning import (
    Budget,
)

__all__ = [
    "Budget",
]


def __dir__() -> list[str]:
    return __all__
