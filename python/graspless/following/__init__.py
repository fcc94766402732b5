# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Execution of slides in closed loop: targets of the joints from measured poses of the object."""

from __future__ import annotations

from .estimate import Noise
from .follower import Follower
from .settings import Settings, Target

__all__ = ["Follower", "Noise", "Settings", "Target"]
