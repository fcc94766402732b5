# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Problems of the planners in the physics engine: planned, executed and evaluated."""

from __future__ import annotations

import importlib
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from graspless.batches import manifest, pools
from graspless.batches.spread import spread
from graspless.errors import TaskError

from . import work
from .tables import LOST

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from pathlib import Path

    from graspless.tasks import Task

    from ..machine import Row
    from .work import Query

RUNS = {"slide": 200, "fingertip": 54, "clasp": 60}  # plans, unless asked otherwise
BREAK_RUNS = 200  # plans with rows that are broken


@dataclass(frozen=True)
class Grid:
    """Problems of a run, and the experiment with their plans.

    Attributes
    ----------
    kind : str
        slide, fingertip or clasp.
    runs : int
        Problems.
    trials : int
        Of each plan: the first is nominal.
    seed : int
        Of problems and variations; plan k has the variations of seed + k.
    is_ablation : bool
        Slide plans by the paper's formula on the commanded tip.
    disturb : bool
        Instead of trials: the smallest wrench that breaks a fingertip plan.
    closed_loop : bool
        Instead of varied trials: each slide plan in each condition, in open and in closed loop.
    prove : bool
        Instead of trials of one plan: `graspless.plan` until a plan holds in all trials.
    mutants : bool
        Instead of trials: every plan broken on purpose, in `check` and `simulate`.
    locked : bool
        Instead of trials: certificates of clasps against hands with locked motors.
    withstands : bool
        Instead of trials: the smallest wrenches that break rows of fingertip plans, for the tasks
        of `fingertip_shapes`.
    """

    kind: str
    runs: int
    trials: int = 1
    seed: int = 1
    is_ablation: bool = False
    disturb: bool = False
    closed_loop: bool = False
    prove: bool = False
    mutants: bool = False
    locked: bool = False
    withstands: bool = False

    @property
    def part(self) -> str:
        """Name of the results in physics_PART.json."""
        flags = {
            "_ablation": self.is_ablation,
            "_disturb": self.disturb,
            "_closed_loop": self.closed_loop,
            "_prove": self.prove,
            "_mutants": self.mutants,
            "_locked": self.locked,
            "_withstands": self.withstands,
        }
        return self.kind + "".join(name for name, is_set in flags.items() if is_set)

    def check(self) -> None:
        """Raises TaskError unless there is such a grid."""
        for name in ("runs", "trials"):
            if getattr(self, name) < 1:
                raise TaskError(f"--{name}: {getattr(self, name)}: should be at least 1")
        if self.seed < 0:
            raise TaskError(f"--seed: {self.seed}: should not be negative")
        if self.is_ablation and self.kind != "slide":
            raise TaskError(f"--ablation: {self.kind} has none (slide has)")
        if self.closed_loop and (self.kind != "slide" or self.is_ablation):
            what = "--ablation" if self.is_ablation else self.kind
            raise TaskError(f"--closed-loop: {what}: only slide plans are followed")
        if self.locked and self.kind != "clasp":
            raise TaskError(f"--locked: {self.kind} plans have no certificate (clasp plans do)")
        given = (self.is_ablation, self.disturb, self.closed_loop, self.prove, self.mutants)
        if (self.prove or self.mutants) and sum((*given, self.locked)) > 1:
            which = "prove" if self.prove else "mutants"
            raise TaskError(f"--{which}: not beside another experiment")
        if self.withstands and (self.kind != "fingertip" or self.disturb):
            what = "--disturb" if self.disturb else self.kind
            raise TaskError(f"--withstands: {what}: only rows of fingertip plans are tested")
        if self.disturb and self.kind != "fingertip":
            raise TaskError(
                f"--disturb: {self.kind} plans have no stability margin (fingertip plans do)"
            )

    def queries(self) -> Iterator[Query]:
        """Yields one query per problem."""
        for k, task in enumerate(self._tasks()):
            name = f"{k:03} {task.source.file.removeprefix('bench: ')}"
            finger = "flexure" if self.is_ablation else None
            yield work.Query(
                name,
                task.to_dict(),
                self.trials,
                self.seed + k,
                self.disturb,
                finger,
                self.closed_loop,
                self.prove,
                self.mutants,
                self.locked,
                self.withstands,
            )

    def _tasks(self) -> Iterator[Task]:
        if self.withstands:
            from .fingertip_shapes import break_tasks

            yield from break_tasks(self.runs, self.seed)
            return
        module = importlib.import_module(f".{self.kind}_tasks", __package__)
        flags: dict[str, Any] = {"finger_model": "impedance"} if self.is_ablation else {}
        if self.mutants and self.kind == "fingertip":
            yield from module.forceful_tasks(self.runs, self.seed)
        else:
            yield from module.physics_tasks(self.runs, self.seed, **flags)


@dataclass
class Run:
    """Results of a run, up to Ctrl-C."""

    grid: Grid
    rows: list[Row] = field(default_factory=list)
    is_complete: bool = False

    @property
    def complaints(self) -> list[str]:
        """Returns plans that fail their check, workers that died, and errors."""
        found = [f"{row['name']}: {fault}" for row in self.rows for fault in row["faults"]]
        died = [row for row in self.rows if row["status"] in LOST]
        return found + [f"{row['name']}: {row['reason']}" for row in died]


def run(
    grid: Grid,
    jobs: int = 1,
    log: Path | None = None,
    tell: Callable[[int, int], None] | None = None,
    measure: Callable[[Query], Row] = work.measure,
) -> Run:
    """Measures a grid in separate processes.

    Parameters
    ----------
    grid : Grid
    jobs : int
        Processes.
    log : Path, optional
        File to which rows are appended. Its rows are not measured again.
    tell : callable, optional
        Called with the number of plans that are done, and the number of all plans.
    measure : function
        Makes a row.
    """
    result = Run(grid)
    before = {} if log is None else manifest.read(log, "key")
    try:
        with pools.opened(jobs, None) as pool:
            for row in _rows(grid, pool, before, log, measure):
                result.rows.append(row)
                if tell is not None:
                    tell(len(result.rows), grid.runs)
        result.is_complete = True
    except KeyboardInterrupt:
        pass
    result.rows.sort(key=lambda row: row["name"])
    return result


def _rows(
    grid: Grid,
    pool: pools.Pool,
    before: dict[str, Row],
    log: Path | None,
    measure: Callable[[Query], Row],
) -> Iterator[Row]:
    queries = list(grid.queries())
    yield from (before[query.key] for query in queries if query.key in before)
    left = [query for query in queries if query.key not in before]
    if log is None:
        yield from spread(measure, left, pool, _lost)
        return
    with manifest.opened(log) as kept:
        for row in spread(measure, left, pool, _lost):
            kept.add(row)
            yield row


def _lost(query: Query, told: str, seconds: float) -> Row:
    first = told.strip().partition("\n")[0]
    return work.unknown(query, "crashed", f"its process died after {seconds:.0f} s: {first}")
