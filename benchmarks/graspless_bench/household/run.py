# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trials: one per object, pose, robot and number of views."""

from __future__ import annotations

import json
import time
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

import graspless
from graspless.errors import TaskError
from graspless.simulation import chain as chains
from graspless.simulation import simulation_kind
from graspless.simulation.variation import Variation

from . import scenes

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..machine import Row

SECONDS = 6.0  # for each pick [s]
MADE_GOOD = {"tip_lost", "off_target", "tipped"}  # if the object is in the hand at the end
LOST = MADE_GOOD | {"fell", "hit"}
HEAVY = 0.2  # mass of an object that nobody gave [kg]


def run(
    paths: Sequence[Path],
    robots: Sequence[str],
    views: Sequence[int],
    poses: int,
    masses: dict[str, float],
    seed: int,
    log: Path | None = None,
    tell: Callable[[int], object] = lambda done: None,
) -> list[Row]:
    """Returns one row per object, pose, robot and number of views, in this order.

    Rows of the log are not run again.
    """
    rows = _logged(log, seed)
    done = {_key(row) for row in rows}
    for i, path in enumerate(paths):
        mesh, lying = scenes.stable_poses(path, poses)
        for pose, X in enumerate(lying):
            for robot, count in product(robots, views):
                label = label_of(robot)
                if (path.stem, pose, label, count) in done:
                    continue
                rng = np.random.default_rng([seed, pose, *path.stem.encode()])
                thing = scenes.placed(mesh, X, masses.get(path.stem, HEAVY), rng)
                head = {"mesh": path.stem, "pose": pose, "robot": label, "views": count}
                outcome = trial(thing, robot, count, int(rng.integers(1, 2**31)))
                rows.append(head | {"seed": seed} | outcome)
                _write(log, rows[-1])
        tell(i + 1)
    settings = product(map(label_of, robots), views)
    wanted = set(product((path.stem for path in paths), settings))
    return [row for row in rows if (row["mesh"], (row["robot"], row["views"])) in wanted]


def label_of(robot: str) -> str:
    """Returns the name of a robot that comes with graspless, or of the URDF without its folder."""
    return Path(robot).name.removesuffix(".urdf")


def trial(thing: scenes.Placed, robot: str, views: int, seed: int) -> Row:
    """Sees, picks and lifts an object; returns what became of it."""
    began = time.perf_counter()
    scene = scenes.seen(thing, seed, views)
    row: Row = {"see_seconds": time.perf_counter() - began, "strategy": None}
    found = scenes.nearest(scene, thing) if scene else None
    if found is None:
        return row | {"stage": "not_seen", "reason": scene.reason, "attempts": []}
    row["thickness_off"] = float(found.thickness - thing.points[:, 2].max())
    pick = graspless.pick(scene, found.name, robot, mass=thing.mass, seconds=SECONDS, seed=1)
    row |= {"pick_seconds": pick.seconds, "attempts": pick.as_dict()["attempts"]}
    if pick.plan is None:
        return row | {"stage": "refused", "reason": pick.reason}
    row["strategy"] = pick.strategy
    faults = graspless.check(pick.plan)
    if faults:
        return row | {"stage": "wrong", "reason": faults[0]}
    return row | _executed(thing, pick.plan)


def _executed(thing: scenes.Placed, plan: Any) -> Row:
    """Executes a plan with the true mesh; of a clasp, with what was seen."""
    began = time.perf_counter()
    first = plan.stages[0]
    if first.kind == "clasp":
        result = simulation_kind("clasp").run(first, Variation())
    else:
        body = scenes.truth(thing, first.X_WO_start)
        result = chains.run(plan, Variation(), truth=body)
    failures = list(result.failures)
    serious = set(failures) - MADE_GOOD
    if serious == {"dropped"} and result.measures.get("lifted"):
        stage = "turned"
    elif serious:
        stage = "lost" if set(failures) & LOST else "not_held"
    else:
        stage = "held"
    return {
        "stage": stage,
        "reason": ", ".join(failures),
        "simulate_seconds": time.perf_counter() - began,
    }


def read_masses(path: Path | None) -> dict[str, float]:
    """Returns the masses of a YAML file by the names of the meshes [kg]."""
    masses = _by_name("--masses", path, _is_mass, "should be a mass in kg")
    return {name: float(mass) for name, mass in masses.items()}


def read_excluded(
    path: Path | None, names: set[str], robots: Sequence[str]
) -> dict[str, dict[str, str]]:
    """Returns the reasons of a YAML file by robot and mesh; of the meshes in `names` only."""
    should = "should have a reason for each mesh, as text"
    reasons = _by_name("--excluded", path, _are_reasons, should)
    labels = [label_of(robot) for robot in robots]
    if unknown := sorted(reasons.keys() - set(labels)):
        raise TaskError(f"--excluded: {unknown[0]}: should be one of {', '.join(labels)}")
    return {
        robot: {name: some[name] for name in sorted(names & some.keys())}
        for robot, some in reasons.items()
    }


def _is_mass(value: Any) -> bool:
    return isinstance(value, (int, float)) and 0 < value < 1e4


def _are_reasons(value: Any) -> bool:
    return isinstance(value, dict) and all(
        isinstance(reason, str) and reason.strip() for reason in value.values()
    )


def _by_name(
    option: str, path: Path | None, is_valid: Callable[[Any], bool], should: str
) -> dict[str, Any]:
    """Returns the values of a YAML file by the names of the meshes; nothing without a file."""
    from graspless.tasks.reading import read_yaml

    if path is None:
        return {}
    if not path.is_file():
        raise TaskError(f"{option}: {path}: no such file")
    source = read_yaml(path)
    for name, value in source.data.items():
        if not is_valid(value):
            raise source.error((name,), should)
    return {str(name): value for name, value in source.data.items()}


def _logged(log: Path | None, seed: int) -> list[Row]:
    if log is None or not log.is_file():
        return []
    rows = [json.loads(line) for line in log.read_text().splitlines() if line.endswith("}")]
    return [row for row in rows if row["seed"] == seed and "views" in row]


def _write(log: Path | None, row: Row) -> None:
    if log is not None:
        with log.open("a") as file:
            file.write(json.dumps(row) + "\n")


def _key(row: Row) -> tuple[str, int, str, int]:
    return row["mesh"], row["pose"], row["robot"], row["views"]
