# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Disturbs batches in every way that a machine has, and shows that nothing is lost or done twice.

Prints a row per case. A case is passed if in the end every task has exactly one row and one whole
plan, equal to that of an undisturbed batch but for its times; rows that were written before a fault
are still there, so that their tasks were not planned again; and no process or half file is left.

    python tests/torture/batch.py                # 1000 tasks per case, about 20 minutes
    python tests/torture/batch.py --tasks 40 --cases worker disk
"""

import argparse
import contextlib
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "examples" / "01_slide_card.yaml"
CLOCK = re.compile(rb'("\w*seconds": )[^,\n}]+')  # fields of a plan that may differ
JUMPS = """
import itertools, time
jumps, clock, clock_ns = itertools.cycle((0, 86400, -86400, 3e8, -3e8)), time.time, time.time_ns
time.time = lambda: clock() + next(jumps)
time.time_ns = lambda: clock_ns() + int(next(jumps) * 1e9)
"""
OBEDIENT = ["setpriv", "--bounding-set", "-dac_override"]  # makes root obey permissions


class Batch:
    """A folder of tasks and the batches that plan them."""

    def __init__(self, folder, count):
        self.folder, self.tasks, self.output = folder, folder / "tasks", folder / "plans"
        self.count, self.runs, self.before = count, 0, {}
        self.tasks.mkdir(parents=True)
        for i in range(count):
            (self.tasks / f"card_{i:04}.yaml").write_text(task(i))

    def start(self, *flags, prefix=(), **options):
        """Starts a batch, and notes the rows that are there already."""
        self.before, self.runs = self.rows() | self.before, self.runs + 1
        where = () if "--dask" in flags else ("--jobs", "2")
        command = ["batch", str(self.tasks), "-o", str(self.output), "--json", *where, *flags]
        return subprocess.Popen(
            [*prefix, sys.executable, "-m", "graspless", *command],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
            **options,
        )  # fmt: skip

    def finish(self, *flags, **options):
        """Runs a batch to its end; returns its exit code and its last line on stderr."""
        process = self.start(*flags, **options)
        _, err = process.communicate()
        assert members(process.pid) == [], "a process is left"
        return process.returncode, err.strip().rpartition("\n")[2]

    def rows(self):
        """Rows that are written, by name."""
        found = {}
        with contextlib.suppress(FileNotFoundError):
            for line in (self.output / "batch.jsonl").read_text().splitlines():
                with contextlib.suppress(ValueError):
                    row = json.loads(line)
                    found[row["name"]] = row
        return found

    def wait(self, process, share):
        """Waits until a share of all tasks has a row, or the batch has ended."""
        while process.poll() is None and len(self.rows()) < share * self.count:
            time.sleep(0.02)
        return len(self.rows())

    def faults(self, expected):
        """Returns what is wrong in the end. `expected` are the plans of an undisturbed batch."""
        found, rows = [], self.rows()
        lines = (self.output / "batch.jsonl").read_text().splitlines()
        found += [] if len(lines) == len(rows) else [f"{len(lines) - len(rows)} rows twice"]
        for i in range(self.count):
            name = f"card_{i:04}"
            if name not in rows or rows[name]["status"] != "solved":
                found.append(f"{name} is lost")
            elif plan_of(self.output, name) != expected[name]:
                found.append(f"{name} has another plan")
        again = [name for name, row in self.before.items() if rows.get(name) != row]
        found += [f"{name} was planned again" for name in again]
        found += [f"{path.name} is left" for path in self.output.rglob(".*")]
        return found


def task(seed):
    return re.sub(r"seed: \d+", f"seed: {seed}", EXAMPLE.read_text())


def plan_of(folder, name):
    """Returns the bytes of a plan without its times."""
    try:
        return CLOCK.sub(rb"\1T", (folder / f"{name}.plan.json").read_bytes())
    except FileNotFoundError:
        return None


def members(session):
    """Processes of a session after a second, which workers have to end in."""
    for _ in range(50):
        found = []
        for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
            with contextlib.suppress(OSError):
                state, _, _, leader = stat.read_text().rpartition(")")[2].split()[:4]
                if int(leader) == session and state != "Z":
                    found.append(int(stat.parent.name))
        if not found:
            break
        time.sleep(0.02)
    return found


def workers(process):
    """Worker processes of a batch."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            parent = int((path / "stat").read_text().rpartition(")")[2].split()[1])
            if parent == process.pid and b"LokyProcess" in (path / "cmdline").read_bytes():
                found.append(int(path.name))
    return found


def undisturbed(batch):
    code, _ = batch.finish()
    return f"exit code {code}"


def worker(batch):
    """kill -9 of a worker, three times."""
    process, killed = batch.start(), 0
    for share in (0.2, 0.5, 0.8):
        batch.wait(process, share)
        for pid in workers(process)[:1]:
            os.kill(pid, signal.SIGKILL)
            killed += 1
    process.communicate()
    crashed = {name for name, row in batch.rows().items() if row["status"] == "crashed"}
    code, _ = batch.finish()  # a task whose process is killed while it is alone there has crashed
    batch.before = {name: row for name, row in batch.before.items() if name not in crashed}
    return f"{killed} workers killed, exit code {process.returncode}, then {code}"


def scheduler(batch):
    """kill -9 of the batch itself, three times."""
    told = []
    for share in (0.2, 0.5, 0.8):
        process = batch.start()
        batch.wait(process, share)
        process.kill()
        process.communicate()
        told.append(len(batch.rows()))
        assert members(process.pid) == [], "a worker is left"
    code, _ = batch.finish()
    return f"killed after {told} rows, then exit code {code}"


