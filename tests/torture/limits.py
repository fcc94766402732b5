# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Limits of time and memory, and signals, over random tasks.

    .venv/bin/python tests/torture/limits.py [--tasks 500] [--seed 1] [--kind slide]

Each task runs twice as `graspless plan`: with its time limit, and with none but a signal. Prints a
line a kind, and the worst tasks. On a loaded machine the figures show its load.
"""

from __future__ import annotations

import argparse
import contextlib
import dataclasses
import importlib
import json
import os
import random
import resource
import shutil
import signal
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import tasks

MOST_MEMORY = 6e9  # of a process [bytes]: this script must not take the machine with it
LONGEST_WAIT = 1.5  # before a signal [s]
GIVEN_UP = 60.0  # [s]


@dataclasses.dataclass
class Run:
    """Result of one process."""

    kind: str
    name: str
    seconds: float = 0.0  # the time limit
    planned: float = 0.0  # until the plan was there, or the reason for none [s]
    whole: float = 0.0  # of the command, with the check of a plan that was found [s]
    cpu: float = 0.0  # until the plan was there [s]
    memory: float = 0.0  # peak over what the process had before [bytes]
    search: float = 0.0  # peak over what it had when the task was read [bytes]
    asked: float = 4e9  # options.max_memory [bytes]
    status: str = ""
    latency: float | None = None  # from the signal to the end of the process [s]
    fault: str = ""

    @property
    def overrun(self) -> float:
        """Time beyond the limit [s]."""
        return max(0.0, self.planned - self.seconds)


def warm_up() -> None:
    """Imports what every command imports, so that children of a fork begin at once."""
    names = ["__main__", "cli", "cli.plan", "_api", "report", "limits"]
    names += [f"{room}{kind}" for kind in tasks.KINDS for room in ("", "tasks.", "plan_files.")]
    for name in names:
        importlib.import_module(f"graspless.{name}")


def _memory(name: str) -> float:
    """Returns a value of /proc/self/status [bytes]."""
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(name + ":"):
            return float(line.split()[1]) * 1024
    return 0.0


def _quiet(folder: Path) -> None:
    """In a child: its folder, its bound on memory, and nowhere for its output."""
    os.chdir(folder)
    most = int(_memory("VmSize") + MOST_MEMORY)
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in (1, 2):
        os.dup2(nowhere, stream)


def _measure(path: Path, seconds: float) -> dict[str, Any]:
    """In a child: plans once; returns fields of a Run."""
    from graspless import _api, cli
    from graspless.__main__ import prepare

    prepare()
    found: dict[str, Any] = {}
    Path("/proc/self/clear_refs").write_text("5")
    before, cpu = _memory("VmRSS"), time.process_time()
    began = time.monotonic()

    def begin(*given: Any) -> Any:
        found["search"] = -_memory("VmRSS")
        return note(search(*given))

    def note(plan: Any = None) -> Any:
        found.setdefault("planned", time.monotonic() - began)
        found.setdefault("cpu", time.process_time() - cpu)
        found.setdefault("memory", max(0.0, _memory("VmHWM") - before))
        if found.get("search", 0.0) < 0:
            found["search"] += _memory("VmHWM")
        if plan is not None:
            found["status"] = str(plan.status)
        return plan

    search = _api.plan_since
    _api.plan_since = begin
    code = cli.main(["plan", path.name, "-o", f"{path.stem}.json", "--time", str(seconds)])
    note()
    found["whole"] = time.monotonic() - began
    found.setdefault("status", f"exit {code}")
    if code not in (0, 1):
        found["fault"] = f"exit code {code}"
    return found


def run_limited(kind: str, path: Path, seconds: float) -> Run:
    """Plans a task within its time limit, in a process of its own."""
    options = json.loads(path.read_text()).get("options", {})
    run = Run(kind, path.stem, seconds, asked=options.get("max_memory", 4e9))
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        with contextlib.suppress(BaseException):
            _quiet(path.parent)
            os.write(writer, json.dumps(_measure(path, seconds)).encode())
        os._exit(0)
    os.close(writer)
    code = _wait(child, GIVEN_UP + seconds)
    with os.fdopen(reader) as told:
        answer = told.read()
    for name, value in json.loads(answer or "{}").items():
        setattr(run, name, value)
    if not answer:
        run.fault, run.planned = f"ended with {code}", seconds + GIVEN_UP
    return run


def run_interrupted(run: Run, path: Path, number: int, wait: float) -> None:
    """Plans a task without a time limit, and sends a signal after `wait` [s]."""
    output = path.with_suffix(".json")
    output.unlink(missing_ok=True)
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            _quiet(path.parent)
            sys.argv = ["graspless", "plan", path.name, "-o", output.name, "--time", "1000"]
            os.write(writer, b"ready")
            os._exit(sys.modules["graspless.__main__"].main())
        finally:
            os._exit(70)
    os.read(reader, 5)
    os.close(reader)
    os.close(writer)
    time.sleep(max(0.01, wait))
    sent = time.monotonic()
    os.kill(child, number)
    code = _wait(child, GIVEN_UP)
    if code in (0, 1):  # it had ended before
        return
    run.latency = time.monotonic() - sent
    if code != 128 + number:
        run.fault += f" {signal.Signals(number).name} gave {code}"
    if output.exists():
        json.loads(output.read_text())
    left = [other.name for other in path.parent.iterdir() if other.name.startswith(".")]
    if left:
        run.fault += f" left {left}"


def _wait(child: int, seconds: float) -> int:
    """Returns the exit code of a child, which is killed after that long."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.001)
    os.kill(child, signal.SIGKILL)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def run_one(seed: int, index: int, folder: Path, interrupts: bool = True) -> Run:
    """Draws a task and runs it both ways."""
    own = folder / str(index)
    own.mkdir()
    kind, path, seconds = tasks.draw(seed, index, own)
    run = run_limited(kind, path, seconds)
    if interrupts:
        rng = random.Random(f"signal {seed} {index}")
        number = rng.choice([signal.SIGINT, signal.SIGTERM])
        run_interrupted(run, path, number, rng.uniform(0, LONGEST_WAIT))
    shutil.rmtree(own)
    return run


