# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans that nobody holds any more are freed. tests/torture/leaks.py measures memory over thousands."""

import gc

import pytest

import graspless
from graspless._data import directory

EXAMPLES = {
    "slide": "01_slide_card.yaml",
    "fingertip": "06_push_block.yaml",
    "realized": "12_t42_tumble.yaml",
    "clasp": "13_clasp_purse.yaml",
    "carry": "24_carry_bar.yaml",
    "chain": "19_slide_then_lift.yaml",
}


def tracked_objects():
    gc.collect()
    return len(gc.get_objects())


@pytest.mark.parametrize("name", EXAMPLES)
def test_plans_are_freed(name):
    path = directory("examples") / EXAMPLES[name]

    def query():
        plan = graspless.plan(path)
        graspless.check(plan)
        plan.to_json()

    query()  # imports modules and fills caches
    query()
    before = tracked_objects()
    query()
    assert tracked_objects() - before < 10