def dask(batch):
    """kill -9 of a Dask worker, then of the scheduler."""
    codes = []
    for is_killed in (True, False):
        with cluster() as (address, head, nanny):
            process = batch.start("--dask", address)
            batch.wait(process, 0.2)
            if is_killed:
                subprocess.run(["pkill", "-9", "-P", str(nanny.pid)], check=False)  # its children
                batch.wait(process, 0.5)
                head.kill()
            process.communicate()
            codes.append(process.returncode)
    return f"exit codes {codes}"


@contextlib.contextmanager
def cluster():
    """A Dask scheduler and two workers with their nannies, as processes."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{probe.getsockname()[1]}"
    run = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--no-dashboard"]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "start_new_session": True}
    head = subprocess.Popen([*run, "--host", address], **quiet)
    run = [sys.executable, "-m", "distributed.cli.dask_worker", address, "--no-dashboard"]
    nanny = subprocess.Popen([*run, "--nthreads", "1", "--nworkers", "2"], **quiet)
    try:
        ready = (
            f"import distributed as d; d.Client({address!r}, timeout=90).wait_for_workers(2, 90)"
        )
        subprocess.run([sys.executable, "-c", ready], check=True, stderr=subprocess.DEVNULL)
        yield address, head, nanny
    finally:
        for process in (nanny, head):
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()


def disk(batch):
    """A full disk: a small file system if this user may mount one, otherwise a limit of files."""
    batch.output.mkdir()
    size = batch.count * 30_000  # half of what the plans need
    mount = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(batch.output)]
    if subprocess.run(mount, capture_output=True).returncode:
        small = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (60_000, 60_000))  # noqa: E731
        code, told = batch.finish(preexec_fn=small)
    else:
        code, told = batch.finish()
        subprocess.run(["mount", "-o", "remount,size=1g", str(batch.output)], check=True)
    before, half = len(batch.rows()), list(batch.output.rglob(".*"))
    again, _ = batch.finish()
    message = told.rpartition(": ")[2]
    assert (code, half) == (2, [])
    return f"exit code 2 ({message}) after {before} rows, then {again}"


def read_only(batch):
    """A folder that becomes read-only while its plans are written."""
    batch.output.mkdir()
    process = batch.start(prefix=OBEDIENT if os.getuid() == 0 else [])
    batch.wait(process, 0.5)
    batch.output.chmod(0o555)
    _, err = process.communicate()
    before = len(batch.rows())
    batch.output.chmod(0o755)
    code, _ = batch.finish()
    message = err.strip().rpartition(": ")[2]
    return f"exit code {process.returncode} ({message}) after {before} rows, then {code}"


def clock(batch):
    """A clock that jumps by days and years, forwards and backwards, at every look."""
    site = batch.folder / "site"
    site.mkdir()
    (site / "sitecustomize.py").write_text(JUMPS)
    paths = [str(site), os.environ.get("PYTHONPATH", "")]
    code, _ = batch.finish(env=os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, paths))})
    return f"exit code {code}"


def changing(batch):
    """Every 5th task file is written anew all the time, in two parts."""
    process, writes = batch.start(), 0
    paths = sorted(batch.tasks.iterdir())[::5]
    while process.poll() is None:
        texts = [task(10**6 + writes + i) for i in range(len(paths))]
        for keep in (slice(len(texts[0]) // 2), slice(None)):
            for path, text in zip(paths, texts, strict=True):
                path.write_text(text[keep])
            time.sleep(0.05)
        writes += len(paths)
    process.communicate()
    for path in paths:
        path.write_text(task(int(path.stem.partition("_")[2])))
    code, _ = batch.finish()
    for path in paths:
        del batch.before[path.stem]
    return f"{writes} writes, exit code {process.returncode}, then {code}"


CASES = {
    "undisturbed": undisturbed,
    "worker": worker,
    "scheduler": scheduler,
    "dask": dask,
    "disk": disk,
    "read_only": read_only,
    "clock": clock,
    "changing": changing,
}


def torture(folder, count, names=tuple(CASES)):
    """Yields (case, what happened, faults, seconds) for some cases."""
    expected = None
    for name in dict.fromkeys(("undisturbed", *names)):
        start, batch = time.monotonic(), Batch(folder / name, count)
        try:
            told = CASES[name](batch)
            if expected is None:
                rows = batch.rows()
                expected = {row: plan_of(batch.output, row) for row in rows}
            faults = batch.faults(expected)
        finally:
            subprocess.run(["umount", str(batch.output)], capture_output=True)
        shutil.rmtree(batch.folder)
        yield name, told, faults, time.monotonic() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--tasks", type=int, default=1000, help="number of tasks per case")
    parser.add_argument("--cases", nargs="+", default=list(CASES), choices=list(CASES))
    options = parser.parse_args()
    print("| case | what happened | lost or twice | time |\n|---|---|---|---|")
    code = 0
    with tempfile.TemporaryDirectory() as name:
        pathlib.Path(name).chmod(0o755)
        for case, told, faults, seconds in torture(
            pathlib.Path(name), options.tasks, options.cases
        ):
            wrong = ", ".join(faults[:5]) or "nothing"
            print(f"| {case} | {told} | {wrong} | {seconds:.0f} s |", flush=True)
            code |= bool(faults)
    return code


if __name__ == "__main__":
    sys.exit(main())
