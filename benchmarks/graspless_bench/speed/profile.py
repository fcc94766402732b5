# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Instructions of queries, by the room of the library in which they are spent."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

from graspless.errors import TaskError

from ..bar import collected, told
from .builds import python

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence

    from ..machine import Row
    from .queries import Query

PROBLEMS = 20  # of a query, at most

_ONCE = """
from graspless_bench.speed.queries import OF_NAME
query = OF_NAME[{name!r}]
problems = list((query.profiled or query.make)())
for run in problems[:: -(-len(problems) // {limit})]:
    run()
"""
_LINE = re.compile(r"^\s*([\d,]+)\s+[^:]*:(.+?)(?: \[(\S+)\])?$")
_ROOM = re.compile(r"graspless::([a-z]\w*)::")
# Rooms outside the library, by the beginning of a function's name or by its binary.
_LIBRARIES = (
    ("Eigen", re.compile(r"^(void |bool )?Eigen::")),
    ("KDL", re.compile(r"^KDL::|kdl")),
    ("FCL", re.compile(r"^(\w+ )?fcl::|libfcl|libccd")),
    ("OMPL", re.compile(r"^ompl::|libompl")),
    ("CGAL", re.compile(r"CGAL::")),
    ("GLPK", re.compile(r"libglpk")),
    ("memory", re.compile(r"malloc|free|^operator (new|delete)|^mem(cpy|set|move)|^__mem")),
    ("sines, roots", re.compile(r"ieee754|sincos|libm[.-]")),
)
_OTHER = "other"  # the standard library, and what has no name


def needs_valgrind() -> None:
    """Raises TaskError without valgrind."""
    if shutil.which("valgrind") is None or shutil.which("callgrind_annotate") is None:
        raise TaskError("bench profile: needs valgrind, which is not on the path")


def run(
    queries: Sequence[Query],
    builds: Mapping[str, Path | None],
    tell: Callable[[int, str], None] = lambda done, name: None,
) -> tuple[list[Row], bool]:
    """Returns instructions by room of every query, and False after Ctrl-C.

    Parameters
    ----------
    queries : list of Query
        With a `room`.
    builds : dict of str to Path or None
        "new" and "old": folders that contain the package `graspless`. None: the installed one.
    tell : function
        Called with the number of queries that are done, and the next one.
    """
    return collected(_row(query, builds) for query in told(queries, tell))


def _row(query: Query, builds: Mapping[str, Path | None]) -> Row:
    counts = {name: dict(counted(_annotated(query, at))) for name, at in builds.items()}
    return {"name": query.name, **counts}


def counted(lines: Iterable[str]) -> Counter[str]:
    """Returns instructions by room, from the lines of callgrind_annotate."""
    counts: Counter[str] = Counter()
    for line in lines:
        found = _LINE.match(line)
        if found:
            counts[room(found[2], found[3] or "")] += int(found[1].replace(",", ""))
    return counts


def room(function: str, binary: str) -> str:
    """Returns the room of a function: a namespace of ours, a library, or `other`.

    An instance of a template belongs to the first of our namespaces in its name.
    """
    ours = _ROOM.search(function)
    if ours:
        return ours[1]
    for name, pattern in _LIBRARIES:
        if pattern.search(function) or pattern.search(Path(binary).name):
            return name
    return _OTHER


def _annotated(query: Query, folder: Path | None) -> Sequence[str]:
    """Runs a query under callgrind, which counts inside `plan` of its room."""
    command, env = python(_ONCE.format(name=query.name, limit=PROBLEMS), folder)
    with tempfile.TemporaryDirectory() as directory:
        out = Path(directory) / "callgrind.out"
        tool = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}"]
        inside = f"--toggle-collect=graspless::{query.room}::plan(*"
        done = subprocess.run([*tool, inside, *command], env=env, capture_output=True, text=True)
        if done.returncode != 0:
            raise TaskError(f"bench profile: {query.name}: valgrind failed: {done.stderr[-500:]}")
        annotate = ["callgrind_annotate", "--threshold=100", "--show-percs=no", str(out)]
        text = subprocess.run(annotate, capture_output=True, text=True, check=True).stdout
    return text.split("file:function", 1)[-1].splitlines()
