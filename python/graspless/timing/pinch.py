# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Timing of pinches: as the last two segments of a slide, which are the same."""

from .slide import robot, trajectory

__all__ = ["robot", "trajectory"]
