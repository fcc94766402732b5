# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trials of all objects, poses, robots and numbers of views, and the files that a run is given."""

from __future__ import annotations

import contextlib
from itertools import product
from typing import TYPE_CHECKING, Any

from graspless.batches import manifest, pools
from graspless.batches.spread import spread
from graspless.errors import TaskError

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
    keys = [query.row["key"] for query in asked]
    known = {} if log is None else manifest.read(log, "key")
    left = [query for query, key in zip(asked, keys, strict=True) if key not in known]
    with contextlib.ExitStack() as stack:
        kept = None if log is None else stack.enter_context(manifest.opened(log))
        pool = stack.enter_context(pools.opened(jobs, None))
        for done, row in enumerate(spread(measure, left, pool, _died), len(asked) - len(left) + 1):
            known[row["key"]] = row
            if kept is not None:
                kept.add(row)
            tell(done)
    return [known[key] for key in keys]


def _died(query: Query, told: str, seconds: float) -> Row:
    reason = f"its process died after {seconds:.0f} s: {told.strip().partition(chr(10))[0]}"
    return nothing(query) | {"stage": "wrong", "reason": reason}


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
