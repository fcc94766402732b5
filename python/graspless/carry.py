# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Carry a held object along a straight path: lift it, or drag it over a surface."""

from ._core.carry import (
    Options,
    Plan,
    Problem,
    Segment,
    Statistics,
    Status,
    check,
    plan,
    validate,
)
from .collision import Obstacle

__all__ = [
    "Obstacle",
    "Options",
    "Plan",
    "Problem",
    "Segment",
    "Statistics",
    "Status",
    "check",
    "plan",
    "validate",
]


def __dir__() -> list[str]:
    return __all__
