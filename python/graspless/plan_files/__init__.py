# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plan files: text that holds a plan and its whole task. This reads them."""

from __future__ import annotations

import json
import re
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

from pydantic_core import from_json

from .. import files
from .._any_plan import AnyPlan
from .._arguments import require_path
from ..errors import TaskError, told
from ..kinds import plan_type, require_motion
from ..tasks.kind import task_kind
from ..tasks.reading import parse_yaml, read_text
from ..tasks.source import MOST_DIGITS, Source, dotted

if TYPE_CHECKING:
    from .._plan import Plan
    from ..tasks.source import Location


def load_plan(path: str | Path | TextIO) -> Plan:
    """Reads a plan file.

    Parameters
    ----------
    path : str, Path or text stream
        As `Plan.save` or `graspless plan` wrote it; `io.StringIO` of text from a database.

    Returns
    -------
    slide.Plan, pinch.Plan, fingertip.Plan, clasp.Plan, carry.Plan or chain.Plan

    Raises
    ------
    TaskError
        The file is missing, is not a plan, or a mesh that it was made with has changed.
    """
    given: Any = path
    if hasattr(given, "read"):
        return read_plan(given.read(), str(getattr(given, "name", "plan")))
    return read_plan(read_text(given), str(given))


def as_plan(plan: Plan | str | Path) -> Plan:
    """Returns a plan, or reads it from its file."""
    if isinstance(plan, AnyPlan):
        given: Any = plan
        return given  # type: ignore[no-any-return]
    return load_plan(require_path("plan", plan, "a graspless.Plan"))


def as_motion(plan: Plan | str | Path, purpose: str, *statuses: str) -> Plan:
    """Returns a plan that moves something, or reads it from its file.

    Raises
    ------
    TaskError
        The plan is neither solved nor has one of the other `statuses`; or it has no segment, or
        one without rows. The message ends with the purpose.
    """
    plan = as_plan(plan)
    if not plan and plan.status not in statuses:
        raise TaskError(f"the plan's status is {plan.status}, not solved: nothing to {purpose}")
    require_motion(plan, purpose)
    return plan


def keep_solved(path: str | Path) -> Path | None:
    """Sets a solved plan aside, before one that is not solved is written in its place.

    Returns its new path, or None if there is no solved plan.
    """
    if not Path(path).is_file():  # who reads a pipe waits for its writer
        return None
    try:
        document = json.loads(read_text(path))
    except (TaskError, ValueError, RecursionError):
        return None
    is_solved = isinstance(document, dict) and document.get("status") == "solved"
    return files.set_aside(Path(path)) if is_solved and "format" in document else None


def read_plan(text: str, file: str) -> Plan:
    """Reads a plan from text, like `load_plan`. `file` is the name in error messages."""
    from .table import table

    with told(file):
        source = Source(file, _parsed(text, file))
        task_kind(source)  # raises unless there is such a kind
        valid = source.validate(table(source.data["kind"]))
        return plan_of(source.data, f"{file}: task", valid.task)


def plan_of(document: dict[str, Any], where: str, fields: Any = None) -> Plan:
    """Returns the plan of a valid document; error messages call its task `where`.

    `fields` are those of its task, if they are known.
    """
    plan: Plan = plan_type(document["kind"])._of_document(document, where, fields)
    return plan


_OTHERS = {"pick": ("task", "pick"), "scene": ("scene", "pick")}  # what it is, who reads it


def _no_plan(file: str, kind: Any) -> TaskError:
    what, command = _OTHERS.get(str(kind), ("task", "plan"))
    return TaskError(f"{file}: this is a {what}, not a plan; graspless {command} reads it")


def _parsed(text: str, file: str) -> dict[str, Any]:
    try:
        data = _loaded(text)
    except RecursionError:
        raise TaskError(f"{file}: not valid JSON: nested too deeply") from None
    except ValueError as error:
        if kind := _kind_of_task(text):
            raise _no_plan(file, kind) from None
        if isinstance(error, json.JSONDecodeError):
            told = f"not valid JSON: {error.msg} (column {error.colno})"
            raise TaskError(f"{file}:{error.lineno}: {told}") from None
        raise TaskError(f"{file}: not a plan file: {error}") from None
    if isinstance(data, dict) and "kind" in data and not {"format", "segments"} & set(data):
        raise _no_plan(file, data["kind"])
    if not isinstance(data, dict) or "format" not in data:
        raise TaskError(f"{file}: not a plan file: has no 'format'")
    if data["format"] != 1:
        raise Source(file, data).error(("format",), "this graspless reads format 1")
    _require_once(text, data, file)
    return data


_STRING = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*"\s*(:?)')  # the colon follows a name


def _require_once(text: str, data: Any, file: str) -> None:
    """Raises TaskError if a mapping names a field twice, of which `from_json` keeps the last."""
    if _STRING.findall(text).count(":") == _num_names(data):
        return
    twice: list[tuple[dict[str, Any], str]] = []

    def build(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        built = dict(pairs)
        if len(built) < len(pairs):
            counts = Counter(name for name, _ in pairs)
            twice.append((built, counts.most_common(1)[0][0]))
        return built

    data = json.loads(text, object_pairs_hook=build, parse_float=str, parse_int=str)
    if twice:  # the last one found is in no other
        mapping, name = twice[-1]
        raise TaskError(f"{file}: {dotted((*_place_of(mapping, data), name))}given twice")


def _num_names(data: Any) -> int:
    """Returns the number of names in all mappings, but those in tables that begin with a number."""
    if isinstance(data, dict):
        return len(data) + sum(map(_num_names, data.values()))
    first: Any = data
    while isinstance(first, list) and first:
        first = first[0]
    return sum(map(_num_names, data)) if isinstance(first, dict) else 0


def _place_of(wanted: dict[str, Any], data: Any) -> Location:
    """Returns the place of a mapping in a document that contains it."""
    pending: list[tuple[Location, Any]] = [((), data)]
    while True:
        place, value = pending.pop()
        if value is wanted:
            return place
        if isinstance(value, (dict, list)):
            items = value.items() if isinstance(value, dict) else enumerate(value)
            pending += [((*place, key), item) for key, item in items]


def _loaded(text: str) -> Any:
    """Returns what JSON holds; by a fast reader, or by the one whose errors give the line."""
    try:
        return from_json(text, allow_inf_nan=False)
    except ValueError:
        return json.loads(text, parse_constant=_refuse, parse_int=_integer)


def _kind_of_task(text: str) -> Any:
    """Returns the kind of a task in text that is not JSON; None if it is no task."""
    if text.lstrip().startswith("{"):  # a plan that was cut short would be slow to read as YAML
        return None
    try:
        return parse_yaml(text, "").data.get("kind")
    except TaskError:
        return None


def _integer(text: str) -> int | str:
    """Returns a number; as text, which names no field, one that is too long to be any field's."""
    return int(text) if len(text) <= MOST_DIGITS else text


def _refuse(name: str) -> float:
    raise ValueError(f"contains {name}, which is not a number")
