# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Push, slide and tumble an object with bare fingertips (Maeda, Arai).

>>> import numpy as np
>>> from graspless import fingertip
>>> block = fingertip.Object.box("block", [0.05, 0.10, 0.05], mass=0.2)
>>> X_WO = np.eye(4)
>>> X_WO[2, 3] = 0.025  # it stands on the floor z = 0
>>> motion = fingertip.slide_path(X_WO, [0.10, 0.0, 0.0], segments=30)
>>> problem = fingertip.Problem(object=block, motion=motion)
>>> plan = fingertip.plan(problem)  # doctest: +SKIP
>>> assert plan and not fingertip.check(problem, plan)  # doctest: +SKIP
"""

from ._core.fingertip import (
    Carrier,
    Face,
    Fingers,
    FingerState,
    Goal,
    JointSegment,
    Lattice,
    Object,
    Options,
    Path,
    Plan,
    Plane,
    Problem,
    Realization,
    RealizeOptions,
    Relaxation,
    Row,
    Search,
    Segment,
    Statistics,
    Status,
    check,
    check_realization,
    join,
    plan,
    realize,
    slide_path,
    turn_path,
    validate,
)
from ._core.mechanics import Compliance, FingerMode
from .collision import Obstacle

Motion = Path | Lattice | Goal

__all__ = [
    "Carrier",
    "Compliance",
    "Face",
    "FingerMode",
    "FingerState",
    "Fingers",
    "Goal",
    "JointSegment",
    "Lattice",
    "Motion",
    "Object",
    "Obstacle",
    "Options",
    "Path",
    "Plan",
    "Plane",
    "Problem",
    "Realization",
    "RealizeOptions",
    "Relaxation",
    "Row",
    "Search",
    "Segment",
    "Statistics",
    "Status",
    "check",
    "check_realization",
    "join",
    "plan",
    "realize",
    "slide_path",
    "turn_path",
    "validate",
]
