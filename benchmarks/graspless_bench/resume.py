# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Queries in separate processes. Their rows are kept in a file, from which a run goes on."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, TypeVar

from graspless.batches import manifest, pools
from graspless.batches.spread import spread

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping
    from pathlib import Path

    from .machine import Row

Query = TypeVar("Query")


def rows_of(
    asked: Mapping[str, Query],
    jobs: int,
    log: Path | None,
    measure: Callable[[Query], Row],
    lost: Callable[[Query, str, float], Row],
) -> Iterator[Row]:
    """Yields the rows of a file, then those of the other queries as they come.

    Parameters
    ----------
    asked : dict
        Queries by the field `key` of their rows.
    jobs : int
        Processes.
    log : Path, optional
        File to which rows are appended.
    measure : function
        Makes a row.
    lost : function
        Makes the row of a query whose process died, as for `spread`.
    """
    known = {} if log is None else manifest.read(log, "key")
    yield from (known[key] for key in asked if key in known)
    left = [query for key, query in asked.items() if key not in known]
    with contextlib.ExitStack() as stack:
        kept = None
        if log is not None:
            log.parent.mkdir(parents=True, exist_ok=True)
            kept = stack.enter_context(manifest.opened(log))
        pool = stack.enter_context(pools.opened(jobs, None))
        for row in spread(measure, left, pool, lost):
            if kept is not None:
                kept.add(row)
            yield row


def death(told: str, seconds: float) -> str:
    """Returns the reason of a row whose process died, from what is known of that."""
    return f"its process died after {seconds:.0f} s: {told.strip().partition(chr(10))[0]}"
