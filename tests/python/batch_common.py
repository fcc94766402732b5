# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pools and work for the tests of batches, where worker processes can import them."""

import os
import signal
import time
from concurrent.futures import Future

from graspless.batches import work

KILLER = "killer"  # tasks of this name end their worker
EXITS = "exits"
HANGS = "hangs"


class Here:
    """A pool without processes: what it is given is done at once."""

    workers = capacity = 1
    is_elsewhere = False
    crashes = ()

    def submit(self, work, given):
        future = Future()
        future.set_result(work(given))
        return future

    def look(self):
        pass

    def close(self, at_once=False):
        pass


def dangerous(job):
    """As the batch does it, but for tasks that are called after what they do."""
    if job.name.startswith(KILLER):
        os.kill(os.getpid(), signal.SIGSEGV)
    if job.name.startswith(EXITS):
        os._exit(3)
    if job.name.startswith(HANGS):
        with work._watched(job.patience):
            time.sleep(60)
    return work.carry_out(job)


def square(number):
    """Ends its process for 3, with whatever else is done there."""
    if number == 3:
        time.sleep(0.2)
        os._exit(1)
    return number * number


def unlucky(path):
    """Ends its process the first time."""
    if not os.path.exists(path):
        open(path, "w").close()
        os._exit(1)
    return path


def fails(number):
    raise ArithmeticError(f"{number} is wrong")


def sleeps(seconds):
    time.sleep(seconds)
