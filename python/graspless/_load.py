# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of any kind from what a caller has: a file, its fields, or a problem."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, overload

from ._arguments import require_choice, require_path
from .errors import TaskError, shown
from .kinds import KINDS
from .tasks import Task, read_task, task_from_dict
from .tasks.kind import is_problem
from .tasks.reading import read_text

if TYPE_CHECKING:
    from . import carry, chain, clasp, fingertip, pinch, slide
    from ._plan import Plan


@overload
def load_task(path: str | Path, kind: Literal["slide"], *, trust: bool = False) -> slide.Task: ...
@overload
def load_task(path: str | Path, kind: Literal["pinch"], *, trust: bool = False) -> pinch.Task: ...
@overload
def load_task(
    path: str | Path, kind: Literal["fingertip"], *, trust: bool = False
) -> fingertip.Task: ...
@overload
def load_task(path: str | Path, kind: Literal["clasp"], *, trust: bool = False) -> clasp.Task: ...
@overload
def load_task(path: str | Path, kind: Literal["carry"], *, trust: bool = False) -> carry.Task: ...
@overload
def load_task(path: str | Path, kind: Literal["chain"], *, trust: bool = False) -> chain.Task: ...
@overload
def load_task(
    path: str | Path, kind: None = None, *, trust: bool = False
) -> Task[Any, Any, Plan]: ...
def load_task(path: str | Path, kind: str | None = None, *, trust: bool = False) -> Any:
    """Reads a task file and everything that it names.

    Parameters
    ----------
    path : str or Path
        A YAML file, see docs/task-files.md. Paths in it are relative to it.
    kind : str, optional
        Kind that the task must have: slide, pinch, fingertip, clasp, carry or chain. Type checkers
        then know the type of its plan.
    trust : bool
        Let its xacro files read any file and run code, see docs/security.md.

    Returns
    -------
    Task
        For `plan`.

    Raises
    ------
    TaskError
        A ValueError whose lines read ``file:line: field: value: what it may be``; or the task is
        of another kind, or there is no such kind.
    """
    if kind is not None:
        require_choice("kind", kind, KINDS)
    if isinstance(path, Mapping):
        what = "should be the path of a file; graspless.plan takes the fields of a task"
        raise TaskError(f"path: {shown(path)}: {what}")
    task = read_task(read_text(path), str(path), Path(path).resolve().parent, trust=trust)
    if kind is not None and task.kind != kind:
        raise task.source.error(("kind",), f"should be '{kind}'")
    return task


def as_task(task: Any) -> Task[Any, Any, Any]:
    """Returns a task, or makes it of a problem, of the fields of a task file or of the file."""
    if isinstance(task, Task):
        return task
    if is_problem(task):
        return Task.of(task)
    if isinstance(task, Mapping):
        return task_from_dict(task, "task", resolve=True)
    return load_task(require_path("task", task, "a graspless.Task, a Problem, a dict"))
