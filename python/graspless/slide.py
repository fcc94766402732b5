# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slide a thin object to the edge of its support and grasp it there (Hang, Morgan, Dollar 2019)."""

from ._core.slide import (
    FingerModel,
    Hand,
    Object,
    Options,
    Plan,
    Problem,
    Search,
    Segment,
    Statistics,
    Status,
    Support,
    Turning,
    center_of_mass,
    check,
    plan,
    turning,
    validate,
)
from .collision import Obstacle

__all__ = [
    "FingerModel",
    "Hand",
    "Object",
    "Obstacle",
    "Options",
    "Plan",
    "Problem",
    "Search",
    "Segment",
    "Statistics",
    "Status",
    "Support",
    "Turning",
    "center_of_mass",
    "check",
    "plan",
    "turning",
    "validate",
]


def __dir__() -> list[str]:
    return __all__
