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
from itertools import islice
from operator import or_
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    ClassVar,
    Literal,
    NamedTuple,
    get_args,
    get_origin,
)

import numpy as np
from pydantic import ConfigDict, Discriminator, Field, TypeAdapter

from .. import frames
from ..kinds import KINDS, part
from ..tasks.effective_values import plain
from ..tasks.shapes import Fields, Seed
from .proof import ProofFields

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from ..frames import Matrix

PoseRow = Annotated[list[float], Field(min_length=7, max_length=7)]
HEAD = ("format", "kind", "version", "seed", "stats", "proof", "task")


class Table(Fields):
    """Struct of the planner in the form of the file."""

    MAKE: ClassVar[Callable[..., Any]]
    """Constructor of the planner's own type, which takes the fields by name."""

    ATTRIBUTES: ClassVar[dict[str, str]] = {}
    """Attributes that are not called as the field is."""


class MotionRows(Table):
    """Part of a motion."""

    name: str
    positions: list[list[float]] = Field(description="(N, dof) joint positions, rad or m")
    object_poses: list[PoseRow] = Field(
        description="(N, 7) poses of the object, x y z qw qx qy qz in the world"
    )

    def check(self, dof: int) -> None:
        """Raises unless there is one value per joint in each row, and one pose per row."""
        require_rows(f"segment '{self.name}'", self.positions, self.object_poses, dof)


class Counters(Fields):
    """Counters of the search. Former ones, in older plan files, are ignored."""

    model_config = ConfigDict(extra="ignore")


class PlanFields(Table):
    """A plan with its whole task; each kind adds its segments and the task."""

    format: Literal[1]
    kind: str
    version: str = Field(description="version of graspless that wrote the file")
    status: str
    reason: str = Field(description="explanation in one sentence; a solved plan may have none")
    seed: Seed
    stats: Counters = Field(description="counters of the search")
    proof: ProofFields | None = Field(
        default=None, description="trials in the physics engine, if the plan was made with `prove`"
    )


def table(kind: str) -> type[PlanFields]:
    """Returns the table of a kind."""
    file: type[PlanFields] = part("plan_files", kind).File
    return file


class Column(NamedTuple):
    """Field of a table, as both directions need it."""

    name: str
    attribute: str
    is_pose: bool
    is_list: bool  # of structs, or of poses
    is_matrix: bool
    inner: type[Table] | None


@cache
def columns(model: type[Table]) -> list[Column]:
    """Returns the fields of a table without the head."""
    found = []
    for name, field in model.model_fields.items():
        if name not in HEAD:
            kind, inner = field.annotation, _table_in(field.annotation)
            is_pose = name.startswith("X_") or name == "object_poses"
            is_list = _is_list(kind, of=list) if is_pose else _is_list(kind)
            attribute = model.ATTRIBUTES.get(name, name)
            is_matrix = kind == list[list[float]]
            found.append(Column(name, attribute, is_pose, is_list, is_matrix, inner))
    return found


def fields_of(
    found: Any,
    model: type[PlanFields],
    changes: dict[str, Any] | None = None,
    known: Any = None,
) -> dict[str, Any]:
    """Returns the fields of a plan in plain types; None is left out, and so is the head.

    `known` are the rows [N, 7] of all its poses, as `adopt` returns them.
    """
    poses: list[tuple[list[Any], Matrix]] = []
    fields = {"stats": found.statistics.as_dict()}
    fields |= _fields(found, model, changes or {}, poses, _numbers)
    every = _joined([X for _, X in poses])
    is_known = known is not None and len(known) == len(every)
    rows = iter((known if is_known else frames.to_rows(every)).tolist())
    for row, X in poses:
        row += islice(rows, len(X)) if X.ndim == 3 else next(rows)
    return fields


def adopt(plan: Any, found: Any, model: type[PlanFields]) -> Matrix:
    """Gives an empty plan what a planner found, in the numbers of its file.

    Returns the rows [N, 7] of all its poses, of which `fields_of` makes the file later.
    """
    poses: list[tuple[list[Any], Matrix]] = []
    values = _fields(found, model, {}, poses, lambda value: value)
    rows = frames.to_rows(_joined([X for _, X in poses]))
    parts = _split(frames.from_rows(rows), [len(X) if X.ndim == 3 else None for _, X in poses])
    plan.statistics = found.statistics
    for attribute, value in _attributes(values, model, parts).items():
        setattr(plan, attribute, value)
    return rows


def _joined(poses: list[Matrix]) -> Matrix:
    """Returns poses [4, 4] and [N, 4, 4] in one array, to convert them in one call."""
    return np.concatenate([np.zeros((0, 4, 4)), *(X.reshape(-1, 4, 4) for X in poses)])


def _split(every: Matrix, counts: Iterable[int | None]) -> Iterator[Matrix]:
    """Yields as many of the poses [N, 4, 4] as are counted; None: a single one [4, 4]."""
    end = 0
    for count in counts:
        begin, end = end, end + (1 if count is None else count)
        yield every[begin] if count is None else every[begin:end]


@cache
def posed(model: type[Table]) -> frozenset[str]:
    """Returns the attributes that are poses, or structs with poses."""
    return frozenset(
        column.attribute
        for column in columns(model)
        if column.is_pose or (column.inner is not None and posed(column.inner))
    )


