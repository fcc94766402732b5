# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Budget of a query, and the description of an option."""

from ._core.planning import (
    Budget,
    Field,
)

__all__ = [
    "Budget",
    "Field",
]


def __dir__() -> list[str]:
    return __all__
