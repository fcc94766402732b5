# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress bar on stderr, shown only at a terminal."""

from __future__ import annotations

import sys
import time

WIDTH = 30


class Bar:
    """Progress out of `total`, with the estimated remaining time."""

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

    def close(self) -> None:
        if self._shows:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
