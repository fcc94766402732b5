# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trials of all objects, poses, robots and numbers of views, and the files that a run is given."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING, Any

from graspless.errors import TaskError

from ..resume import death, rows_of
from .trial import Query, label_of, measure, nothing

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from pathlib import Path

    from ..machine import Row


def queries(
    paths: Sequence[Path],
    robots: Sequence[str],
    views: Sequence[int],
    poses: int,
    masses: dict[str, float],
    seed: int,
    folder: Sequence[Path],
) -> list[Query]:
    """Returns a trial for each object, pose, robot and number of views, in this order.

    `folder` has the meshes that may be neighbours.
    """
    return [
        Query(path, pose, robot, count, seed, masses, tuple(folder))
        for path, pose, robot, count in product(paths, range(poses), robots, views)
    ]


def run(
    asked: Sequence[Query],
    jobs: int = 1,
    log: Path | None = None,
    tell: Callable[[int], object] = lambda done: None,
) -> list[Row]:
    """Returns the rows of trials, made by `jobs` processes. Those of the log are not run again."""
    keyed = {query.row["key"]: query for query in asked}
    known: dict[str, Row] = {}
    for row in rows_of(keyed, jobs, log, measure, _died):
        known[row["key"]] = row
        tell(len(known))
    return [known[key] for key in keyed]


def _died(query: Query, told: str, seconds: float) -> Row:
    return nothing(query) | {"stage": "wrong", "reason": death(told, seconds)}


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
