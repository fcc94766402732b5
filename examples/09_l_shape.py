# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A mesh from trimesh, a plan for every friction in an interval, and what others would need."""

from pathlib import Path
from typing import Any

import numpy as np
import trimesh

from graspless import fingertip

mesh: Any = trimesh.load(Path(__file__).with_suffix(".obj"), force="mesh")
mesh.apply_scale(0.001)  # the file is in millimetres
bracket = fingertip.Object.from_mesh("bracket", mesh, mass=0.9 * 1000 * mesh.volume)
motion = fingertip.slide_path(np.eye(4), [0, 0.12, 0], segments=24)
options = fingertip.Options(location_spacing=0.012, min_stability=0.2)
for friction in (0.4, (0.35, 0.45)):
    problem = fingertip.Problem(
        object=bracket,
        motion=motion,
        fingers=fingertip.Fingers(radius=0.008, max_normal_force=8, friction=0.7),
        friction=friction,
    )
    plan = fingertip.plan(problem, options)
    if plan:
        faults = fingertip.check(problem, plan, options)
        print(f"friction {friction}: cost {plan.cost:.4f}, faults {faults}")
    else:
        print(f"friction {friction}: {plan.reason}; blocked by {plan.limit}: {plan.relaxations}")
