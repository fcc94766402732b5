# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A task file from Python: five lines from a task to a checked plan."""

from pathlib import Path

import graspless

task = graspless.load_task(Path(__file__).with_suffix(".yaml"))
plan = graspless.plan(task, seed=1)
assert plan and not graspless.check(plan)
print(f"{plan.status}: {plan.overhang * 100:.1f} cm over the edge")
for segment in plan.segments:
    print(f"{segment.name:10}{segment.positions.shape[0]:4} rows of {segment.positions.shape[1]} joints")
