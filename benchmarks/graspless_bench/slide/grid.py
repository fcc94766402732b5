# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frozen grid of start problems, and the trials of each of the paper's experiments."""

from __future__ import annotations

import dataclasses
import functools
import itertools
import math
import random
from typing import TYPE_CHECKING

import numpy as np

from graspless import _data, frames, geometry, planning, slide
from graspless.robot import Robot

from . import sscbirrt, ur5e
from .shapes import LETTERS, OBJECTS, TABLES, THICKNESS, outline_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from graspless import collision

HOME = [0, 0.2, 0, 2.0, 0, 0.94, 0, 0]  # all joints of wam_t42: the hand above the tables
# The contact at the commanded tip, as in the paper; the stiffness presses with 9 N at 15 mm.
PAPERS_HAND = slide.Hand(finger_model=slide.FingerModel.impedance, wrist_stiffness=600)
MIN_DEPTH = 0.005  # Delta_Z^- [m]
RANGES = {"0 cm": 0.0, "0.5 cm": 0.005, "2 cm": 0.02}  # Delta_Z^* [m]
ROOT_SCALES = (1, 10, 100, 1000, 10000)  # N*

PAIRS = ("independent", "fitting")  # goals from C_g until the pair is valid; or to fit the start
OMPL_PEERS = (
    "tangent_bundle_rrt_connect",
    "projected_biest",
    "atlas_rrt_connect",
    "projected_rrt_connect",
)
SSC_PEERS = ("sscbirrt_native", "sscbirrt")
FOREIGN = (*OMPL_PEERS, *SSC_PEERS)  # planners that are not ours


@dataclasses.dataclass(frozen=True)
class Start:
    """Start problem: an object at a pose on a table. Equal starts have equal poses."""

    table: str
    object: str
    scale: float
    index: int
    seed: int

    @property
    def name(self) -> str:
        return f"{self.cell}, pose {self.index}"

    @property
    def cell(self) -> str:
        return f"{self.table} table, {self.object}, scale {self.scale:g}"

    def draw_pose(self) -> tuple[float, float, float]:
        """Returns x, y [m] and yaw [rad], uniform over poses with the whole object on the table."""
        return self._draw()[0]

    def draw_seed(self) -> int:
        """Returns the seed of the planner."""
        return self._draw()[1]

    def _draw(self) -> tuple[tuple[float, float, float], int]:
        # Seeded by a text and used by random() alone: the same numbers on any Python.
        rng = random.Random(f"{self.seed} {self.name}")
        table = geometry.Polygon(TABLES[self.table])
        outline = np.array(outline_of(self.object, self.scale))
        low, high = np.array(TABLES[self.table]).min(0), np.array(TABLES[self.table]).max(0)
        while True:
            x, y = (float(a + rng.random() * (b - a)) for a, b in zip(low, high, strict=True))
            yaw = 2 * math.pi * rng.random()
            c, s = math.cos(yaw), math.sin(yaw)
            corners = outline @ np.array([[c, s], [-s, c]]) + [x, y]
            if all(table.contains(corner) for corner in corners):  # the tables are convex
                return (x, y, yaw), int(rng.random() * 2**32)


@dataclasses.dataclass(frozen=True)
class Trial:
    """One query: a problem and a planner."""

    start: Start
    section: str = "frozen"
    method: str = "fast"  # "paper", or a peer
    range: float = 0.02  # Delta_Z^* [m]
    defaults: bool = False  # the library's own margins and effective tip, not the paper's terms
    root_scale: float = 100  # N*
    pairs: str = "independent"  # how a peer's start and goal are drawn: of PAIRS
    arm: str = "wam_t42"  # or "ur5e"

    @property
    def label(self) -> str:
        """Name of its curve."""
        return f"{self.section}, {self.method}"

    def make_problem(self) -> slide.Problem:
        start = self.start
        hand = slide.Hand() if self.defaults else PAPERS_HAND
        X_WO = frames.planar(*start.draw_pose())
        robot_of, home = (ur5e.robot, ur5e.home) if self.arm == "ur5e" else (robot, lambda: HOME)
        return slide.Problem(
            robot_of(),
            hand,
            thin_object(start.object, start.scale),
            table(start.table),
            X_WO,
            home(),
        )

    def make_options(self) -> slide.Options:
        options = slide.Options(
            search=slide.Search.paper if self.method == "paper" else slide.Search.fast,
            min_depth=MIN_DEPTH,
            max_depth=MIN_DEPTH + self.range,
            root_scale=self.root_scale,
        )
        if not self.defaults:
            options.com_margin = 0.001  # exactly on the edge must not count as inside
            options.tip_margin = 0
            options.rim_margin = 0
            options.refuse_lag = False  # the paper knows no friction
        return options

    def make_budget(self, seconds: float) -> planning.Budget:
        return planning.Budget(seconds=seconds, seed=self.start.draw_seed())


