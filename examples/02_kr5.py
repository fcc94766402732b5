# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same problem without a task file, from the planner's own types."""

import numpy as np

import graspless
from graspless import planning, slide
from graspless.robot import Robot, builtin

kr5 = Robot.from_urdf_file(str(builtin("kr5_t42")))
angles = 2 * np.pi * np.arange(100) / 100
ring = np.column_stack([np.cos(angles), np.sin(angles)])
table = slide.Support(0.35 * ring + [0.65, 0.0], np.eye(4))
plate = slide.Object.from_polygon("plate", 0.055 * ring, thickness=0.006)
X_WO = np.eye(4)
X_WO[:3, 3] = [0.60, -0.05, 0.0]
problem = slide.Problem(kr5, slide.Hand(), plate, table, X_WO, kr5.state("home"))

plan = slide.plan(problem, slide.Options(), planning.Budget(seconds=10, seed=1))
print(plan.status, plan.reason)
for fault in graspless.check(plan):
    print(fault)
