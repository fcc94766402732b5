# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans with their tasks: made, written, read back and checked."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import files, frames
from .errors import TaskError
from .tasks import Task, load_task, task_from_dict
from .tasks.source import Source, parse_yaml, read_text

if TYPE_CHECKING:
    from . import slide
    from .frames import Matrix
    from .plan_model import PlanFile


@dataclass(frozen=True)
class Segment:
    """A stretch of motion.

    Attributes
    ----------
    name : str
        approach, press, slide, lift, reach, grasp or close.
    positions : array [N, dof]
        All joints [rad or m].
    object_poses : array [N, 4, 4]
        X_WO at each row.
    """

    name: str
    positions: Matrix
    object_poses: Matrix

    def __len__(self) -> int:
        return len(self.positions)


class Plan:
    """What was found, or why not, together with the task: all that a plan file holds.

    False unless solved. Its numbers are the file's: what is written and read back is equal, bit
    by bit.
    """

    def __init__(self, fields: PlanFile, task: Task) -> None:
        self.fields = fields
        self.task = task

    def __bool__(self) -> bool:
        return self.fields.status == "solved"

    def __repr__(self) -> str:
        names = ", ".join(f"{segment.name} {len(segment)}" for segment in self.segments)
        return f"<Plan {self.status}: {names or self.reason}>"

    @property
    def status(self) -> str:
        """solved, or why not: a name of slide.Status."""
        return self.fields.status

    @property
    def reason(self) -> str:
        """One sentence, for people."""
        return self.fields.reason

    @property
    def joint_names(self) -> list[str]:
        """The columns of positions."""
        return self.fields.joint_names

    @property
    def statistics(self) -> dict[str, Any]:
        """What the search did."""
        return self.fields.stats

    @property
    def overhang(self) -> float:
        """How far the object sticks out at the goal [m]."""
        return self.fields.overhang

    @cached_property
    def X_WO_goal(self) -> Matrix:  # noqa: N802
        """[4, 4] pose of the object after the slide."""
        return frames.from_row(self.fields.X_WO_goal)

    @cached_property
    def X_WH_grasp(self) -> Matrix:  # noqa: N802
        """[4, 4] pose of the hand's grasp frame at the grasp."""
        return frames.from_row(self.fields.X_WH_grasp)

    @cached_property
    def segments(self) -> list[Segment]:
        """Stretches of motion, in order."""
        dof = len(self.fields.joint_names)
        return [
            Segment(
                segment.name,
                np.array(segment.positions, dtype=float).reshape(-1, dof),
                np.array([frames.from_row(row) for row in segment.object_poses]).reshape(-1, 4, 4),
            )
            for segment in self.fields.segments
        ]

    def to_core(self) -> slide.Plan:
        """The planner's own type."""
        from . import slide

        plan = slide.Plan()
        plan.status = slide.Status.__members__[self.status]
        plan.reason = self.reason
        plan.joint_names = self.joint_names
        plan.segments = [
            slide.Segment(segment.name, segment.positions, segment.object_poses)
            for segment in self.segments
        ]
        plan.X_WO_goal = self.X_WO_goal
        plan.X_WH_grasp = self.X_WH_grasp
        plan.overhang = self.overhang
        return plan

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
) -> Plan:
    """Plans a task. Not finding a plan is a status, never an exception.

    Parameters
    ----------
    task : Task, str or Path
        A task, or the file it stands in.
    search : str, optional
        "paper" or "fast", instead of the task's.
    seconds, iterations, seed : optional
        Instead of the task's budget [s].

    Raises
    ------
    TaskError
        A ValueError: the task is not as it may be.
    """
    from . import slide

    if not isinstance(task, Task):
        task = load_task(task)
    task = task.with_changes(search=search, seconds=seconds, iterations=iterations, seed=seed)
    found = slide.plan(task.problem, task.options, task.budget)
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
    from . import slide

    if not isinstance(plan, Plan):
        plan = load_plan(plan)
    if not plan:
        return [
            f"nothing to check: the plan's status is {plan.status}, not solved; reason: {plan.reason}"
        ]
    return list(slide.check(plan.task.problem, plan.to_core(), plan.task.options))


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
    from .plan_model import PlanFile

    try:
        data = json.loads(text, parse_constant=_refuse)
    except ValueError as error:
        if _is_task(text):
            raise TaskError(_TASK.format(file)) from None
        if isinstance(error, json.JSONDecodeError):
            raise TaskError(f"{file}:{error.lineno}: not valid JSON: {error.msg}") from None
        raise TaskError(f"{file}: not a plan file: {error}") from None
    if isinstance(data, dict) and "format" not in data and "robot" in data:
        raise TaskError(_TASK.format(file))
    if not isinstance(data, dict) or "format" not in data:
        raise TaskError(f"{file}: not a plan file: has no 'format'")
    source = Source(file, data)
    if data["format"] != 1:
        raise source.error(("format",), "this graspless reads format 1")
    fields: PlanFile = source.validate(PlanFile)
    return Plan(fields, task_from_dict(data["task"], f"{file}: task"))


def from_core(found: slide.Plan, task: Task) -> Plan:
    """Joins what the planner found with the task it was given."""
    from . import __version__
    from .plan_model import PlanFile

    document = {
        "format": 1,
        "kind": "slide",
        "version": __version__,
        "status": found.status.name,
        "reason": found.reason,
        "seed": task.seed,
        "joint_names": list(found.joint_names),
        "overhang": float(found.overhang),
        "X_WO_goal": frames.to_row(found.X_WO_goal),
        "X_WH_grasp": frames.to_row(found.X_WH_grasp),
        "stats": found.statistics.as_dict(),
        "segments": [
            {
                "name": segment.name,
                "positions": np.asarray(segment.positions, dtype=float).tolist(),
                "object_poses": [frames.to_row(X_WO) for X_WO in segment.object_poses],
            }
            for segment in found.segments
        ],
        "task": task.to_dict(),
    }
    return Plan(PlanFile.model_validate(document), task)


_TASK = "{}: this is a task, not a plan; graspless plan reads it"


def _is_task(text: str) -> bool:
    """Whether text that is no JSON is a task."""
    if text.lstrip().startswith("{"):  # a plan that was cut short would be slow to read as YAML
        return False
    try:
        return {"kind", "robot"} <= set(parse_yaml(text, "").data)
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
