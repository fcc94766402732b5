# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans in time."""

from .trajectory import Trajectory

__all__ = ["Trajectory"]
