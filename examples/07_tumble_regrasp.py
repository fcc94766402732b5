# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same problem from the planner's own types, and what the plan says of each finger."""

import math

import numpy as np

from graspless import fingertip

block = fingertip.Object.box("block", [0.05, 0.05, 0.10], mass=1.0)
X_WO = np.eye(4)
X_WO[2, 3] = 0.05  # it stands on end on the floor z = 0
motion = fingertip.turn_path(X_WO, [0.025, 0, 0], [0, 1, 0], math.pi / 2, segments=30)
walls = [
    fingertip.Plane("behind", [1, 0, 0], -0.03),
    fingertip.Plane("beside", [0, -1, 0], -0.03),
]
problem = fingertip.Problem(
    object=block,
    motion=motion,
    fingers=fingertip.Fingers(count=2, radius=0.01, max_normal_force=10, friction=0.7),
    planes=[fingertip.Plane(), *walls],
    friction=0.5,
)
plan = fingertip.plan(problem)
assert plan, plan.reason
assert plan.weakest
assert fingertip.check(problem, plan) == []

print(f"cost {plan.cost:.6f}, {plan.regrasps} regrasp, z at least", end=" ")
print(f"{plan.segments[plan.weakest.segment].stability[plan.weakest.row]:.2f} N")
for segment in plan.segments:
    for k, finger in enumerate(segment.rows[0].fingers):
        where = f"{np.round(100 * finger.p_OC, 1)} cm" if finger.touches else "on its way"
        force = np.linalg.norm(finger.nominal_force_O)
        print(f"{segment.name:8} finger {k}: {finger.mode.name:9} {where}, {force:.1f} N")
