# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times of the curves, and their exponents."""

from __future__ import annotations

import importlib
import os
import time
from typing import TYPE_CHECKING, Any

import numpy as np

from graspless.errors import TaskError, missing

from ..bar import collected, told
from .curves import CURVES

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..machine import Row
    from .curves import Curve

RUNS, SECONDS = 5, 2.0  # of each size: at most, and until as much time is spent
GOOD = ("solved", "found")


def chosen(name: str | None) -> Sequence[Curve]:
    """Returns the curve of a name, or all."""
    curves = [curve for curve in CURVES if name in (None, curve.name)]
    if not curves:
        names = ", ".join(repr(curve.name) for curve in CURVES)
        raise TaskError(f"--curve: {name!r}: should be one of {names}")
    for needs in filter(None, (curve.needs for curve in curves)):
        try:
            importlib.import_module(needs)
        except ImportError as error:  # before what is measured is lost
            raise missing(error, "cluster") from None
    return curves


def run(
    curves: Sequence[Curve], tell: Callable[[int, str], None] = lambda done, name: None
) -> tuple[list[Row], bool]:
    """Returns a row for every size of every curve, and False after Ctrl-C."""
    sizes = ((curve, size) for curve in curves for size in curve.sizes)
    asked = told(sizes, tell, lambda one: f"{one[0].name}, {one[1]}")
    return collected(_row(curve, size) for curve, size in asked)


def exponent(sizes: Sequence[float], seconds: Sequence[float]) -> float:
    """Returns p of the law t = c n^p that fits best, by least squares of logarithms."""
    return float(np.polyfit(np.log(sizes), np.log(seconds), 1)[0])


def _row(curve: Curve, size: int) -> Row:
    query = curve.make(size)
    load = os.getloadavg()[0]
    times: list[float] = []
    statuses: list[str] = []
    while len(times) < RUNS and sum(times) < SECONDS:
        clock: Any = time.perf_counter if curve.is_wall else time.process_time
        start = clock()
        done = query()
        times.append(clock() - start if done.seconds is None else done.seconds)
        statuses.append(done.status)
    return {
        "curve": curve.name,
        "size": size,
        "status": next((status for status in statuses if status not in GOOD), statuses[0]),
        "seconds": min(times),
        "seconds_of_runs": times,
        "load": round(load, 2),
    }
