# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans with their tasks: made, written, read back and checked."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from .. import files
from .._arguments import require_path
from ..errors import TaskError
from ..kinds import part
from ..tasks import Task, load_task, task_from_dict, task_kind
from ..tasks.source import Source, parse_yaml, read_text

if TYPE_CHECKING:
    from .. import planning
    from .model import PlanFields


class PlanKind(Protocol):
    """What `plans` needs of a kind."""

    File: type[PlanFields]
    """The plan file."""

    Plan: type[Plan]
    """A plan with what it has beyond other kinds'."""

    def search(self, task: Task, budget: planning.Budget) -> Any:
        """What the planner finds: has status, reason and statistics."""

    def document(self, found: Any, task: Task) -> dict[str, Any]:
        """What a plan file holds of this kind alone."""

    def check(self, plan: Any) -> list[str]:
        """What does not hold of a plan that is solved."""


class Plan:
    """What was found, or why not, together with the task: all that a plan file holds.

    False unless solved. Its numbers are the file's: what is written and read back is equal, bit
    by bit.
    """

    def __init__(self, fields: Any, task: Task) -> None:
        self.fields = fields
        self.task = task

    def __bool__(self) -> bool:
        return bool(self.fields.status == "solved")

    def __repr__(self) -> str:
        names = ", ".join(f"{segment.name} {len(segment)}" for segment in self.segments)
        return f"<Plan {self.status}: {names or self.reason}>"

    @property
    def status(self) -> str:
        """solved, or why not."""
        return str(self.fields.status)

    @property
    def reason(self) -> str:
        """One sentence, for people."""
        return str(self.fields.reason)

    @property
    def kind(self) -> str:
        """Which planner made it: slide, fingertip, clasp or carry; chain: one for each stage."""
        return str(self.fields.kind)

    @property
    def statistics(self) -> dict[str, Any]:
        """What the search did."""
        stats: dict[str, Any] = self.fields.stats
        return stats

    @property
    def segments(self) -> list[Any]:
        """Stretches of motion, in order; each kind has its own."""
        raise NotImplementedError

    def to_json(self) -> str:
        """The text of the plan file."""
        return _to_text(self.fields.model_dump(mode="json", exclude_none=True)) + "\n"

    def save(self, path: str | Path) -> None:
        """Writes the plan file, whole or not at all."""
        files.write(path, self.to_json())


def plan(
    task: Task | str | Path,
    *,
    search: str | None = None,
    seconds: float | None = None,
    iterations: int | None = None,
    seed: int | None = None,
    budget: planning.Budget | None = None,
) -> Plan:
    """Plans a task. Not finding a plan is a status, never an exception.

    Parameters
    ----------
    task : Task, str or Path
        A task, or the file it stands in.
    search : str, optional
        Instead of the task's: "paper" or "fast", of a fingertip task also "dijkstra".
    seconds, iterations, seed : optional
        Instead of the task's budget [s].
    budget : planning.Budget, optional
        Instead of all three; another thread may stop() it.

    Raises
    ------
    TaskError
        A ValueError: the task is not as it may be.
    """
    if not isinstance(task, Task):
        task = load_task(require_path("task", task, "a graspless.Task"))
    if budget is not None:
        if (seconds, iterations, seed) != (None, None, None):
            raise TaskError("budget: seconds, iterations and seed must not be given beside it")
        seconds, iterations, seed = budget.seconds, budget.iterations, budget.seed
        if not math.isfinite(seconds):  # a plan file has no word for it
            raise TaskError(f"budget: seconds is {seconds}; should be finite")
    task = task.with_changes(search=search, seconds=seconds, iterations=iterations, seed=seed)
    found = plan_kind(task.kind).search(task, task.budget if budget is None else budget)
    return from_core(found, task)


def check(plan: Plan | str | Path) -> list[str]:
    """Replays a plan against its own task, with none of the search's code.

    Parameters
    ----------
    plan : Plan, str or Path
        A plan, or the file it stands in.

    Returns
    -------
    list of str
        What does not hold, by segment and row; empty when all does.
    """
    plan = as_plan(plan)
    if not plan:
        status = f"the plan's status is {plan.status}, not solved"
        return [f"nothing to check: {status}; reason: {plan.reason}"]
    return plan_kind(plan.kind).check(plan)


def as_plan(plan: Plan | str | Path) -> Plan:
    """A plan, or the one that stands in a file."""
    if isinstance(plan, Plan):
        return plan
    return load_plan(require_path("plan", plan, "a graspless.Plan"))


def load_plan(path: str | Path) -> Plan:
    """Reads a plan file.

    Raises
    ------
    TaskError
        The file is missing, is not a plan, or a mesh that it was made with has changed.
    """
    return read_plan(read_text(path), str(path))


def read_plan(text: str, file: str) -> Plan:
    """As `load_plan`, from text; `file` is for errors."""
    try:
        data = json.loads(text, parse_constant=_refuse)
    except ValueError as error:
        if _is_task(text):
            raise TaskError(_TASK.format(file)) from None
        if isinstance(error, json.JSONDecodeError):
            raise TaskError(f"{file}:{error.lineno}: not valid JSON: {error.msg}") from None
        raise TaskError(f"{file}: not a plan file: {error}") from None
    if isinstance(data, dict) and "kind" in data and not {"format", "segments"} & set(data):
        raise TaskError(_TASK.format(file))
    if not isinstance(data, dict) or "format" not in data:
        raise TaskError(f"{file}: not a plan file: has no 'format'")
    source = Source(file, data)
    if data["format"] != 1:
        raise source.error(("format",), "this graspless reads format 1")
    task_kind(source)  # raises unless there is such a kind
    kind = plan_kind(data["kind"])
    fields = source.validate(kind.File)
    return kind.Plan(fields, task_from_dict(data["task"], f"{file}: task"))


def from_core(found: Any, task: Task) -> Plan:
    """Joins what the planner found with the task it was given."""
    from .. import __version__

    kind = plan_kind(task.kind)
    document = {
        "format": 1,
        "kind": task.kind,
        "version": __version__,
        "status": found.status.name,
        "reason": found.reason,
        "seed": task.seed,
        "stats": found.statistics.as_dict(),
        "task": task.to_dict(),
    }
    return kind.Plan(kind.File.model_validate(document | kind.document(found, task)), task)


def plan_kind(name: str) -> PlanKind:
    """What is a kind's own."""
    kind: PlanKind = part("plans", name)
    return kind


_TASK = "{}: this is a task, not a plan; graspless plan reads it"


def _is_task(text: str) -> bool:
    """Whether text that is no JSON is a task."""
    if text.lstrip().startswith("{"):  # a plan that was cut short would be slow to read as YAML
        return False
    try:
        return "kind" in parse_yaml(text, "").data
    except TaskError:
        return False


def _refuse(name: str) -> float:
    raise ValueError(f"holds {name}, which is no number")


def _to_text(value: Any, indent: str = "") -> str:
    """JSON with one row of numbers a line: readable, and a quarter of the length of indent=1."""
    deeper = indent + " "
    if isinstance(value, dict) and value:
        items = (f"{deeper}{json.dumps(key)}: {_to_text(v, deeper)}" for key, v in value.items())
        return "{\n" + ",\n".join(items) + f"\n{indent}}}"
    if isinstance(value, list) and any(isinstance(item, (list, dict)) for item in value):
        return "[\n" + ",\n".join(deeper + _to_text(v, deeper) for v in value) + f"\n{indent}]"
    return json.dumps(value, allow_nan=False)
