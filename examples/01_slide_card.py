# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A task file from Python: five lines from a task to a checked plan."""

from pathlib import Path

import graspless

task = graspless.load_task(Path(__file__).with_suffix(".yaml"), "slide")
plan = graspless.plan(task, seed=1)
assert plan, plan.reason
assert graspless.check(plan) == []

print(f"{plan.status}: {plan.overhang * 100:.1f} cm over the edge")
for segment in plan.segments:
    rows, joints = segment.positions.shape
    print(f"{segment.name:10}{rows:4} rows of {joints} joints")
