# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kinds of tasks: the modules that handle them, and the kind of a problem or a document."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

from ..errors import TaskError, suggestion
from ..kinds import KINDS, part
from ..limits import uncounted

if TYPE_CHECKING:
    from pathlib import Path

    import pydantic

    from .source import Source


class TaskKind(Protocol):
    """Protocol of the modules that handle the tasks of a kind."""

    SEARCHES: tuple[str, ...]
    """Choices of options.search, the default last; none where there is one way to search."""

    Fields: type[pydantic.BaseModel]
    """Model of the task file, with kind, options and budget."""

    def resolve(self, named: Any, source: Source, directory: Path) -> tuple[Any, Source]:
        """Returns the fields with the content of all files that they name, and the source of those
        from another file.
        """

    def require_resolved(self, fields: Any, source: Source) -> None:
        """Raises TaskError unless fields of a plan file name no file that is not beside it."""

    def build(self, fields: Any, source: Source, other: Source) -> tuple[Any, Any]:
        """Returns the problem of resolved fields, and the robot that executes the plan if it is not
        part of the problem.
        """

    def options(self, fields: Any, problem: Any, source: Source) -> Any:
        """Returns the options."""

    def in_force(self, fields: Any, problem: Any, options: Any) -> dict[str, Any]:
        """Returns the fields with all values in force, independent of later defaults."""


def problem_kind(problem: Any) -> str:
    """Returns the kind of a Problem. Raises TaskError if it is not a Problem."""
    room = type(problem).__module__.removeprefix("graspless.").removeprefix("_core.")
    kind = room.removeprefix("tasks.")
    if kind not in KINDS:
        raise TaskError(f"problem: {problem!r}: should be a Problem of a planner")
    return kind


def is_problem(value: Any) -> bool:
    """Returns True if the value is the Problem of a planner."""
    return type(value).__name__ == "Problem" and type(value).__module__.startswith("graspless.")


def task_kind(source: Source) -> TaskKind:
    """Returns the module that handles this kind of document. Raises TaskError if it is unknown."""
    name = source.data.get("kind") if isinstance(source.data, dict) else None
    choices = " or ".join(f"'{kind}'" for kind in KINDS)
    if name is None:
        raise TaskError(f"{source.where(('kind',))}missing; should be {choices}")
    if name == "pick":
        raise source.error(("kind",), "is planned by `graspless pick`, with this file")
    if name == "scene":
        raise source.error(("kind",), "is read by `graspless pick`, with the name of an object")
    if name not in KINDS:
        raise source.error(("kind",), f"should be {choices}{suggestion(name, KINDS)}")
    with uncounted():
        kind: TaskKind = part("tasks", name)
    return kind
