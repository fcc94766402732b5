# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""One plan of each kind, as the tests of what executes plans need them."""

import functools
import pathlib

import graspless
from clasp_common import PURSE
from fingertip_common import PUSH, TUMBLE
from graspless.tasks import read_task
from tasks_common import GOOD

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
TASKS = {
    "slide": GOOD,
    "clasp": PURSE,
    "push": PUSH,
    "tumble": TUMBLE,
    "regrasp": (EXAMPLES / "07_tumble_regrasp.yaml").read_text(),
    "carried": (EXAMPLES / "12_t42_tumble.yaml").read_text(),
    "lifted": (EXAMPLES / "19_slide_then_lift.yaml").read_text(),
    "twice": (EXAMPLES / "20_tumble_then_slide.yaml").read_text(),
}


@functools.cache
def planned(name):
    """The plan of one of TASKS."""
    plan = graspless.plan(read_task(TASKS[name], name), seed=1)
    assert plan, plan.reason
    return plan


@functools.cache
def timed(name, **settings):
    """That plan in time."""
    return graspless.time(planned(name), **settings)
