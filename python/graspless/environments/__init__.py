# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gymnasium environments of the planners' tasks in MuJoCo, with the planner as the expert.

Importing this package registers them: graspless/SlideToEdge-v0, graspless/Tumble-v0,
graspless/Clasp-v0 and graspless/Pick-v0.
"""

from __future__ import annotations

from ..errors import missing

try:
    import gymnasium

    from .demonstrations import demonstrate
    from .env import PlanEnv
except ImportError as error:
    raise missing(error, "gym") from None

from .draws import DRAWS

for _name in DRAWS:
    gymnasium.register(
        f"graspless/{_name}-v0",
        entry_point="graspless.environments:PlanEnv",
        kwargs={"name": _name},
    )

__all__ = ["DRAWS", "PlanEnv", "demonstrate"]
