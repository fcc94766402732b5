# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Budget of a query: its limits in time and iterations, and its random seed."""

from ._core.planning import (
    Budget,
)

__all__ = [
    "Budget",
]


def __dir__() -> list[str]:
    return __all__