def table(runs: list[Run]) -> str:
    """Returns a line a kind."""
    lines = [
        f"{'kind':10}{'tasks':>6}{'solved':>8}{'signals':>9}{'overrun':>10}{'latency':>10}"
        f"{'memory':>11}{'beyond':>10}{'faults':>8}"
    ]
    for kind in [*tasks.KINDS, "all"]:
        mine = [run for run in runs if kind in (run.kind, "all")]
        if not mine:
            continue
        latencies = [run.latency for run in mine if run.latency is not None]
        beyond = max(0.0, *(run.search - run.asked for run in mine)) if mine else 0.0
        lines.append(
            f"{kind:10}{len(mine):6}{sum(run.status == 'solved' for run in mine):8}"
            f"{len(latencies):9}{max(run.overrun for run in mine) * 1e3:7.0f} ms"
            f"{max(latencies, default=0) * 1e3:7.0f} ms"
            f"{max(run.memory for run in mine) / 1e6:8.0f} MB{beyond / 1e6:7.0f} MB"
            f"{sum(bool(run.fault) for run in mine):8}"
        )
    return "\n".join(lines)


def worst(runs: list[Run], count: int = 5) -> str:
    """Returns the worst runs by each measure, with what was drawn."""
    lines = []
    for name, key in (
        ("overrun", lambda run: run.overrun),
        ("latency", lambda run: run.latency or 0.0),
        ("memory beyond the limit", lambda run: run.search - run.asked),
    ):
        lines.append(f"worst {name}:")
        lines += [f"  {run}" for run in sorted(runs, key=key, reverse=True)[:count]]
    return "\n".join(lines + [f"fault: {run}" for run in runs if run.fault])


def main() -> int:
    """Prints the table; 1 if a process did what none may."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tasks", type=int, default=500, metavar="N")
    parser.add_argument("--seed", type=int, default=1, metavar="N")
    parser.add_argument("--only", type=int, metavar="INDEX", help="one task alone")
    parser.add_argument("--json", action="store_true", help="print the runs, not the table")
    parser.add_argument("--kind", choices=tasks.KINDS, help="tasks of one kind alone")
    options = parser.parse_args()
    warm_up()
    indices = range(options.tasks) if options.only is None else [options.only]
    kinds = list(tasks.KINDS)
    runs = []
    folder = Path(tempfile.mkdtemp(prefix="graspless_limits_"))
    try:
        for index in indices:
            if options.kind in (None, kinds[index % len(kinds)]):
                runs.append(run_one(options.seed, index, folder))
    finally:
        shutil.rmtree(folder)
    if options.json:
        print(json.dumps([dataclasses.asdict(run) for run in runs]))
    else:
        print(f"{table(runs)}\n{worst(runs)}")
    return int(any(run.fault for run in runs))


if __name__ == "__main__":
    sys.exit(main())
