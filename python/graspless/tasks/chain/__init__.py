# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of several stages."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .joints import HOLDING, ON_SUPPORT, require_joined
from .model import ChainTask, Options
from .stage import Stage
from .stages import read_stages, stages_of_plan
from .start import Held, State, start_at

if TYPE_CHECKING:
    from pathlib import Path

    from .. import Task
    from ..source import Source

SEARCHES: tuple[str, ...] = ()
Fields = ChainTask


@dataclass(frozen=True)
class Problem:
    """Stages of a chain. Only the first one knows its start."""

    stages: tuple[Stage, ...]
    first: Task

    @property
    def object(self) -> Any:
        """Object in the description of the first stage."""
        return self.first.problem.object


def resolve(named: ChainTask, source: Source, directory: Path) -> tuple[ChainTask, Any]:
    """Returns the fields with complete stages and the content of all files, and the stages."""
    if "files" in source.given():  # from Task.to_dict: nothing is left to resolve
        return named, stages_of_plan(named, source)
    stages = read_stages(named, source, directory)
    files = {name: value for stage in stages for name, value in stage.fields.files.items()}
    documents = [stage.document() for stage in stages]
    fields = ChainTask(
        kind="chain", stages=documents, options=named.options, budget=named.budget, files=files
    )
    return fields, stages


def require_resolved(fields: ChainTask, source: Source) -> None:
    """Raises TaskError unless fields of a plan file name no file that is not beside it."""
    stages_of_plan(fields, source)


def build(fields: ChainTask, source: Source, other: Any) -> tuple[Problem, None]:
    """Returns the stages, the first one with its problem. `other` are the stages from `resolve`."""
    stages = other if isinstance(other, list) else stages_of_plan(fields, source)
    require_joined(stages)
    return Problem(tuple(stages), stages[0].task(stages[0].fields)), None


def options(fields: ChainTask, problem: Problem, source: Source) -> Options:
    """Returns the options of the chain. The stages have their own options."""
    return fields.options


def in_force(fields: ChainTask, problem: Problem, options: Options) -> dict[str, Any]:
    """Returns the fields with all values in force. Those of a stage are in its plan."""
    return {"options": options}


__all__ = [
    "HOLDING",
    "ON_SUPPORT",
    "SEARCHES",
    "Fields",
    "Held",
    "Options",
    "Problem",
    "Stage",
    "State",
    "build",
    "in_force",
    "options",
    "require_resolved",
    "resolve",
    "start_at",
]
