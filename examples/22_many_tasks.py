# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A card in many places on the table, each a task file: a batch plans them all.

    python 22_many_tasks.py [DIR COUNT]

With a folder, COUNT tasks are written there and that is all: `graspless batch DIR -o plans`.
"""

import sys
import tempfile
from pathlib import Path

import numpy as np

import graspless

TASK = """\
kind: slide
robot: {{urdf: wam_t42}}
object:
  rectangle: {{size: [0.12, 0.08]}}
  thickness: 0.003
  pose: {{x: {:.4f}, y: {:.4f}, yaw: {:.4f}}}
support: {{rectangle: {{center: [0.65, 0.0], size: [0.7, 0.7]}}}}
budget: {{seconds: 10, seed: {}}}
"""


def write_tasks(folder: Path, count: int) -> None:
    """Cards evenly at random, the same for the same count."""
    folder.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(1)
    for seed in range(count):
        pose = random.uniform([0.48, -0.22, -np.pi], [0.82, 0.22, np.pi])
        (folder / f"card_{seed:04}.yaml").write_text(TASK.format(*pose, seed), encoding="utf-8")


if len(sys.argv) == 3:
    write_tasks(Path(sys.argv[1]), int(sys.argv[2]))
    sys.exit()

with tempfile.TemporaryDirectory() as folder:
    tasks, plans = Path(folder, "tasks"), Path(folder, "plans")
    write_tasks(tasks, 8)
    summary = graspless.batch(tasks, plans, jobs=2)
    assert summary, summary.as_text()
    print(summary.as_text())
    assert graspless.batch(tasks, plans).kept == 8  # they stand: nothing is planned again
    assert not graspless.check(plans / "card_0000.plan.json")
