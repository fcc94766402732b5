# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress of an experiment, up to its end or to Ctrl-C."""

from __future__ import annotations

import sys
import time
from operator import attrgetter
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

Item = TypeVar("Item")

WIDTH = 30


class Bar:
    """Progress out of `total` on stderr, with the estimated remaining time; at a terminal only."""

    def __init__(self, what: str, total: int) -> None:
        self._what, self._total = what, total
        self._start = self._last = time.monotonic()
        self._shows = sys.stderr.isatty()

    def tell(self, done: int, note: str = "") -> None:
        now = time.monotonic()
        if not self._shows or (now - self._last < 0.1 and done < self._total):
            return
        self._last = now
        filled = WIDTH * done // max(1, self._total)
        left = (now - self._start) * (self._total - done) / max(1, done)
        line = (
            f"{self._what} [{'=' * filled:{WIDTH}}] {done}/{self._total} {left:.0f} s left {note}"
        )
        print(f"\r\033[K{line}", end="", file=sys.stderr, flush=True)

    def __enter__(self) -> Bar:
        return self

    def __exit__(self, *_: object) -> None:
        if self._shows:
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def told(
    items: Iterable[Item],
    tell: Callable[[int, str], None],
    name: Callable[[Item], str] = attrgetter("name"),
) -> Iterator[Item]:
    """Yields items; before each, tells how many are done, and its name."""
    for done, item in enumerate(items):
        tell(done, name(item))
        yield item


def collected(found: Iterable[Item]) -> tuple[list[Item], bool]:
    """Returns what is found up to Ctrl-C, and whether that is all."""
    kept: list[Item] = []
    try:
        for item in found:
            kept.append(item)
    except KeyboardInterrupt:
        return kept, False
    return kept, True
