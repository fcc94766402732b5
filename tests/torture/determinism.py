# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans the same tasks under different conditions and compares the plan files byte by byte.

Prints one row per kind of task and one column per condition: the number of plans that equal those
of the first process. Fields whose names end in `seconds` may differ. Exit code 1 if others do.

    python tests/torture/determinism.py                    # 100 plans per kind, about half an hour
    python tests/torture/determinism.py --plans 3 --kinds slide carry
"""

import argparse
import contextlib
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
KINDS = {  # the examples that tasks are made of
    "slide": ("01_slide_card", "02_kr5", "03_tilted_l_table", "04_clutter", "05_point_cloud"),
    "fingertip": ("06_push_block", "07_tumble_regrasp", "08_cork_cuboid", "09_l_shape",
                  "10_prism_corner", "12_t42_tumble"),
    "clasp": ("13_clasp_purse", "15_pull_chair", "16_clasp_in_clutter", "17_wam_clasp"),
    "carry": ("24_carry_bar",),
    "chain": ("19_slide_then_lift", "20_tumble_then_slide", "21_clasp_then_drag"),
}  # fmt: skip
CLOCK = re.compile(rb'("\w*seconds": )[^,\n}]+')  # a field that may differ
THREADS = re.compile(rb'("threads": )\d+')  # a part of the task that a condition changes
UNSOLVED = 7  # every 7th task gets few iterations, so that failures are compared, too


@dataclass(frozen=True)
class Condition:
    """How the tasks are planned."""

    name: str
    environment: tuple[tuple[str, str], ...] = ()
    order: str = "given"
    callers: int = 1  # Python threads that plan at the same time
    threads: int = 1  # option of the fingertip planner
    load: int = 0  # other processes that keep the cores busy
    processes: int = 1  # one after the other, each for a part of the tasks


CONDITIONS = (
    Condition("second process"),
    Condition("hash seed 1", (("PYTHONHASHSEED", "1"),)),
    Condition("hash seed 4711", (("PYTHONHASHSEED", "4711"),)),
    Condition("reverse order", order="reverse"),
    Condition("random order", order="random"),
    Condition("10 processes", processes=10),
    Condition("2 callers", callers=2),
    Condition("8 callers", callers=8),
    Condition("2 threads", (("OMP_NUM_THREADS", "2"), ("OPENBLAS_NUM_THREADS", "2")), threads=2),
    Condition("8 threads", (("OMP_NUM_THREADS", "8"), ("OPENBLAS_NUM_THREADS", "8")), threads=8),
    Condition("load of 4", load=4),
)


def make_task(kind, i, threads=1):
    """Returns the fields of task `i`: an example with another seed, pose and numbers."""
    from graspless.tasks.reading import read_yaml

    names = KINDS[kind]
    fields = read_yaml(EXAMPLES / f"{names[i % len(names)]}.yaml").data
    rng = random.Random(i)
    fields["budget"] = {"seconds": 3600, "seed": i}
    if i % UNSOLVED == UNSOLVED - 1:
        fields["budget"]["iterations"] = rng.randrange(1, 20)
    thing = fields.get("object", {})
    if "yaw" in thing.get("pose", {}):
        thing["pose"]["yaw"] += rng.uniform(-0.3, 0.3)
    if "rpy" in thing.get("pose", {}):
        thing["pose"]["rpy"][2] += rng.uniform(-0.1, 0.1)
    if "mass" in thing:
        thing["mass"] *= rng.uniform(0.9, 1.1)
    if "offset" in fields:
        fields["offset"][1] += rng.uniform(-0.03, 0.03)
    for part in (fields, *fields.get("stages", ())):
        if part["kind"] == "fingertip":
            part.setdefault("options", {})["threads"] = threads
    return fields


def work(kind, indices, callers, threads, folder):
    """Plans tasks in this process, and writes every plan without its times to `folder`."""
    import graspless

    def one(i):
        text = graspless.plan(make_task(kind, i, threads)).to_json().encode()
        text = THREADS.sub(rb"\1N", CLOCK.sub(rb"\1T", text))
        (pathlib.Path(folder) / f"{i}.json").write_bytes(text)

    os.chdir(EXAMPLES)  # which name files beside them
    if callers == 1:
        for i in indices:
            one(i)
        return
    with ThreadPoolExecutor(callers) as pool:
        list(pool.map(one, indices))


def run(kind, count, condition, folder):
    """Plans `count` tasks under a condition, in processes of their own."""
    indices = list(range(count))
    if condition.order == "reverse":
        indices.reverse()
    elif condition.order == "random":
        random.Random(count).shuffle(indices)
    environment = os.environ | {"PYTHONHASHSEED": "0", "OMP_NUM_THREADS": "1"}
    environment |= dict(condition.environment)
    with _busy(condition.load):
        for k in range(condition.processes):
            part = indices[k :: condition.processes]
            job = [kind, part, condition.callers, condition.threads, str(folder)]
            subprocess.run(
                [sys.executable, __file__, "--work", json.dumps(job)], env=environment, check=True
            )


@contextlib.contextmanager
def _busy(number):
    """Keeps the cores busy with other processes during the block."""
    others = [
        subprocess.Popen([sys.executable, "-c", "while True: pass"], start_new_session=True)
        for _ in range(number)
    ]
    try:
        yield
    finally:
        for other in others:
            other.kill()
            other.wait()


def differences(before, after, count):
    """Returns the tasks whose plans differ, each with the first line that does."""
    found = {}
    for i in range(count):
        a, b = ((folder / f"{i}.json").read_bytes() for folder in (before, after))
        if a != b:
            pairs = zip(a.splitlines() + [b""], b.splitlines() + [b""], strict=False)
            found[i] = next((x, y) for x, y in pairs if x != y)
    return found


def compare(kind, count, conditions=CONDITIONS):
    """Yields the name of each condition with the differences that it makes, by task."""
    with tempfile.TemporaryDirectory() as name:
        first = pathlib.Path(name, "first")
        first.mkdir()
        run(kind, count, Condition("first process"), first)
        for k, condition in enumerate(conditions):
            other = pathlib.Path(name, str(k))
            other.mkdir()
            run(kind, count, condition, other)
            yield condition.name, differences(first, other, count)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--plans", type=int, default=100, help="number of plans per kind")
    parser.add_argument("--kinds", nargs="+", default=list(KINDS), choices=list(KINDS))
    parser.add_argument("--work", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.work is not None:
        work(*json.loads(options.work))
        return 0
    print("| kind |", " | ".join(condition.name for condition in CONDITIONS), "| time |")
    print("|---" * (len(CONDITIONS) + 2) + "|")
    faults = []
    for kind in options.kinds:
        start, cells = time.monotonic(), [kind]
        for name, different in compare(kind, options.plans):
            cells.append(f"{options.plans - len(different)} of {options.plans}")
            faults += [f"{kind} {i}, {name}: {a} / {b}" for i, (a, b) in different.items()]
        cells.append(f"{time.monotonic() - start:.0f} s")
        print("|", " | ".join(cells), "|", flush=True)
    print("\n".join(faults), end="")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
