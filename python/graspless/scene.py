# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot among bodies."""

from ._core.scene import (
    Scene,
)

__all__ = [
    "Scene",
]


def __dir__() -> list[str]:
    return __all__
