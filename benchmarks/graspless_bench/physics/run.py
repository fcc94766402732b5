# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Problems of the planners in the physics engine: planned, executed and evaluated."""

from __future__ import annotations

import importlib
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from graspless.errors import TaskError, should_be

from ..bar import collected
from ..resume import death, rows_of
from . import work
from .experiments import EXPERIMENTS
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
    experiment : str
        Of EXPERIMENTS; empty: trials alone.
    """

    kind: str
    runs: int
    trials: int = 1
    seed: int = 1
    experiment: str = ""

    @property
    def part(self) -> str:
        """Name of the results in physics_PART.json."""
        return f"{self.kind}_{self.experiment}" if self.experiment else self.kind

    def check(self) -> None:
        """Raises TaskError unless there is such a grid."""
        for name in ("runs", "trials"):
            if getattr(self, name) < 1:
                raise TaskError(f"--{name}: {getattr(self, name)}: should be at least 1")
        if self.seed < 0:
            raise TaskError(f"--seed: {self.seed}: should not be negative")
        known = {"": ("", "", ""), **EXPERIMENTS}
        if self.experiment not in known:
            raise TaskError(f"{self.experiment}: {should_be(self.experiment, EXPERIMENTS)}")
        kind, refusal, _ = known[self.experiment]
        if kind not in ("", self.kind):
            raise TaskError(f"--{self.experiment.replace('_', '-')}: {self.kind}{refusal}")

    def queries(self) -> Iterator[Query]:
        """Yields one query per problem."""
        for k, task in enumerate(self._tasks()):
            name = f"{k:03} {task.source.file.removeprefix('bench: ')}"
            document, seed = task.to_dict(), self.seed + k
            yield work.Query(name, document, self.trials, seed, self.experiment)

    def _tasks(self) -> Iterator[Task]:
        if self.experiment == "withstands":
            from .fingertip_shapes import break_tasks

            yield from break_tasks(self.runs, self.seed)
            return
        module = importlib.import_module(f".{self.kind}_tasks", __package__)
        if self.experiment == "ablation":
            yield from module.physics_tasks(self.runs, self.seed, finger_model="impedance")
        elif self.part == "fingertip_mutants":
            yield from module.forceful_tasks(self.runs, self.seed)
        else:
            yield from module.physics_tasks(self.runs, self.seed)


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
    tell: Callable[[int], object] = lambda done: None,
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
        Called with the number of plans that are done.
    measure : function
        Makes a row.
    """

    def rows() -> Iterator[Row]:
        asked = {query.key: query for query in grid.queries()}
        for done, row in enumerate(rows_of(asked, jobs, log, measure, _lost), 1):
            yield row
            tell(done)

    found, is_complete = collected(rows())
    return Run(grid, sorted(found, key=lambda row: str(row["name"])), is_complete)


def _lost(query: Query, told: str, seconds: float) -> Row:
    return work.unknown(query, "crashed", death(told, seconds))
