# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A trial: a thing on a table is seen, picked up and lifted."""

from __future__ import annotations

import time
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

import graspless
from graspless import view
from graspless.simulation import chain as chains
from graspless.simulation import simulation_kind
from graspless.simulation.settings import Slide, Spread
from graspless.simulation.slide import follow
from graspless.simulation.variation import Variation, draw

from . import scenes, things

if TYPE_CHECKING:
    from ..machine import Row

SECONDS = 6.0  # for each pick [s]
# Failures that do not count if the object is in the hand at the end.
MADE_GOOD = {"tip_lost", "off_target", "tipped", "touched"}
LOST = {"tip_lost", "off_target", "tipped", "fell", "hit", "stopped"}
HEAVY = 0.2  # mass of an object that nobody gave [kg]
NEIGHBOURS = 2  # in every other trial
# Friction and mass of the object, and flexures, that neither the cameras nor the planner know.
UNKNOWN = Spread(position=0.0, angle=0.0, timestep=0.0, flexure=0.2)
JUDGED = Slide(kept_height=0.08)  # 2 cm less than the lift, as chains are judged [m]
DEALT: list[tuple[str, int]] = list(product(scenes.TABLES, (0, NEIGHBOURS)))


@dataclass(frozen=True)
class Query:
    """A trial.

    Attributes
    ----------
    path : Path
        Mesh.
    pose : int
        Number of the drop after which it lies.
    robot : str
    views : int
        Number of cameras.
    seed : int
    masses : dict
        By name [kg].
    folder : tuple of Path
        Meshes of which the neighbours are chosen.
    """

    path: Path
    pose: int
    robot: str
    views: int
    seed: int
    masses: dict[str, float]
    folder: tuple[Path, ...]

    @property
    def row(self) -> Row:
        """Beginning of its row."""
        table, _ = self.dealt
        head = {"mesh": self.path.stem, "pose": self.pose, "robot": label_of(self.robot)}
        head |= {"views": self.views, "seed": self.seed, "table": table}
        keyed = {**head, "mass": self.masses.get(self.path.stem, HEAVY), "of": len(self.folder)}
        return head | {"key": "/".join(str(value) for value in keyed.values())}

    @property
    def dealt(self) -> tuple[str, int]:
        """Table, and number of neighbours."""
        return DEALT[(self.pose + sum(self.path.stem.encode())) % len(DEALT)]

    def random(self) -> np.random.Generator:
        """Returns the source of all that is drawn."""
        return np.random.default_rng([self.seed, self.pose, *self.path.stem.encode()])

    def setting(self, rng: np.random.Generator) -> scenes.Setting | None:
        """Returns the table with the things on it, the same for each robot and number of views."""
        table, count = self.dealt
        others = [path for path in self.folder if path != self.path]
        chosen = rng.permutation(len(others))[:count]
        thing, *around = (
            things.read(path, self.masses.get(path.stem, HEAVY))
            for path in (self.path, *(others[i] for i in chosen))
        )
        return scenes.setting(scenes.TABLES[table], thing, around, rng)


def label_of(robot: str) -> str:
    """Returns the name of a robot that comes with graspless, or of the URDF without its folder."""
    return Path(robot).name.removesuffix(".urdf")


def nothing(query: Query) -> Row:
    """Returns the row of a trial in which nothing has been done."""
    return {**query.row, "neighbours": 0, "strategy": None, "attempts": []}


def measure(query: Query, film: Path | None = None) -> Row:
    """Sees, picks and lifts an object; returns what became of it, and may write a replay."""
    rng = query.random()
    given = query.setting(rng)
    row = nothing(query)
    if given is None:
        return row | {"stage": "not_seen", "reason": "larger than the table"}
    row["neighbours"] = len(given.others)
    return row | trial(given, query.robot, query.views, rng, film)


def trial(
    given: scenes.Setting,
    robot: str,
    views: int,
    rng: np.random.Generator,
    film: Path | None = None,
) -> Row:
    """Sees, picks and lifts the thing of a setting; returns what became of it."""
    seed = int(rng.integers(1, 2**31))
    began = time.perf_counter()
    scene = scenes.seen(given, seed, views)
    row: Row = {"see_seconds": time.perf_counter() - began}
    found = scenes.nearest(scene, given.target) if scene else None
    if found is None:
        return row | {"stage": "not_seen", "reason": scene.reason}
    row["thickness_off"] = float(found.thickness - given.target.points[:, 2].max())
    mass = given.target.thing.body.mass
    pick = graspless.pick(scene, found.name, robot, mass=mass, seconds=SECONDS, seed=1)
    row |= {"pick_seconds": pick.seconds, "attempts": pick.as_dict()["attempts"]}
    if pick.plan is None:
        return row | {"stage": "refused", "reason": pick.reason}
    row["strategy"] = pick.strategy
    faults = graspless.check(pick.plan)
    if faults:
        return row | {"stage": "wrong", "reason": faults[0]}
    return row | _executed(given, pick.plan, seed, rng, film)


def _executed(
    given: scenes.Setting, plan: Any, seed: int, rng: np.random.Generator, film: Path | None
) -> Row:
    """Executes a plan with the true meshes; of a clasp, with what was seen.

    A slide is executed in closed loop, and its lift is the straight one of the simulation.
    """
    began = time.perf_counter()
    first = plan.stages[0]
    unknown, record = draw(rng, UNKNOWN), film is not None
    if first.kind == "clasp":
        result = simulation_kind("clasp").run(first, Variation(), record=record)
    elif first.kind == "slide":
        body = scenes.truth(given, first.X_WO_start)
        result = follow(first, unknown, [seed], record=record, settings=JUDGED, truth=body)
    else:
        body = scenes.truth(given, first.X_WO_start)
        result = chains.run(plan, unknown, record=record, truth=body)
    seconds = time.perf_counter() - began
    if film is not None:
        shown = first if first.kind in ("clasp", "slide") else plan
        view.write_html(shown, film, recording=result.recording)
    failures = list(result.failures)
    return {
        "stage": _stage(set(failures), bool(result.measures.get("lifted"))),
        "reason": ", ".join(failures),
        "simulate_seconds": seconds,
    }


def _stage(failures: set[str], is_lifted: bool) -> str:
    serious = failures - MADE_GOOD
    if not serious:
        return "held"
    if serious == {"dropped"} and is_lifted:
        return "turned"
    if serious == {"knocked"}:
        return "knocked"
    return "lost" if failures & LOST else "not_held"
