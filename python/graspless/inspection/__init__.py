# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Description of a robot, proposed from its URDF: groups, states, frames, hand and pairs."""

from .proposal import Finding, Proposal

__all__ = ["Finding", "Proposal"]


def __dir__() -> list[str]:
    return __all__
