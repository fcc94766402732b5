# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Task files: what is to be planned, as people write it."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import TaskError
from .source import Source, parse_yaml, read_text

if TYPE_CHECKING:
    from .. import planning, slide
    from . import model


@dataclass(frozen=True)
class Task:
    """A task file that was read, with all that it names.

    Attributes
    ----------
    fields : SlideTask
        The whole task; no file but meshes is needed beside it.
    problem : slide.Problem
        What is given.
    options : slide.Options
        How to search.
    budget : planning.Budget
        Time and randomness.
    """

    fields: model.SlideTask
    problem: slide.Problem
    options: slide.Options
    budget: planning.Budget
    source: Source

    @property
    def seed(self) -> int:
        """Of all randomness."""
        return int(self.budget.seed)

    def to_dict(self) -> dict[str, Any]:
        """The task as it stands in a plan file: whole, in plain types."""
        return self.fields.model_dump(mode="json", exclude_none=True)

    def with_changes(
        self,
        *,
        search: str | None = None,
        seconds: float | None = None,
        iterations: int | None = None,
        seed: int | None = None,
    ) -> Task:
        """The same task, searched otherwise; what is None stays."""
        document = self.to_dict()
        changes = {"seconds": seconds, "iterations": iterations, "seed": seed}
        budget = {key: value for key, value in changes.items() if value is not None}
        document["budget"] = document.get("budget", {}) | budget
        if search is not None:
            document["options"] = document.get("options", {}) | {"search": search}
        source = Source(self.source.file, document)
        fields = source.validate(type(self.fields))
        return _with_search(fields, self.problem, self.source)


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
    from . import model
    from .resolve import resolve

    if _is_plan(text):
        raise TaskError(f"{file}: this is a plan, not a task; graspless check reads it")
    source = parse_yaml(text, file)
    named = source.validate(model.SlideTask)
    fields, hand_source = resolve(named, source, Path(directory).resolve())
    return _task(fields, source, hand_source)


def _is_plan(text: str) -> bool:
    if not text.lstrip().startswith("{"):  # a task may be JSON too, as all JSON is YAML
        return False
    try:
        document = json.loads(text)
    except ValueError:
        return False
    return isinstance(document, dict) and "format" in document and "segments" in document


def task_from_dict(document: Any, file: str) -> Task:
    """The task that stands in a plan file.

    Parameters
    ----------
    document : dict
        As `Task.to_dict` gives it.
    file : str
        For errors.
    """
    from . import model
    from .resolve import check_files

    source = Source(file, document)
    fields = source.validate(model.SlideTask)
    for section, field in (("robot", "urdf"), ("object", "cloud")):
        if getattr(getattr(fields, section), field) is not None:
            raise source.error((section, field), "must stand in the plan file itself")
    if isinstance(fields.hand, str):
        raise source.error(("hand",), "must stand in the plan file itself")
    check_files(fields, source)
    return _task(fields, source, source)


def _task(fields: model.SlideTask, source: Source, hand_source: Source) -> Task:
    from .build import build

    return _with_search(fields, build(fields, source, hand_source), source)


def _with_search(fields: model.SlideTask, problem: slide.Problem, source: Source) -> Task:
    from .build import build_budget, build_options

    options, budget = build_options(fields, source), build_budget(fields, source)
    # A plan file says every value that was in force, so that a later default cannot change it.
    in_force = {
        "hand": _in_force(fields.hand, problem.hand),
        "options": _in_force(fields.options, options),
        "budget": _in_force(fields.budget, budget),
    }
    return Task(fields.model_copy(update=in_force), problem, options, budget, source)


def _in_force(fields: Any, built: Any) -> Any:
    values = {name: getattr(built, name) for name in type(fields).model_fields}
    plain = {
        name: list(value) if isinstance(value, tuple) else getattr(value, "name", value)
        for name, value in values.items()
    }
    return type(fields)(**plain)


__all__ = ["Task", "TaskError", "load_task", "read_task", "task_from_dict"]
