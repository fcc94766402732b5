# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clasp planner: put a hand through a hole of an object and close it.

After Stork, Pokorny, Kragic 2013. `plan` is Section IV, `test_stability` Section V-A.

>>> import numpy as np
>>> from graspless import clasp, geometry, robot
>>> arm = robot.Robot.from_urdf_file(robot.builtin("kr5_sdh"))  # doctest: +SKIP
>>> hand = clasp.hand_from_yaml_file("kr5_sdh.hand.yaml")  # doctest: +SKIP
>>> cloud = geometry.sample_surface(clasp.sample_object("purse"), 2000)  # doctest: +SKIP
>>> purse = clasp.Object.from_cloud("purse", cloud)  # doctest: +SKIP
>>> problem = clasp.Problem(arm, hand, purse, X_WO, arm.state("home"))  # doctest: +SKIP
>>> plan = clasp.plan(problem)  # doctest: +SKIP
>>> assert plan and not clasp.check(problem, plan)  # doctest: +SKIP
"""

from ._core.clasp import (
    CurveNode,
    Finger,
    Hand,
    Object,
    Options,
    Plan,
    Problem,
    Segment,
    Stability,
    StabilityOptions,
    Statistics,
    Status,
    Tree,
    check,
    hand_from_yaml,
    hand_from_yaml_file,
    plan,
    sample_object,
    sample_object_names,
    test_stability,
    validate,
)
from .collision import Obstacle

__all__ = [
    "CurveNode",
    "Finger",
    "Hand",
    "Object",
    "Obstacle",
    "Options",
    "Plan",
    "Problem",
    "Segment",
    "Stability",
    "StabilityOptions",
    "Statistics",
    "Status",
    "Tree",
    "check",
    "hand_from_yaml",
    "hand_from_yaml_file",
    "plan",
    "sample_object",
    "sample_object_names",
    "test_stability",
    "validate",
]
