# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress messages of long work, on stderr and only at a terminal."""

from __future__ import annotations

import contextlib
import sys
import threading
import time
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator


@contextlib.contextmanager
def waiting(what: str, patience: float = 0.5) -> Iterator[None]:
    """Shows the current activity and its duration once it has taken `patience` [s]."""
    if not sys.stderr.isatty():
        yield
        return
    done = threading.Event()
    start = time.monotonic()

    def tell() -> None:
        pause = patience
        while not done.wait(pause):
            print(
                f"\r{what}: {time.monotonic() - start:.0f} s ", end="", file=sys.stderr, flush=True
            )
            pause = 0.1
        if pause != patience:
            print("\r\033[K", end="", file=sys.stderr, flush=True)

    thread = threading.Thread(target=tell, daemon=True)
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()
