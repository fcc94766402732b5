# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plan files, format 1, from one table of fields per kind.

A table is a pydantic model. It validates the file, `plan.schema.json` is made from it, and it
drives both directions between the file's plain types and the planner's own: a field of the file is
an attribute of the plan, and an argument of its constructor, of the same name (or of that in
`ATTRIBUTES`). Poses, by the names of frames, are 4 x 4 matrices there and rows of 7 numbers here.
"""

from __future__ import annotations

from functools import cache, reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, get_args, get_origin

import numpy as np
from pydantic import BaseModel, Discriminator, Field, TypeAdapter

from .. import frames
from ..kinds import KINDS, part
from ..tasks.effective_values import plain
from ..tasks.shapes import Fields
from .proof import ProofFields

if TYPE_CHECKING:
    from collections.abc import Callable

PoseRow = Annotated[list[float], Field(min_length=7, max_length=7)]
HEAD = ("format", "kind", "version", "seed", "stats", "proof", "task")


class Table(Fields):
    """Struct of the planner in the form of the file."""

    MAKE: ClassVar[Callable[..., Any]]
    """Constructor of the planner's own type, which takes the fields by name."""

    ATTRIBUTES: ClassVar[dict[str, str]] = {}
    """Attributes that are not called as the field is."""


class PlanFields(Table):
    """A plan with its whole task; each kind adds its segments and the task."""

    format: Literal[1]
    kind: str
    version: str = Field(description="version of graspless that wrote the file")
    status: str
    reason: str = Field(description="explanation in one sentence")
    seed: int
    stats: dict[str, float | int | dict[str, int]] = Field(description="counters of the search")
    proof: ProofFields | None = Field(
        default=None, description="trials in the physics engine, if the plan was made with `prove`"
    )


def table(kind: str) -> type[PlanFields]:
    """Returns the table of a kind."""
    file: type[PlanFields] = part("plan_files", kind).File
    return file


def fields_of(
    found: Any, model: type[Table], changes: dict[str, Any] | None = None
) -> dict[str, Any]:
    """Returns the fields of a struct in plain types; None is left out, and so is the head."""
    fields = {}
    for name, field in model.model_fields.items():
        if name == "stats":
            fields[name] = found.statistics.as_dict()
        if name in HEAD:
            continue
        attribute = model.ATTRIBUTES.get(name, name)
        value = (changes or {}).get(name, getattr(found, attribute, None))
        if value is not None:
            fields[name] = _plain(name, value, field.annotation)
    return fields


def fill(plan: Any, fields: dict[str, Any], model: type[PlanFields]) -> None:
    """Gives an empty plan the fields of a file."""
    plan.status = plan._status(fields["status"])
    known = plan.statistics.as_dict()
    stats = {name: value for name, value in fields["stats"].items() if name in known}
    plan.statistics = type(plan.statistics)(**stats)
    for name, field in model.model_fields.items():
        if name not in (*HEAD, "status") and fields.get(name) is not None:
            value = _built(name, fields[name], field.annotation)
            setattr(plan, model.ATTRIBUTES.get(name, name), value)


def _plain(name: str, value: Any, annotation: Any) -> Any:
    if _is_pose(name):
        X = np.asarray(value)
        return frames.to_row(X) if X.ndim == 2 else frames.to_rows(X)
    inner = _table_in(annotation)
    if inner is not None and _is_list(annotation):
        return [fields_of(item, inner) for item in value]
    if inner is not None:
        return fields_of(value, inner)
    return _numbers(value)


def _numbers(value: Any) -> Any:
    if isinstance(value, np.ndarray) and value.ndim == 3:
        # Points; those of a finger that is off the object are NaN.
        return [[None if p[0] != p[0] else p for p in row] for row in value.tolist()]
    return plain(value)


def _built(name: str, value: Any, annotation: Any) -> Any:
    if _is_pose(name):
        return frames.from_rows(value) if _is_list(annotation, of=list) else frames.from_row(value)
    inner = _table_in(annotation)
    if inner is not None and _is_list(annotation):
        return [_struct(item, inner) for item in value]
    if inner is not None:
        return _struct(value, inner)
    if annotation == list[list[float]] and not value:
        return np.zeros((0, 0))
    return value


def _struct(fields: dict[str, Any], model: type[Table]) -> Any:
    given = {
        model.ATTRIBUTES.get(name, name): _built(name, fields[name], field.annotation)
        for name, field in model.model_fields.items()
        if fields.get(name) is not None
    }
    return model.MAKE(**given)


def _is_pose(name: str) -> bool:
    return name.startswith("X_") or name == "object_poses"


@cache
def _is_list(annotation: Any, of: Any = None) -> bool:
    """True of list[...]; with `of`, of a list of such."""
    if get_origin(annotation) is not list:
        return False
    item = get_args(annotation)[0]
    item = get_args(item)[0] if get_origin(item) is Annotated else item
    return of is None or get_origin(item) is of


@cache
def _table_in(annotation: Any) -> type[Table] | None:
    if isinstance(annotation, type) and issubclass(annotation, Table):
        return annotation
    inner = (_table_in(item) for item in get_args(annotation))
    return next((found for found in inner if found is not None), None)


def require_rows(
    where: str, joint_rows: list[list[float]], object_poses: list[list[float]], dof: int
) -> None:
    """Raises unless there is one value a joint in each row, and one pose a row."""
    if len(joint_rows) != len(object_poses):
        counts = f"{len(joint_rows)} positions and {len(object_poses)} poses"
        raise ValueError(f"{where} has {counts}: one per row is needed")
    for i, row in enumerate(joint_rows):
        if len(row) != dof:
            raise ValueError(f"row {i} of {where} has {len(row)} values for {dof} joint_names")
    require_unit_quaternions(object_poses)


def require_unit_quaternions(rows: list[list[float]]) -> None:
    """Raises unless every row is a pose: x y z qw qx qy qz."""
    for row in rows:
        if abs(sum(value * value for value in row[3:]) - 1) > 1e-6:
            raise ValueError(f"quaternion {row[3:]} is not of unit length")


def schema() -> dict[str, Any]:
    """Returns the JSON schema of plan files."""
    files: Any = reduce(or_, [table(kind) for kind in KINDS])
    adapter: TypeAdapter[Any] = TypeAdapter(Annotated[files, Discriminator("kind")])
    return {"title": "PlanFile", **adapter.json_schema()}


__all__ = ["BaseModel", "PlanFields", "PoseRow", "Table", "fields_of", "fill", "schema", "table"]
