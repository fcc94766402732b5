# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot among obstacles and objects, and its collision checks."""

from ._core.scene import (
    Scene,
    sample_contacts,
)

__all__ = [
    "Scene",
    "sample_contacts",
]


def __dir__() -> list[str]:
    return __all__
