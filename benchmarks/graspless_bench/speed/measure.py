# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times of queries, with two builds in turn."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from ..bar import collected, told
from ..statistics import quantile
from .builds import NoAnswerError

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from ..machine import Row
    from .builds import Build
    from .queries import Query

RUNS, SECONDS = 5, 20.0  # of each problem and build: at most, and until as much time is spent


def run(
    queries: Sequence[Query],
    builds: Mapping[str, Build],
    tell: Callable[[int, str], None] = lambda done, name: None,
) -> tuple[list[Row], bool]:
    """Returns a row for every query, and False after Ctrl-C.

    Parameters
    ----------
    queries : list of Query
    builds : dict of str to Build
        "new", and "old" if there is another.
    tell : function
        Called with the number of queries that are done, and the next one.
    """
    return collected(_row(query, builds) for query in told(queries, tell))


def _row(query: Query, builds: Mapping[str, Build]) -> Row:
    """Asks the builds in turn. A build that cannot answer is not asked again."""
    load = os.getloadavg()[0]
    row: Row = {"name": query.name, "clock": "wall" if query.is_wall else "processor"}
    answers: dict[str, list[list[Any]]] = {}
    for name, build in builds.items():
        try:
            answers[name] = [[] for _ in range(build.ask(open=query.name)["problems"])]
        except NoAnswerError as error:
            row[name] = {"error": str(error)}
    _ask_in_turn(answers, builds, row)
    for name, found in answers.items():
        row[name] = _summary(found) | _closed(builds[name])
    if {"old", "new"} <= answers.keys():
        row |= _compared(answers["old"], answers["new"])
    return row | {"load": round(load, 2)}


def _closed(build: Build) -> Row:
    try:
        return build.ask(close=True)
    except NoAnswerError:  # its times are there
        return {}


def _ask_in_turn(
    answers: dict[str, list[list[Any]]], builds: Mapping[str, Build], row: Row
) -> None:
    spent, order = 0.0, list(answers)
    for _ in range(RUNS):
        for number in range(max((len(found) for found in answers.values()), default=0)):
            for name in [name for name in order if name in answers]:
                try:
                    answer = builds[name].ask(run=number)
                except NoAnswerError as error:
                    row[name] = {"error": str(error)}
                    del answers[name]
                    continue
                answers[name][number].append(answer)
                spent += answer["seconds"]
        order.reverse()
        if spent > SECONDS * len(answers):
            break


def _summary(found: Sequence[Sequence[Any]]) -> Row:
    """Of the least time of each problem."""
    least = [min(answer["seconds"] for answer in answers) for answers in found]
    return {
        "problems": len(found),
        "good": sum(all(answer["is_good"] for answer in answers) for answers in found),
        "p50": quantile(least, 0.5),
        "p99": quantile(least, 0.99),
        "worst": max(least),
    }


def _compared(old: Sequence[Sequence[Any]], new: Sequence[Sequence[Any]]) -> Row:
    """Ratios of the times of neighbouring runs, and the number of problems with equal results."""
    pairs = [
        (a, b) for olds, news in zip(old, new, strict=True) for a, b in zip(olds, news, strict=True)
    ]
    ratios = [b["seconds"] / a["seconds"] for a, b in pairs if a["seconds"] > 0]
    same = sum(
        all(a["value"] == b["value"] for a, b in zip(olds, news, strict=True))
        for olds, news in zip(old, new, strict=True)
    )
    quarters = {f"ratio_p{q}": quantile(ratios, q / 100) for q in (25, 50, 75)}
    return {**quarters, "same": same}
