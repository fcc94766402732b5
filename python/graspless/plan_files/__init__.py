# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plan files: text that holds a plan and its whole task."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from .._arguments import require_path
from .._plan import AnyPlan
from ..errors import TaskError, told
from ..proving.proof import Proof
from ..tasks import task_from_dict
from ..tasks.kind import task_kind
from ..tasks.reading import parse_yaml, read_text
from ..tasks.source import MOST_DIGITS, Source

if TYPE_CHECKING:
    from pathlib import Path

    from .._plan import Plan


def load_plan(path: str | Path) -> Plan:
    """Reads a plan file.

    Parameters
    ----------
    path : str or Path
        As `Plan.save` or `graspless plan` wrote it.

    Returns
    -------
    slide.Plan, pinch.Plan, fingertip.Plan, clasp.Plan, carry.Plan or chain.Plan

    Raises
    ------
    TaskError
        The file is missing, is not a plan, or a mesh that it was made with has changed.
    """
    return read_plan(read_text(path), str(path))


def as_plan(plan: Plan | str | Path) -> Plan:
    """Returns a plan, or reads it from its file."""
    if isinstance(plan, AnyPlan):
        given: Any = plan
        return given  # type: ignore[no-any-return]
    return load_plan(require_path("plan", plan, "a graspless.Plan"))


def read_plan(text: str, file: str) -> Plan:
    """Reads a plan from text, like `load_plan`. `file` is the name in error messages."""
    from .table import table

    with told(file):
        source = Source(file, _parsed(text, file))
        task_kind(source)  # raises unless there is such a kind
        source.validate(table(source.data["kind"]))
        return plan_of(source.data, f"{file}: task")


def plan_of(document: dict[str, Any], where: str) -> Plan:
    """Returns the plan of a valid document. `where` is the place of its task in error messages."""
    from ..kinds import plan_type
    from .table import HEAD

    fields = {key: value for key, value in document.items() if key not in HEAD or key == "stats"}
    plan: Plan = plan_type(document["kind"])._made(fields, task_from_dict(document["task"], where))
    if document.get("proof") is not None:
        plan.proof = Proof(**document["proof"])
    return plan


def document_of(plan: AnyPlan | Plan) -> dict[str, Any]:
    """Returns all that a plan file holds, in plain types."""
    from .. import __version__

    fields = plan._fields()
    head = {"format": 1, "kind": plan.kind, "version": __version__}
    head |= {name: fields[name] for name in ("status", "reason")} | {"seed": plan.seed}
    head["stats"] = fields["stats"]
    if plan.proof is not None:
        head["proof"] = asdict(plan.proof)
    return head | fields | {"task": plan.task.to_dict()}


def text_of(plan: AnyPlan) -> str:
    """Returns the text of a plan's file."""
    return _to_text(document_of(plan)) + "\n"


_TASK = "{}: this is a task, not a plan; graspless plan reads it"


def _parsed(text: str, file: str) -> dict[str, Any]:
    try:
        data = json.loads(text, parse_constant=_refuse, parse_int=_integer)
    except RecursionError:
        raise TaskError(f"{file}: not valid JSON: nested too deeply") from None
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
    if data["format"] != 1:
        raise Source(file, data).error(("format",), "this graspless reads format 1")
    return data


def _is_task(text: str) -> bool:
    """Returns True if text that is not JSON is a task."""
    if text.lstrip().startswith("{"):  # a plan that was cut short would be slow to read as YAML
        return False
    try:
        return "kind" in parse_yaml(text, "").data
    except TaskError:
        return False


def _integer(text: str) -> int | str:
    """Returns a number; as text, which names no field, one that is too long to be any field's."""
    return int(text) if len(text) <= MOST_DIGITS else text


def _refuse(name: str) -> float:
    raise ValueError(f"contains {name}, which is not a number")


def _to_text(value: Any, indent: str = "") -> str:
    """JSON with one row of numbers a line: readable, and a quarter of the length of indent=1."""
    deeper = indent + " "
    if isinstance(value, dict) and value:
        items = (f"{deeper}{json.dumps(key)}: {_to_text(v, deeper)}" for key, v in value.items())
        return "{\n" + ",\n".join(items) + f"\n{indent}}}"
    if isinstance(value, list) and any(isinstance(item, (list, dict)) for item in value):
        rows = _rows(value, deeper) or (deeper + _to_text(item, deeper) for item in value)
        return "[\n" + ",\n".join(rows) + f"\n{indent}]"
    return _encode(value)


def _rows(table: list[Any], indent: str) -> list[str] | None:
    """Returns the lines of a list of lists of numbers, by a single call of json; or None."""
    if not all(isinstance(row, list) for row in table):
        return None
    text = _encode(table)
    if '"' in text or "{" in text or text.count("[") != len(table) + 1:
        return None
    return [f"{indent}[{row}]" for row in text[2:-2].split("], [")]


_encode = json.JSONEncoder(allow_nan=False).encode
