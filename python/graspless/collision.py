# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies at poses, and which of them touch."""

from ._core.collision import (
    Obstacle,
    World,
)

__all__ = [
    "Obstacle",
    "World",
]


def __dir__() -> list[str]:
    return __all__
