# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots read from URDF, and their inverse kinematics."""

from ._core.robot import (
    Ik,
    Robot,
)

__all__ = [
    "Ik",
    "Robot",
]