@functools.cache
def robot() -> Robot:
    path = _data.robot("wam_t42")
    assert path is not None
    return Robot.from_urdf_file(str(path))


@functools.cache
def table(name: str) -> slide.Support:
    return slide.Support(TABLES[name], np.eye(4))


@functools.cache
def thin_object(name: str, scale: float) -> slide.Object:
    return slide.Object.from_polygon(name, outline_of(name, scale), THICKNESS)


def starts(
    runs: int,
    seed: int,
    tables: Sequence[str] = tuple(TABLES),
    objects: Sequence[str] = tuple(OBJECTS),
    scale: float = 1,
) -> Iterator[Start]:
    """Returns starts that are distributed evenly over the cells of table x object."""
    cells = itertools.cycle(itertools.product(objects, tables))
    size = len(tables) * len(objects)
    for i, (name, on) in enumerate(itertools.islice(cells, runs)):
        yield Start(on, name, scale, i // size, seed)


def among(problem: slide.Problem, obstacles: list[collision.Obstacle]) -> slide.Problem:
    """Returns a problem with other obstacles."""
    return slide.Problem(
        problem.robot,
        problem.hand,
        problem.object,
        problem.support,
        problem.X_WO_start,
        problem.q_home,
        obstacles,
    )


def frozen(runs: int, seed: int, search: str) -> Iterator[Trial]:
    """Fig. 10: tables x objects."""
    for start in starts(runs, seed):
        yield Trial(start, "frozen", search)


def paper(runs: int, seed: int, search: str) -> Iterator[Trial]:
    """Fig. 10: the frozen grid, also at half scale, with other ranges, letters and defaults."""
    yield from frozen(runs, seed, search)
    for start in starts(runs, seed, scale=0.5):
        yield Trial(start, "half scale", search)
    for name, width in RANGES.items():
        if width != Trial.range:
            for start in starts(runs // 2, seed):
                yield Trial(start, f"range {name}", search, range=width)
    for start in starts(runs // 5, seed, objects=tuple(LETTERS)):
        yield Trial(start, "letters", search)
    for start in starts(runs, seed):
        yield Trial(start, "defaults", search, defaults=True)


def reconfiguration(runs: int, seed: int, searches: Iterable[str]) -> Iterator[Trial]:
    """Fig. 11: the square table, 5 objects, three reconfiguration ranges."""
    for search in searches:
        for name, width in RANGES.items():
            for start in starts(runs, seed, tables=("square",)):
                yield Trial(start, f"range {name}", search, range=width)


def baselines(runs: int, seed: int) -> Iterator[Trial]:
    """Fig. 11: the two baselines, and OMPL's planners on pairs at one depth."""
    problems = list(starts(runs, seed, tables=("square",)))
    for method in ("fast", "paper", "cbirrt2", "cbirrt"):
        for start in problems:
            yield Trial(start, "range 2 cm", method)
    for method in ("fast", "paper"):
        for start in problems:
            yield Trial(start, "range 0 cm", method, range=0.0)
    for pairs in PAIRS:
        for method in ("forest", *OMPL_PEERS):
            for start in problems:
                yield Trial(start, f"{pairs} pairs", method, range=0.0, pairs=pairs)


def arms(runs: int, seed: int) -> Iterator[Trial]:
    """A UR5e at one depth: our planners, OMPL's, and sscbirrt where it is installed."""
    problems = list(starts(runs, seed, tables=("square",)))
    foreign = FOREIGN if sscbirrt.is_installed() else OMPL_PEERS
    for start in problems:
        yield Trial(start, "UR5e", "fast", range=0.0, arm="ur5e")
    for pairs in PAIRS:
        for method in ("forest", *foreign):
            for start in problems:
                yield Trial(start, f"UR5e, {pairs}", method, range=0.0, pairs=pairs, arm="ur5e")


def roots(runs: int, seed: int, searches: Iterable[str]) -> Iterator[Trial]:
    """Fig. 12: root sampling with different N*."""
    for search in searches:
        for scale in ROOT_SCALES:
            for start in starts(runs, seed, tables=("square",)):
                yield Trial(start, f"N* {scale}", search, root_scale=scale)
