# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a worker does: reads a task, plans it, checks the plan, and says what came of it."""

from __future__ import annotations

import contextlib
import faulthandler
import hashlib
import os
import time
import warnings
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import files
from ..errors import TaskError
from ..tasks.digest import digest

if TYPE_CHECKING:
    from collections.abc import Iterator

    from ..tasks import Task

Row = dict[str, Any]
MOST_FAULTS = 5  # of check(), kept in a row
LATE = "EXIT(1)"  # how a process ends that is watched, in the words of loky
FOREVER = 1e9  # [s]; a watch cannot be set to much more

BAD_TASK = "bad_task"  # the task file is not as it may be
CRASHED = "crashed"  # the worker process ended
TIMED_OUT = "timed_out"  # the worker process was ended
FAILED = "failed"  # an exception that is a fault of ours
STATUSES = (BAD_TASK, CRASHED, TIMED_OUT, FAILED)  # beside those of plans: there is no plan file


@dataclass(frozen=True)
class Job:
    """A task on its way to a worker.

    Attributes
    ----------
    name : str
        In the output.
    path : str
        The task file; where `document` is given, for errors alone.
    changes : dict
        Of `Task.with_changes`.
    known : str or None
        Hash of the task of which there is a plan already.
    document : dict or None
        The whole task, for a worker that does not see our files.
    output : str or None
        The folder that the worker writes the plan to, where it has one in common with us.
    fault : str or None
        Why the task is not as it may be, where that is known before.
    patience : float or None
        How long the task may take beyond its own budget [s].
    """

    name: str
    path: str
    changes: dict[str, Any] = field(default_factory=dict)
    known: str | None = None
    document: dict[str, Any] | None = None
    output: str | None = None
    fault: str | None = None
    patience: float | None = None


@dataclass(frozen=True)
class Outcome:
    """What became of a job: a row of the manifest, and the plan's text unless it is written.

    Without a row, the plan that is there stands.
    """

    name: str
    row: Row | None = None
    plan: str | None = None


def carry_out(job: Job) -> Outcome:
    """Reads, plans and checks; no fault of a task leaves it.

    Raises
    ------
    TaskError
        The plan cannot be written.
    """
    start = time.perf_counter()
    with warnings.catch_warnings(record=True) as caught, _watched(job.patience):
        warnings.simplefilter("always")
        try:
            outcome = _carry_out(job)
        except TaskError as error:
            outcome = without_plan(job, BAD_TASK, str(error))
        except Exception as error:
            outcome = without_plan(job, FAILED, f"{type(error).__name__}: {error}")
    if outcome.row is None:
        return outcome
    told = [str(warning.message) for warning in caught if warning.category is UserWarning]
    row = outcome.row | {"warnings": told, "total_seconds": time.perf_counter() - start}
    if outcome.plan is None or job.output is None:
        return replace(outcome, row=row)
    write(Path(job.output), row, outcome.plan)
    return Outcome(job.name, row)


def without_plan(job: Job, status: str, reason: str, seconds: float | None = None) -> Outcome:
    """A task that came to no plan, of `STATUSES`; after how long [s], where that is known."""
    row = _row(job, None, status, reason)
    return Outcome(job.name, row if seconds is None else row | {"total_seconds": seconds})


def inline(job: Job) -> Job:
    """The job with its task whole, so that no file of ours but meshes is needed beside it."""
    try:
        return replace(job, document=_read(job).to_dict(), changes={})
    except TaskError as error:
        return replace(job, fault=str(error))


def hash_of(task: Task) -> str:
    """The same for tasks that say the same in the end, whatever files they are written in."""
    return digest(task.to_dict())


def sha256(data: bytes) -> str:
    """In hexadecimal digits."""
    return hashlib.sha256(data).hexdigest()


def is_row(row: Row) -> bool:
    """Whether a row of a manifest is as this version writes them, and not somebody else's."""
    return all(
        key in row and isinstance(row[key], (type(empty), *_MAY_BE.get(key, ())))
        for key, empty in _empty_row().items()
    )


def _carry_out(job: Job) -> Outcome:
    from .. import plans

    task = _read(job)
    digest = hash_of(task)
    if digest == job.known:
        return Outcome(job.name)
    if job.patience is not None:
        _watch(job.patience + task.budget.seconds)
    plan = plans.plan(task)
    faults = plans.check(plan) if plan else []
    row = _row(job, digest, plan.status, plan.reason) | {
        "seconds": float(plan.statistics.get("seconds", 0.0)),
        "seed": task.seed,
        "plan": plan_file(job.name),
        "holds": bool(plan) and not faults,
        "faults": faults[:MOST_FAULTS],
    }
    text = plan.to_json()
    return Outcome(job.name, row | {"plan_hash": sha256(text.encode())}, text)


def plan_file(name: str) -> str:
    """Of a task of this name, in the output."""
    return f"{name}.plan.json"


def write(output: Path, row: Row, plan: str) -> None:
    """Writes the plan of a row, whole or not at all; raises TaskError."""
    path = output / row["plan"]
    make_folder(path.parent)
    files.write(path, plan)


def make_folder(path: Path) -> None:
    """With those above it; raises TaskError."""
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise TaskError(f"{path}: cannot be written: {error.strerror}") from None


def sweep(output: Path) -> None:
    """Removes what processes that were killed had begun to write."""
    for path in output.rglob(plan_file(".*") + ".*"):
        path.unlink(missing_ok=True)


def _read(job: Job) -> Task:
    from ..tasks import load_task, task_from_dict

    if job.fault is not None:
        raise TaskError(job.fault)
    if job.document is not None:
        return task_from_dict(job.document, job.path)
    task = load_task(job.path)
    return task.with_changes(**job.changes)


def _row(job: Job, digest: str | None, status: str, reason: str) -> Row:
    said = {"name": job.name, "task": job.path, "hash": digest, "status": status, "reason": reason}
    return _empty_row() | said


def _empty_row() -> Row:
    return {
        "name": "",
        "task": "",
        "hash": None,
        "status": "",
        "reason": "",
        "seconds": None,
        "seed": None,
        "plan": None,
        "plan_hash": None,
        "holds": False,
        "faults": [],
        "warnings": [],
        "total_seconds": None,
    }


_MAY_BE: dict[str, tuple[type, ...]] = {  # beside None
    "hash": (str,),
    "seconds": (int, float),
    "seed": (int,),
    "plan": (str,),
    "plan_hash": (str,),
    "total_seconds": (int, float),
}


@contextlib.contextmanager
def _watched(seconds: float | None) -> Iterator[None]:
    """Ends this process unless the work in it is done in time; also while C++ holds the GIL."""
    if seconds is not None:
        _watch(seconds)
    try:
        yield
    finally:
        if seconds is not None:
            faulthandler.cancel_dump_traceback_later()


def _watch(seconds: float) -> None:
    global _nowhere
    if _nowhere is None:
        _nowhere = os.open(os.devnull, os.O_WRONLY)
    faulthandler.dump_traceback_later(min(seconds, FOREVER), exit=True, file=_nowhere)


_nowhere: int | None = None  # a descriptor that stays open for as long as a watch may need it
