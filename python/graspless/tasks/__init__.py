# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Task files: reading, validation and writing."""

from __future__ import annotations

import json
import sys
from copy import copy
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic

from typing_extensions import TypeVar

from .. import planning
from .._arguments import require_finite, require_type
from ..errors import TaskError, told
from ..kinds import part
from ..limits import limit_reading
from .kind import problem_kind, task_kind
from .meshes import check_files
from .reading import parse_yaml
from .source import Source
from .units import warn_of_units

if TYPE_CHECKING:
    from .kind import TaskKind


ProblemT = TypeVar("ProblemT", default=Any)
OptionsT = TypeVar("OptionsT", default=Any)
PlanT = TypeVar("PlanT", default=Any)


class Task(Generic[ProblemT, OptionsT, PlanT]):
    """A problem with options and budget: read from a task file, or made of a problem by `Task.of`.

    Immutable: `with_changes` and `with_options` return other tasks. Two tasks are equal if their
    files are, and they may be pickled; both need a problem that a task file can state.
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
        self._problem, self._options = problem, copy(options)
        self._budget, self._arm = budget, arm
        self.source = source or Source("task", {})
        self._fields = fields

    @property
    def problem(self) -> ProblemT:
        """Problem of the task's kind: slide.Problem, pinch.Problem, ..., chain.Problem."""
        return self._problem

    @property
    def options(self) -> OptionsT:
        """Settings of the search; a copy, so that a plan keeps those that it was made with."""
        return copy(self._options)

    @property
    def budget(self) -> planning.Budget:
        """Time and randomness."""
        return self._budget

    @property
    def arm(self) -> Any:
        """Robot of a fingertip task, a tasks.fingertip.Arm; otherwise None."""
        return self._arm

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
            Problem of any kind.
        options : slide.Options, ..., optional
            Settings of the search, of the problem's kind. The task keeps a copy.
        budget : planning.Budget, optional
            Time and randomness. By default 10 s and seed 1.
        arm : tasks.fingertip.Arm, optional
            Robot that carries the fingertips.

        Raises
        ------
        TaskError
            An argument has another type, or the budget has no limit of time.
        """
        problem_kind(problem)  # raises unless it is one
        own = sys.modules[type(problem).__module__].Options  # the class beside it
        if options is None:
            options = own()
        require_type("options", options, own)
        if budget is not None:
            require_type("budget", budget, planning.Budget)
            require_finite(budget)
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

            self._fields = stated(self.kind, self.problem, self.options, self.budget, self.arm)
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
        """Returns the task with another search or budget; None keeps a value.

        Parameters
        ----------
        search : str, optional
            Search algorithm, by its name in the task file, such as "paper" or "fast".
        seconds : float, optional
            Limit of time [s], finite and above 0.
        iterations : int, optional
            Largest number of iterations of the search.
        seed : int, optional
            Seed of all random numbers, from 0 to 2^64 - 1.

        Raises
        ------
        TaskError
            A value is out of its range, or the kind has no such search.
        """
        from .documents import in_plain_types

        if (search, seconds, iterations, seed) == (None, None, None, None):
            return self
        changes = {"seconds": seconds, "iterations": iterations, "seed": seed}
        budget = in_plain_types({k: value for k, value in changes.items() if value is not None})
        if self._fields is None and search is None:
            from .budget import with_budget

            changed = with_budget(self.budget, budget)
            return type(self)(self.problem, self.options, changed, arm=self.arm)
        if search is None:
            return _with_budget(self, budget)
        return self._changed(budget, {"search": search})

    def with_options(self, **options: Any) -> Task[ProblemT, OptionsT, PlanT]:
        """Returns the task with other options of the search, by their names in the task file.

        Raises
        ------
        TaskError
            There is no such option, a value is out of its range, or no task file can state the
            problem.
        """
        from .documents import in_plain_types

        return self._changed({}, in_plain_types(options))

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
        warn_of_units(named, source)
        fields, other = kind.resolve(named, source, Path(directory).resolve())
        return build_task(fields, source, other)


def task_from_dict(
    document: Any, file: str, resolve: bool = False, *, trust: bool = False, fields: Any = None
) -> Task:
    """Returns the task of a document in plain types.

    Parameters
    ----------
    document : mapping
        Document from `Task.to_dict`; with `resolve`, also of arrays, tuples and paths.
    file : str
        For errors.
    resolve : bool
        Read the files that it names, relative to the working folder.
    trust : bool
        As in `read_task`.
    fields : SlideTask, FingertipTask, ...
        Those of the document, if it has been validated.
    """
    from .documents import in_plain_types

    with told(file):
        plain = in_plain_types(document) if resolve else document
        source = Source(file, plain, is_trusted=trust)
        kind = task_kind(source)
        fields = source.validate(kind.Fields) if fields is None else fields
        if resolve and not fields.files:
            warn_of_units(fields, source)
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


__all__ = ["Task", "TaskError", "read_task", "task_from_dict"]
