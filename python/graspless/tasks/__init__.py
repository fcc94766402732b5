# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Task files: what is to be planned, as people write it."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from ..errors import TaskError
from ..kinds import KINDS, part
from .meshes import check_files
from .source import Source, parse_yaml, read_text

if TYPE_CHECKING:
    import pydantic

    from .. import planning


class TaskKind(Protocol):
    """What `tasks` needs of a kind."""

    SEARCHES: tuple[str, ...]
    """Choices of options.search, the default last; none where there is one way to search."""

    Fields: type[pydantic.BaseModel]
    """The task file: kind, options and budget among its fields."""

    def resolve(self, named: Any, source: Source, directory: Path) -> tuple[Any, Source]:
        """The fields with every file that they name put inline, and where those of another file
        stand.
        """

    def require_resolved(self, fields: Any, source: Source) -> None:
        """Raises TaskError unless fields of a plan file name no file that is not beside it."""

    def build(self, fields: Any, source: Source, other: Source) -> tuple[Any, Any]:
        """The problem of resolved fields, and the robot that carries the plan out where that is
        not a part of the problem.
        """

    def options(self, fields: Any, problem: Any, source: Source) -> Any:
        """How to search; raises TaskError where the problem is too large for it."""

    def in_force(self, fields: Any, problem: Any, options: Any) -> dict[str, Any]:
        """Fields with every value that was in force, so that a later default cannot change it."""


@dataclass(frozen=True)
class Task:
    """A task file that was read, with all that it names.

    Attributes
    ----------
    fields : SlideTask, FingertipTask, ClaspTask, CarryTask or ChainTask
        The whole task; no file but meshes is needed beside it.
    problem : slide.Problem, fingertip.Problem, clasp.Problem, carry.Problem or chain.Problem
        What is given.
    options : slide.Options, fingertip.Options, clasp.Options, carry.Options or chain.model.Options
        How to search.
    budget : planning.Budget
        Time and randomness.
    arm : tasks.fingertip.Arm or None
        Of a fingertip task with a robot.
    """

    fields: Any
    problem: Any
    arm: Any
    options: Any
    budget: planning.Budget
    source: Source

    @property
    def kind(self) -> str:
        """Which planner it is for: slide, fingertip, clasp or carry; chain: several."""
        return str(self.fields.kind)

    @property
    def seed(self) -> int:
        """Of all randomness."""
        return int(self.budget.seed)

    def to_dict(self) -> dict[str, Any]:
        """The task as it stands in a plan file: whole, in plain types."""
        document: dict[str, Any] = self.fields.model_dump(mode="json", exclude_none=True)
        return document

    def with_changes(
        self,
        *,
        search: str | None = None,
        seconds: float | None = None,
        iterations: int | None = None,
        seed: int | None = None,
    ) -> Task:
        """The same task, searched otherwise; what is None stays."""
        if (search, seconds, iterations, seed) == (None, None, None, None):
            return self
        document = self.to_dict()
        changes = {"seconds": seconds, "iterations": iterations, "seed": seed}
        budget = {key: value for key, value in changes.items() if value is not None}
        document["budget"] = document.get("budget", {}) | budget
        if search is not None:
            document["options"] = document.get("options", {}) | {"search": search}
        source = Source(self.source.file, document)
        fields = source.validate(type(self.fields))
        return _with_search(fields, (self.problem, self.arm), self.source)


def load_task(path: str | Path) -> Task:
    """Reads a task file and everything that it names.

    Parameters
    ----------
    path : str or Path
        A YAML file, see docs/task-files.md. Paths in it are relative to it.

    Raises
    ------
    TaskError
        A ValueError whose lines read ``file:line: field: value: what it may be``.
    """
    return read_task(read_text(path), str(path), Path(path).resolve().parent)


def read_task(text: str, file: str, directory: str | Path = ".") -> Task:
    """As `load_task`, from text.

    Parameters
    ----------
    text : str
        YAML.
    file : str
        For errors.
    directory : str or Path
        What paths in it are relative to.
    """
    if _is_plan(text):
        raise TaskError(f"{file}: this is a plan, not a task; graspless check reads it")
    source = parse_yaml(text, file)
    kind = task_kind(source)
    named = source.validate(kind.Fields)
    fields, other = kind.resolve(named, source, Path(directory).resolve())
    return build_task(fields, source, other)


def task_from_dict(document: Any, file: str) -> Task:
    """The task that stands in a plan file.

    Parameters
    ----------
    document : dict
        As `Task.to_dict` gives it.
    file : str
        For errors.
    """
    source = Source(file, document)
    kind = task_kind(source)
    fields = source.validate(kind.Fields)
    kind.require_resolved(fields, source)
    check_files(fields.files, source)
    return build_task(fields, source, source)


def build_task(fields: Any, source: Source, other: Source) -> Task:
    """The task of resolved fields.

    Parameters
    ----------
    fields : SlideTask, FingertipTask, ...
        With every file that they name put inline.
    source, other : Source
        Where they stand, and where those of another file do; for errors.
    """
    kind: TaskKind = part("tasks", fields.kind)
    return _with_search(fields, kind.build(fields, source, other), source)


def task_kind(source: Source) -> TaskKind:
    """What is a document's own kind's; raises TaskError unless it has a known one."""
    name = source.data.get("kind") if isinstance(source.data, dict) else None
    choices = " or ".join(f"'{kind}'" for kind in KINDS)
    if name is None:
        raise source.error(("kind",), f"missing; should be {choices}")
    if name not in KINDS:
        raise source.error(("kind",), f"should be {choices}")
    kind: TaskKind = part("tasks", name)
    return kind


def searches(kind: str) -> tuple[str, ...]:
    """Choices of options.search."""
    choices: tuple[str, ...] = part("tasks", kind).SEARCHES
    return choices


def _is_plan(text: str) -> bool:
    if not text.lstrip().startswith("{"):  # a task may be JSON too, as all JSON is YAML
        return False
    try:
        document = json.loads(text)
    except ValueError:
        return False
    return isinstance(document, dict) and "format" in document and "segments" in document


def _with_search(fields: Any, built: tuple[Any, Any], source: Source) -> Task:
    from .budget import build_budget
    from .force import in_force

    problem, arm = built
    kind: TaskKind = part("tasks", fields.kind)
    options, budget = kind.options(fields, problem, source), build_budget(fields.budget, source)
    update = kind.in_force(fields, problem, options) | {"budget": in_force(fields.budget, budget)}
    return Task(fields.model_copy(update=update), problem, arm, options, budget, source)


__all__ = ["Task", "TaskError", "load_task", "read_task", "task_from_dict"]
