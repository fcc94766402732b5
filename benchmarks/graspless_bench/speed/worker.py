# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A process that runs queries on request, with the graspless that comes first on its path.

Requests and answers are lines of JSON. {"open": NAME} makes a query and answers how many problems
it has; {"run": NUMBER} runs one of them; {"close": true} answers the peak of memory. Other things
that the library prints go to stderr.
"""

from __future__ import annotations

import json
import os
import sys
import time
from typing import TYPE_CHECKING, Any

from .. import memory

if TYPE_CHECKING:
    from collections.abc import Callable

    from .queries import Done, Query


class Worker:
    """The query that is open."""

    def __init__(self) -> None:
        self._runs: list[Callable[[], Done]] = []
        self._clock: Callable[[], float] = time.process_time
        self._before = 0

    def answer(self, request: dict[str, Any]) -> dict[str, Any]:
        """Returns the answer to a request."""
        if "open" in request:
            from .queries import OF_NAME

            return self._open(OF_NAME[request["open"]])
        if "run" in request:
            return self._run(request["run"])
        return {"megabytes": round(max(0, memory.peak_bytes() - self._before) / memory.MEGA, 1)}

    def _open(self, query: Query) -> dict[str, Any]:
        self._runs = list(query.make())
        self._clock = time.perf_counter if query.is_wall else time.process_time
        self._before = memory.resident_bytes()
        memory.reset_peak()
        return {"problems": len(self._runs)}

    def _run(self, number: int) -> dict[str, Any]:
        start = self._clock()
        done = self._runs[number]()
        seconds = self._clock() - start
        return {
            "is_good": done.is_good,
            "value": done.value,
            "seconds": seconds if done.seconds is None else done.seconds,
        }


def main() -> None:
    """Answers until stdin ends."""
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    worker = Worker()
    for line in sys.stdin:
        try:
            answer = worker.answer(json.loads(line))
        except Exception as error:  # an older build may lack what a query needs
            answer = {"error": f"{type(error).__name__}: {error}"}
        print(json.dumps(answer), file=answers, flush=True)
