# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Task files: reading, validation and writing."""

from __future__ import annotations

import importlib
import json
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, Literal, Protocol, overload

from typing_extensions import TypeVar

from ..errors import TaskError, told
from ..kinds import KINDS, part
from ..limits import limit_reading, uncounted
from .meshes import check_files
from .source import Source, parse_yaml, read_text

if TYPE_CHECKING:
    import pydantic

    from .. import carry, chain, clasp, fingertip, pinch, planning, slide
    from .._plan import Plan


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


ProblemT = TypeVar("ProblemT", default=Any)
OptionsT = TypeVar("OptionsT", default=Any)
PlanT = TypeVar("PlanT", default=Any)


class Task(Generic[ProblemT, OptionsT, PlanT]):
    """A problem with options and budget: read from a task file, or made of a problem by `Task.of`.

    Immutable. Two tasks are equal if their files are, and they may be pickled; both need a problem
    that a task file can state.

    Attributes
    ----------
    problem : slide.Problem, pinch.Problem, fingertip.Problem, ..., chain.Problem
        What is given.
    options : slide.Options, pinch.Options, fingertip.Options, ..., chain.Options
        Settings of the search.
    budget : planning.Budget
        Time and randomness.
    arm : tasks.fingertip.Arm or None
        Robot of a fingertip task.
    """

    def __init__(
        self,
        problem: ProblemT,
        options: OptionsT,
        budget: planning.Budget,
        *,
        arm: Any = None,
        fields: Any = None,
        source: Source | None = None,
    ) -> None:
        self.problem, self.options, self.budget, self.arm = problem, options, budget, arm
        self.source = source or Source("task", {})
        self._fields = fields

    @classmethod
    def of(
        cls,
        problem: ProblemT,
        options: OptionsT | None = None,
        budget: planning.Budget | None = None,
        *,
        arm: Any = None,
    ) -> Task[ProblemT, OptionsT, Any]:
        """Returns the task of a problem that was made in Python.

        Parameters
        ----------
        problem : slide.Problem, pinch.Problem, fingertip.Problem, clasp.Problem or carry.Problem
        options : slide.Options, ..., optional
            Settings of the search.
        budget : planning.Budget, optional
            Time and randomness.
        arm : tasks.fingertip.Arm, optional
            Robot that carries the fingertips.
        """
        from .. import planning

        module = importlib.import_module(f"..{problem_kind(problem)}", __package__)
        options = module.Options() if options is None else options
        return cls(problem, options, planning.Budget() if budget is None else budget, arm=arm)

    @property
    def kind(self) -> str:
        """Planner that it is for: slide, pinch, fingertip, clasp or carry; chain: several."""
        return problem_kind(self.problem)

    @property
    def seed(self) -> int:
        """Seed of all randomness."""
        return int(self.budget.seed)

    @property
    def fields(self) -> Any:
        """Fields of the task file, with the content of all files except meshes.

        Raises
        ------
        TaskError
            No task file can express the problem.
        """
        if self._fields is None:
            from .statement import stated

            self._fields = stated(self)
        return self._fields

    def to_dict(self) -> dict[str, Any]:
        """Returns the complete task in plain types, as in a plan file."""
        from .documents import document_of

        return document_of(self.fields)

    def with_changes(
        self,
        *,
        search: str | None = None,
        seconds: float | None = None,
        iterations: int | None = None,
        seed: int | None = None,
    ) -> Task[ProblemT, OptionsT, PlanT]:
        """Returns the task with other options or budget. None keeps a value."""
        if (search, seconds, iterations, seed) == (None, None, None, None):
            return self
        changes = {"seconds": seconds, "iterations": iterations, "seed": seed}
        budget = {key: value for key, value in changes.items() if value is not None}
        if self._fields is None and search is None:
            from .budget import with_budget

            changed = with_budget(self.budget, budget)
            return type(self)(self.problem, self.options, changed, arm=self.arm)
        if search is None:
            return _with_budget(self, budget)
        return self._changed(budget, {"search": search})

    def with_options(self, **options: Any) -> Task[ProblemT, OptionsT, PlanT]:
        """Returns the task with other options of the search, by their names in the task file."""
        return self._changed({}, options)

    def _changed(self, budget: dict[str, Any], options: dict[str, Any]) -> Task[Any, Any, Any]:
        document = self.to_dict()
        document["budget"] = document.get("budget", {}) | budget
        document["options"] = document.get("options", {}) | options
        source = Source(self.source.file, document)
        fields = source.validate(type(self.fields))
        return _with_search(fields, (self.problem, self.arm), self.source)

    def __repr__(self) -> str:
        name = getattr(getattr(self.problem, "object", None), "name", "")
        stages = getattr(self.problem, "stages", None)
        what = f"{len(stages)} stages" if stages else f"'{name}'"
        return f"<{self.kind} task, {what}, {self.budget.seconds:g} s, seed {self.seed}>"

    def __eq__(self, other: object) -> bool:
        if self is other or not isinstance(other, Task):
            return self is other
        return self.to_dict() == other.to_dict()

    __hash__ = None  # type: ignore[assignment]

    def __copy__(self) -> Task[ProblemT, OptionsT, PlanT]:
        return self

    def __deepcopy__(self, memo: Any) -> Task[ProblemT, OptionsT, PlanT]:
        return self

    def __reduce__(self) -> Any:
        return task_from_dict, (self.to_dict(), "pickled task")


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

    Raises
    ------
    TaskError
        A ValueError whose lines read ``file:line: field: value: what it may be``.
    """
    task = read_task(read_text(path), str(path), Path(path).resolve().parent, trust=trust)
    if kind is not None and task.kind != kind:
        raise task.source.error(("kind",), f"should be '{kind}'")
    return task


def read_task(text: str, file: str, directory: str | Path = ".", *, trust: bool = False) -> Task:
    """Reads a task from text, like `load_task`.

    Parameters
    ----------
    text : str
        YAML.
    file : str
        For errors.
    directory : str or Path
        Folder to which its paths are relative.
    trust : bool
        Let its xacro files read any file and run code, see docs/security.md.
    """
    if _is_plan(text):
        raise TaskError(f"{file}: this is a plan, not a task; graspless check reads it")
    with told(file):
        source = replace(parse_yaml(text, file), is_trusted=trust)
        kind = task_kind(source)
        named = source.validate(kind.Fields)
        fields, other = kind.resolve(named, source, Path(directory).resolve())
        return build_task(fields, source, other)


def task_from_dict(document: Any, file: str, resolve: bool = False) -> Task:
    """Returns the task of a document in plain types.

    Parameters
    ----------
    document : dict
        Document from `Task.to_dict`.
    file : str
        For errors.
    resolve : bool
        Read the files that it names, relative to the working folder.
    """
    with told(file):
        source = Source(file, document)
        kind = task_kind(source)
        fields = source.validate(kind.Fields)
        if resolve and not fields.files:
            fields, other = kind.resolve(fields, source, Path.cwd())
            return build_task(fields, source, other)
        kind.require_resolved(fields, source)
        check_files(fields, source)
        return build_task(fields, source, source)


def build_task(fields: Any, source: Source, other: Source) -> Task:
    """Returns the task of resolved fields.

    Parameters
    ----------
    fields : SlideTask, FingertipTask, ...
        Fields with the content of all files that they name.
    source, other : Source
        Sources of the fields and of those from another file, for error messages.
    """
    from .budget import build_budget

    kind: TaskKind = part("tasks", fields.kind)
    limit_reading(build_budget(fields.budget, source).seconds)
    return _with_search(fields, kind.build(fields, source, other), source)


def task_kind(source: Source) -> TaskKind:
    """Returns the module that handles this kind of document. Raises TaskError if it is unknown."""
    name = source.data.get("kind") if isinstance(source.data, dict) else None
    choices = " or ".join(f"'{kind}'" for kind in KINDS)
    if name is None:
        raise source.error(("kind",), f"missing; should be {choices}")
    if name == "pick":
        raise source.error(("kind",), "is planned by `graspless pick`, with this file")
    if name not in KINDS:
        raise source.error(("kind",), f"should be {choices}")
    with uncounted():
        kind: TaskKind = part("tasks", name)
    return kind


def searches(kind: str) -> tuple[str, ...]:
    """Returns the choices of options.search."""
    choices: tuple[str, ...] = part("tasks", kind).SEARCHES
    return choices


def _is_plan(text: str) -> bool:
    if not text.lstrip().startswith("{"):  # a task may be JSON too, as all JSON is YAML
        return False
    try:
        document = json.loads(text, parse_int=str)
    except (ValueError, RecursionError):
        return False
    return isinstance(document, dict) and "format" in document and "segments" in document


def _with_budget(task: Task, changes: dict[str, Any]) -> Task:
    from .budget import Budgeted

    given = task.fields.budget.model_dump(mode="json", exclude_none=True) | changes
    budget = Source(task.source.file, {"budget": given}).validate(Budgeted).budget
    fields = task.fields.model_copy(update={"budget": budget})
    return _with_search(fields, (task.problem, task.arm), task.source)


def _with_search(fields: Any, built: tuple[Any, Any], source: Source) -> Task:
    from .budget import build_budget
    from .effective_values import in_force

    problem, arm = built
    kind: TaskKind = part("tasks", fields.kind)
    options, budget = kind.options(fields, problem, source), build_budget(fields.budget, source)
    update = kind.in_force(fields, problem, options) | {"budget": in_force(fields.budget, budget)}
    fields = fields.model_copy(update=update)
    return Task(problem, options, budget, arm=arm, fields=fields, source=source)


__all__ = ["Task", "TaskError", "load_task", "read_task", "task_from_dict"]