def _fields(
    found: Any,
    model: type[Table],
    changes: dict[str, Any],
    poses: list[tuple[list[Any], Matrix]],
    leaf: Callable[[Any], Any],
) -> dict[str, Any]:
    """Returns the fields of a struct: `leaf` of each value, structs in it likewise.

    Lists of rows are empty, and added to `poses`.
    """
    fields: dict[str, Any] = {}
    for column in columns(model):
        value = changes.get(column.name, getattr(found, column.attribute, None))
        if value is None:
            continue
        if column.is_pose:
            poses.append(([], np.asarray(value, dtype=float)))
            fields[column.name] = poses[-1][0]
        elif column.inner is None:
            fields[column.name] = leaf(value)
        elif column.is_list:
            fields[column.name] = [_fields(item, column.inner, {}, poses, leaf) for item in value]
        else:
            fields[column.name] = _fields(value, column.inner, {}, poses, leaf)
    return fields


def fill(plan: Any, fields: dict[str, Any], model: type[PlanFields]) -> Matrix:
    """Gives an empty plan the fields of a file. Returns the rows [N, 7] of all its poses."""
    plan.status = plan._status(fields["status"])
    known = plan.statistics.as_dict()
    given = fields["stats"].items()
    stats = {name: value for name, value in given if name in known and value is not None}
    plan.statistics = type(plan.statistics)(**stats)
    given = {name: value for name, value in fields.items() if name != "status"}
    found = list(_pose_fields(given, model))
    rows = np.asarray([row for rows, _ in found for row in rows], dtype=float).reshape(-1, 7)
    poses = _split(
        frames.from_rows(rows), [len(rows) if is_list else None for rows, is_list in found]
    )
    for attribute, value in _attributes(given, model, poses).items():
        setattr(plan, attribute, value)
    return rows


def _pose_fields(fields: dict[str, Any], model: type[Table]) -> Iterator[tuple[list[Any], bool]]:
    """Yields the rows of each field of poses, and if it is a list."""
    for name, _, is_pose, is_list, _, inner in columns(model):
        value = fields.get(name)
        if value is None:
            continue
        if is_pose:
            yield value if is_list else [value], is_list
        elif inner is not None:
            for item in value if is_list else [value]:
                yield from _pose_fields(item, inner)


def _attributes(
    fields: dict[str, Any], model: type[Table], poses: Iterator[Matrix]
) -> dict[str, Any]:
    """Returns the attributes of a struct, with the next ones of `poses`."""
    attributes: dict[str, Any] = {}
    for name, attribute, is_pose, is_list, is_matrix, inner in columns(model):
        value = fields.get(name)
        if value is None:
            continue
        if is_pose:
            value = next(poses)
        elif inner is not None and is_list:
            value = [inner.MAKE(**_attributes(item, inner, poses)) for item in value]
        elif inner is not None:
            value = inner.MAKE(**_attributes(value, inner, poses))
        elif is_matrix and len(value) == 0:
            value = np.zeros((0, 0))
        attributes[attribute] = value
    return attributes


def _numbers(value: Any) -> Any:
    if isinstance(value, np.ndarray) and value.ndim == 3:
        # Points; those of a finger that is off the object are NaN.
        return [[None if p[0] != p[0] else p for p in row] for row in value.tolist()]
    return plain(value)


def _is_list(annotation: Any, of: Any = None) -> bool:
    """True of list[...]; with `of`, of a list of such."""
    if get_origin(annotation) is not list:
        return False
    item = get_args(annotation)[0]
    item = get_args(item)[0] if get_origin(item) is Annotated else item
    return of is None or get_origin(item) is of


def _table_in(annotation: Any) -> type[Table] | None:
    if isinstance(annotation, type) and issubclass(annotation, Table):
        return annotation
    inner = (_table_in(item) for item in get_args(annotation))
    return next((found for found in inner if found is not None), None)


def require_rows(
    where: str, joint_rows: list[list[float]], object_poses: list[list[float]], dof: int
) -> None:
    """Raises unless there is one value per joint in each row, and one pose per row."""
    if len(joint_rows) != len(object_poses):
        counts = f"{len(joint_rows)} positions and {len(object_poses)} poses"
        raise ValueError(f"{where} has {counts}: one per row is needed")
    lengths = list(map(len, joint_rows))
    if set(lengths) - {dof}:
        i = next(i for i, length in enumerate(lengths) if length != dof)
        raise ValueError(f"row {i} of {where} has {lengths[i]} values for {dof} joint_names")
    require_unit_quaternions(object_poses)


def require_unit_quaternions(rows: list[list[float]]) -> None:
    """Raises unless every row is a pose: x y z qw qx qy qz."""
    if not rows:
        return
    quaternions = np.array(rows)[:, 3:]
    wrong = np.flatnonzero(np.abs(np.square(quaternions).sum(axis=1) - 1) > 1e-6)
    if len(wrong):
        raise ValueError(f"quaternion {rows[wrong[0]][3:]} is not of unit length")


def schema() -> dict[str, Any]:
    """Returns the JSON schema of plan files."""
    files: Any = reduce(or_, [table(kind) for kind in KINDS])
    adapter: TypeAdapter[Any] = TypeAdapter(Annotated[files, Discriminator("kind")])
    return {"title": "PlanFile", **adapter.json_schema()}
