# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Work of one worker: read a task, plan it, check the plan, and report the outcome."""

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
MOST_FAULTS = 5  # faults of check() that a row keeps
LATE = "EXIT(1)"  # loky's name for the exit of a process that the watchdog ended
FOREVER = 1e9  # [s]; the watchdog accepts hardly more

# Status of rows without a plan file; other rows have the status of their plan.
BAD_TASK = "bad_task"  # the task file is not valid
CRASHED = "crashed"  # the worker process died
TIMED_OUT = "timed_out"  # the worker process was stopped
FAILED = "failed"  # an exception: a bug in graspless


@dataclass(frozen=True)
class Job:
    """A task on its way to a worker.

    Attributes
    ----------
    name : str
        Name of the task in the output.
    path : str
        Task file. Only used in error messages if `document` is given.
    changes : dict
        Arguments of `Task.with_changes`; `document` has them already.
    known : str or None
        Hash of the task that the existing plan was made for.
    document : dict or None
        The whole task, for a worker that cannot read local files.
    output : str or None
        Folder that the worker writes the plan to; None if it shares no folder with this process.
    fault : str or None
        Error in the task file, if already known.
    patience : float or None
        Time beyond its budget that the task may take [s].
    trust : bool
        Let xacro files read any file and run code.
    prove : int or None
        Number of varied trials of the plan, if it is simulated.
    """

    name: str
    path: str
    changes: dict[str, Any] = field(default_factory=dict)
    known: str | None = None
    document: dict[str, Any] | None = None
    output: str | None = None
    fault: str | None = None
    patience: float | None = None
    trust: bool = False
    prove: int | None = None


@dataclass(frozen=True)
class Outcome:
    """Outcome of a job: a row of the manifest, and the text of the plan unless already written.

    Without a row, the existing plan is still valid.
    """

    name: str
    row: Row | None = None
    plan: str | None = None


def carry_out(job: Job) -> Outcome:
    """Reads a task, plans it and checks the plan. Errors of the task go into the outcome.

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
    told = [str(warning.message) for warning in caught if issubclass(warning.category, UserWarning)]
    row = outcome.row | {"warnings": told, "total_seconds": time.perf_counter() - start}
    if outcome.plan is None or job.output is None:
        return replace(outcome, row=row)
    write(Path(job.output), row, outcome.plan)
    return Outcome(job.name, row)


def without_plan(job: Job, status: str, reason: str, seconds: float | None = None) -> Outcome:
    """Returns the outcome of a task without a plan.

    `status` is one of those at the top; `seconds` is the time that the task took [s], if known.
    """
    row = _row(job, None, status, reason)
    return Outcome(job.name, row if seconds is None else row | {"total_seconds": seconds})


def inline(job: Job) -> Job:
    """Returns the job with the whole task inline, so that a worker needs no file but meshes."""
    try:
        return replace(job, document=_read(job).to_dict())
    except TaskError as error:
        return replace(job, fault=str(error))


def hash_of(task: Task, prove: int | None = None) -> str:
    """Returns a hash that is equal for tasks with equal content, whatever files they are in.

    `prove` is the number of varied trials that a plan must hold, if any.
    """
    content = digest(task.to_dict())
    return content if prove is None else sha256(f"{content} prove {prove}".encode())


def sha256(data: bytes) -> str:
    """Returns the sha256 in hexadecimal digits."""
    return hashlib.sha256(data).hexdigest()


def is_row(row: Row) -> bool:
    """True if a row of a manifest has the fields and types that this version writes."""
    return all(
        key in row and isinstance(row[key], (type(empty), *_MAY_BE.get(key, ())))
        for key, empty in _empty_row().items()
    )


def _carry_out(job: Job) -> Outcome:
    from .. import _api, proving

    task = _read(job)
    digest = hash_of(task, job.prove)
    if digest == job.known:
        return Outcome(job.name)
    seconds = job.changes.get("seconds")
    if job.patience is not None:
        limit = task.budget.seconds if job.prove is None else proving.limit_of(seconds)
        _watch(job.patience + limit)
    if job.prove is None:
        plan = _api.plan(task)
    else:
        plan = _api.plan(task, prove=job.prove, seconds=seconds)
    faults = _api.check(plan) if plan else []
    proven = plan.proof is None or bool(plan.proof)
    row = _row(job, digest, str(plan.status), plan.reason if proven else str(plan.proof)) | {
        "seconds": float(plan.statistics.seconds),
        "seed": plan.seed,
        "plan": plan_file(job.name),
        "holds": bool(plan) and not faults and proven,
        "faults": faults[:MOST_FAULTS],
    }
    text = plan.to_json()
    return Outcome(job.name, row | {"plan_hash": sha256(text.encode())}, text)


def plan_file(name: str) -> str:
    """Returns the name of the plan file of a task, in the output."""
    return f"{name}.plan.json"


def write(output: Path, row: Row, plan: str) -> None:
    """Writes the plan of a row atomically; raises TaskError."""
    from ..plan_files import keep_solved

    path = output / row["plan"]
    files.make_folder(path.parent)
    if row["status"] != "solved":
        keep_solved(path)
    files.write(path, plan)


def sweep(output: Path) -> None:
    """Removes unfinished files of processes that were killed."""
    for name in (plan_file("*"), "batch.jsonl", "summary.json"):
        for path in files.temporaries(output, name):
            path.unlink(missing_ok=True)


def _read(job: Job) -> Task:
    from .._load import load_task
    from ..tasks import task_from_dict

    if job.fault is not None:
        raise TaskError(job.fault)
    if job.document is not None:
        return task_from_dict(job.document, job.path)
    task = load_task(job.path, trust=job.trust)
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
    """Ends this process unless the block finishes in time, even while C++ holds the GIL."""
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


_nowhere: int | None = None  # a descriptor that stays open: the watchdog may write at any time
