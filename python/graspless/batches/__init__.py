# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Batches: many tasks planned in parallel, with results written as they arrive.

>>> import graspless
>>> summary = graspless.batch("tasks/", "plans/", jobs=2)  # doctest: +SKIP
>>> print(summary.as_text())  # doctest: +SKIP
"""

from __future__ import annotations

import time
from concurrent.futures import CancelledError
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import files
from .._arguments import require_above_zero, require_integer
from ..errors import TaskError
from . import manifest, names, pools, work
from .spread import spread
from .summary import Summary

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from .names import Entry
    from .work import Job, Outcome, Row

PATIENCE = 600.0  # [s]: reading, checking and writing take seconds


def batch(
    tasks: str | Path | Iterable[str | Path],
    output: str | Path,
    *,
    jobs: int = 1,
    dask: str | None = None,
    seed: int | None = None,
    seconds: float | None = None,
    iterations: int | None = None,
    prove: int | None = None,
    patience: float = PATIENCE,
    trust: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> Summary:
    """Plans many tasks, checks every plan, and writes results as they arrive.

    A task that already has a plan and has not changed since is not planned again. A task that
    fails, crashes or hangs does not stop the others. Ctrl-C ends the batch and keeps all results.

    Parameters
    ----------
    tasks : str, Path or several of them
        Task files, glob patterns, or folders of task files.
    output : str or Path
        Folder, created if missing. It gets NAME.plan.json for each task, batch.jsonl with one row
        per task, and summary.json.
    jobs : int
        Number of worker processes, each with one thread.
    dask : str, optional
        Address of a Dask scheduler whose workers plan instead of local processes.
    seed, seconds, iterations : optional
        Budget of every task, instead of its own; `seconds` in [s].
    prove : int, optional
        Number of varied trials in which every plan is simulated, see `plan`. A plan that was made
        without them, or with another number, is made anew.
    patience : float
        Time beyond its budget after which the process of a task is stopped [s].
    trust : bool
        Let xacro files read any file and run code, see docs/security.md.
    progress : callable, optional
        Called with the number of finished tasks and the number of all tasks.

    Returns
    -------
    Summary
        Its `is_complete` is False after Ctrl-C; the same call then resumes the batch.

    Raises
    ------
    TaskError
        There are no tasks, jobs or prove is not a whole number of at least 1, the output cannot
        be written, prove is given without MuJoCo, there is no Dask scheduler or worker, or a Dask
        worker has several threads.
    """
    changes = {"seed": seed, "seconds": seconds, "iterations": iterations}
    jobs = require_integer("jobs", jobs, least=1)
    if dask is not None and jobs != 1:
        raise TaskError("jobs: not beside dask, whose workers do it")
    require_above_zero("patience", patience)
    if any(value is not None for value in changes.values()):
        _check(changes)
    if prove is not None:
        prove = require_integer("prove", prove, least=1)
        _require_engine(dask)
    found = names.find(tasks)
    run = _Run(found, files.as_path(output), changes, patience, progress, trust, prove)
    with pools.opened(min(jobs, len(found)), dask) as pool:
        return run.carry_out(pool, work.carry_out)


def _require_engine(dask: str | None) -> None:
    """Raises TaskError if this machine's workers have no physics engine."""
    if dask is None:
        from ..simulation import simulation_kind

        simulation_kind("slide")


def _check(changes: dict[str, Any]) -> None:
    """Raises TaskError for values that no budget may have."""
    from pydantic import ValidationError

    from ..tasks.budget import Budget

    try:
        Budget.model_validate(changes)
    except ValidationError as error:
        fault = error.errors()[0]
        name, what = fault["loc"][0], fault["msg"].removeprefix("Input ")
        raise TaskError(f"{name}: {fault['input']}: {what}") from None


class _Run:
    """Call of `batch`."""

    def __init__(
        self,
        entries: list[Entry],
        output: Path,
        changes: dict[str, Any],
        patience: float = PATIENCE,
        progress: Callable[[int, int], None] | None = None,
        trust: bool = False,
        prove: int | None = None,
    ) -> None:
        self.entries, self.output, self.changes = entries, output, changes
        self.patience, self.progress, self.trust = patience, progress, trust
        self.prove = prove
        self.manifest = output / manifest.NAME
        files.make_folder(output)
        files.check_writable(self.manifest)
        self.before: dict[str, Row] = {}
        self.done: dict[str, Row] = {}
        self.kept = 0

    def carry_out(self, pool: pools.Pool, do: Callable[[Job], Outcome]) -> Summary:
        """Has `do` carry out all tasks, and writes the outcomes."""
        start = time.monotonic()
        with manifest.opened(self.manifest) as log:
            rows = manifest.read(self.manifest)
            self.before = {name: row for name, row in rows.items() if work.is_row(row)}
            try:
                work.sweep(self.output)
                for outcome in spread(do, self._jobs(pool), pool, self._lost):
                    self._take(outcome, log)
            except KeyboardInterrupt:
                pool.close(at_once=True)
                work.sweep(self.output)
            except CancelledError:
                raise TaskError(pools.GONE.format("the scheduler has gone")) from None
            return self._summarize(pool.workers, time.monotonic() - start)

    def _jobs(self, pool: pools.Pool) -> Iterator[Job]:
        for entry in self.entries:
            job = work.Job(
                entry.name,
                str(entry.path),
                self.changes,
                self._known(entry.name),
                output=None if pool.is_elsewhere else str(self.output),
                patience=self.patience,
                trust=self.trust,
                prove=self.prove,
            )
            yield work.inline(job) if pool.is_elsewhere else job

    def _known(self, name: str) -> str | None:
        """Returns the hash of the task that the plan in the output was made for, or None."""
        row = self.before.get(name)
        if row is None or row["plan"] is None:
            return None
        try:
            plan = (self.output / row["plan"]).read_bytes()
        except OSError:
            return None
        return row["hash"] if work.sha256(plan) == row["plan_hash"] else None

    def _lost(self, job: Job, told: str, seconds: float) -> Outcome:
        codes = _exit_codes(told)
        is_late = job.patience is not None and seconds >= job.patience
        if is_late and codes in ("", work.LATE):
            what = f"gave no answer for {seconds:.0f} s, and was ended"
            return work.without_plan(job, work.TIMED_OUT, what, seconds)
        what = f"its worker process died: {codes or told.strip()}"
        return work.without_plan(job, work.CRASHED, what, seconds)

    def _take(self, outcome: Outcome, log: manifest.Log) -> None:
        row = outcome.row
        if row is None:
            row = self.before[outcome.name]
            self.kept += 1
        else:
            if outcome.plan is not None:
                work.write(self.output, row, outcome.plan)
            log.add(row)
        self.done[outcome.name] = row
        if self.progress is not None:
            self.progress(len(self.done), len(self.entries))

    def _summarize(self, workers: int, seconds: float) -> Summary:
        rows = [self.done[entry.name] for entry in self.entries if entry.name in self.done]
        summary = Summary(rows, len(self.entries), self.kept, workers, seconds)
        if summary.is_complete:
            others = [row for name, row in self.before.items() if name not in self.done]
            manifest.rewrite(self.manifest, others + rows)
        text = manifest.encoded(summary.as_dict(), indent=1)
        files.write(self.output / "summary.json", text)
        return summary


def _exit_codes(told: str) -> str:
    """Returns the exit codes that loky reports, such as SIGSEGV(-11); Dask reports none."""
    _, _, codes = told.partition("The exit codes of the workers are ")
    return codes.partition("\n")[0].strip("{}")


__all__ = ["Summary", "batch"]
