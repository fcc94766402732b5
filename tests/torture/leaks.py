# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Resident memory over many queries of one process: flat, or something leaks.

    python tests/torture/leaks.py [--queries 10000] [KIND ...]

Every query reads its task anew, plans with another seed, checks the plan and writes it as JSON. The
first tenth of the queries fills caches and the heap; over the rest, memory may grow by 1 MiB.
Clasps have fewer points and moves than the example, which makes them six times faster.
"""

from __future__ import annotations

import argparse
import ctypes
import gc
import sys
import time
from pathlib import Path

import graspless
from graspless import _data
from graspless.tasks.reading import read_yaml

EXAMPLES = {
    "slide": "01_slide_card.yaml",
    "fingertip": "06_push_block.yaml",
    "clasp": "13_clasp_purse.yaml",
    "carry": "24_carry_bar.yaml",
    "chain": "19_slide_then_lift.yaml",
}
ALLOWED = 1.0  # [MiB]
POINTS = 300  # of the purse
STABILITY = {"sequences": 1, "moves": 20}


def resident() -> float:
    """Resident memory [MiB], after the heap's free pages are given back."""
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096 / 2**20


def query(path: Path, seed: int) -> None:
    """Reads a task, plans, checks and writes the plan."""
    task = read_yaml(path).data | {"budget": {"seconds": 60, "seed": seed}}
    if task["kind"] == "clasp":
        task["object"]["points"] = POINTS
        task["options"] = {"stability": STABILITY}
    plan = graspless.plan(task)
    graspless.check(plan)
    plan.to_json()


def growth(kind: str, queries: int) -> tuple[float, float, float]:
    """Memory after a tenth of the queries and at the end [MiB], and seconds per query."""
    path = _data.directory("examples") / EXAMPLES[kind]
    begin = time.perf_counter()
    for seed in range(queries // 10):
        query(path, seed)
    before = resident()
    for seed in range(queries // 10, queries):
        query(path, seed)
    return before, resident(), (time.perf_counter() - begin) / queries


def main() -> int:
    """Prints a line a kind; the exit code is 1 if memory grew by more than is allowed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kinds", nargs="*", default=list(EXAMPLES), metavar="KIND")
    parser.add_argument("--queries", type=int, default=10_000)
    given = parser.parse_args()
    leaks = 0
    print(f"{'kind':10} {'queries':>8} {'early':>9} {'end':>9} {'growth':>9}   [MiB]  ms/query")
    for kind in given.kinds:
        before, after, seconds = growth(kind, given.queries)
        leaks += after - before > ALLOWED
        print(
            f"{kind:10} {given.queries:8} {before:9.2f} {after:9.2f} {after - before:9.2f}"
            f"          {1e3 * seconds:8.1f}",
            flush=True,
        )
    return leaks > 0


if __name__ == "__main__":
    sys.exit(main())
