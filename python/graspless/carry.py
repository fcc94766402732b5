# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Take what the hand holds along a straight way: lift it, or drag it."""

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
