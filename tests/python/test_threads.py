# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Eight Python threads that plan on one robot and one object: the plans of a thread that plans alone."""

from concurrent.futures import ThreadPoolExecutor

import pytest

import graspless
from clasp_common import PURSE
from fingertip_common import PUSH
from graspless._data import directory
from graspless.planning import Budget
from graspless.tasks import read_task
from tasks_common import GOOD, changed, without_clock

SEEDS = (1, 2)
TASKS = {
    "slide": lambda: read_task(GOOD, "slide.yaml"),
    "fingertip": lambda: read_task(
        changed("locations_per_side: 5", "locations_per_side: 5, threads: 2", PUSH),
        "fingertip.yaml",
    ),
    "carried fingertips": lambda: graspless.load_task(directory("examples") / "12_t42_tumble.yaml"),
    "clasp": lambda: read_task(PURSE, "clasp.yaml"),
    "carry": lambda: graspless.load_task(directory("examples") / "24_carry_bar.yaml"),
}


@pytest.mark.parametrize("name", TASKS)
def test_threads_share_a_task(name):
    task = TASKS[name]()

    def plan(seed):
        found = graspless.plan(task, budget=Budget(seconds=60, seed=seed))
        return without_clock(found), graspless.check(found)

    alone = [plan(seed) for seed in SEEDS]
    assert all(faults == [] for _, faults in alone)
    with ThreadPoolExecutor(8) as pool:
        together = list(pool.map(plan, SEEDS * 4))
    assert together == alone * 4
