# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the first trial of each object, and films of trials that failed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from graspless import perception

from ..style import STYLE
from . import scenes
from .report import outcome
from .trial import measure

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from graspless.frames import Matrix

    from ..machine import Row
    from .trial import Query

FILMED = ("lost", "not_held", "knocked", "turned")  # stages, the worst first
COLUMNS = 6
EYE = (-0.4, -0.35, 0.45)  # of the pictures, from the object [m]
STEEP = 60.0  # shade of a slope in a depth image [1/m per pixel]


def draw(rows: Sequence[Row], queries: Sequence[Query], path: Path) -> None:
    """Writes a sheet with the first trial of each object, as a camera beside the robot sees it."""
    import matplotlib.pyplot as plt

    first: dict[str, tuple[Row, Query]] = {}
    for row, query in zip(rows, queries, strict=True):
        if row["pose"] == 0:
            first[row["mesh"]] = row, query  # of the last setting
    count = -(-len(first) // COLUMNS)
    with plt.rc_context(STYLE):
        size = 2 * COLUMNS, 2 * count
        figure, axes = plt.subplots(count, COLUMNS, figsize=size, layout="constrained")
        for place in np.ravel(axes):
            place.axis("off")
        for place, (row, query) in zip(np.ravel(axes), first.values(), strict=False):
            place.set_title(f"{row['mesh']}\n{outcome(row)}", fontsize=7, pad=2)
            place.imshow(_shaded(query), cmap="gray", vmin=0, vmax=1)
        figure.savefig(path, dpi=110)
        plt.close(figure)


def _shaded(query: Query) -> Matrix:
    """Returns grey values [h, w] of a trial's table, from 0 to 1."""
    given = query.setting(query.random())
    if given is None:
        return np.ones((1, 1))
    middle = given.target.points.mean(axis=0)
    perfect = perception.Noise.none()
    frame = scenes.rendered(given, np.add(middle, EYE), middle, noise=perfect)
    depth = np.where(frame.depth > 0, frame.depth, np.nan)
    down, right = np.gradient(depth)
    shade = np.nan_to_num(np.clip(0.5 + STEEP * (down + right), 0, 1), nan=1.0)
    return np.asarray(shade[60:420, 100:540], dtype=float)


def film(rows: Sequence[Row], queries: Sequence[Query], directory: Path, most: int) -> list[Path]:
    """Executes the worst trials again, at most `most`, and writes a replay of each."""
    failed = [
        (FILMED.index(row["stage"]), query)
        for row, query in zip(rows, queries, strict=True)
        if row["stage"] in FILMED
    ]
    failed.sort(key=lambda one: one[0])
    written = []
    for stage, query in failed[:most]:
        name = query.row["key"].replace("/", "_")
        path = directory / f"{FILMED[stage]}_{name}.html"
        measure(query, path)
        written += [path] if path.is_file() else []
    return written
