# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The grids of `graspless bench clasp`, run one row after the other."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

from ..bar import collected, told
from . import holes, loops, measure, peers, small
from .grid import GRIDS, purses

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from ..machine import Row


@dataclasses.dataclass
class Run:
    """Results of a command, up to Ctrl-C."""

    grid: str
    rows: list[Row] = dataclasses.field(default_factory=list)
    is_complete: bool = False

    @property
    def totals(self) -> Row:
        others = {"loops": loops, "holes": holes, "grasp_rrt": peers, "small": small}
        module: Any = others.get(self.grid, measure)
        totals: Row = module.totals(self.rows)
        return totals

    @property
    def complaints(self) -> list[str]:
        return measure.complaints(row for row in self.rows if "faults" in row)


def count(grid: str, seeds: int) -> int:
    """Returns the number of rows, or of steps for a progress bar."""
    if grid == "loops":
        return len(loops.HOLES) * len(loops.CLOUDS)
    if grid == "holes":
        return holes.count(seeds)
    make = purses if grid == "grasp_rrt" else GRIDS[grid]
    return sum(1 for _ in make(seeds))


def run(
    grid: str,
    seeds: int = 1,
    seed: int = 1,
    seconds: float | None = None,
    tell: Callable[[int, str], None] = lambda done, name: None,
) -> Run:
    """Measures a grid.

    Parameters
    ----------
    grid : str
        paper, chair, tolerance, small, grasp_rrt, loops or holes.
    seeds : int
        Number of runs of each task.
    seed : int
        The first.
    seconds : float or None
        Limit of each query [s].
    tell : function
        Called with the number of steps that are done, and the next one.
    """
    return Run(grid, *collected(_measured(grid, seeds, seed, seconds, tell)))


def _measured(
    grid: str, seeds: int, seed: int, seconds: float | None, tell: Callable[[int, str], None]
) -> Iterator[Row]:
    if grid == "loops":
        yield from loops.rows(tell)
    elif grid == "holes":
        yield from holes.rows(seeds, seed, tell)
    elif grid == "grasp_rrt":
        yield from peers.rows(seeds, seed, seconds, tell)
    else:
        for trial in told(GRIDS[grid](seeds, seed), tell):
            yield measure.measure(trial, seconds)
