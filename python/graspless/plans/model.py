# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What plan files of all kinds hold, format 1; `plan.schema.json` is made from these models."""

from __future__ import annotations

from functools import reduce
from operator import or_
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, TypeAdapter

from ..kinds import KINDS, part
from ..tasks.shapes import Fields

PoseRow = Annotated[list[float], Field(min_length=7, max_length=7)]


class PlanFields(Fields):
    """A plan with its whole task; each kind adds its segments and the task."""

    format: Literal[1]
    kind: str
    version: str = Field(description="of graspless, that wrote it")
    status: str
    reason: str = Field(description="one sentence, for people")
    seed: int
    stats: dict[str, float | int | dict[str, int]] = Field(description="what the search did")


def require_unit_quaternions(rows: list[list[float]]) -> None:
    """Raises unless every row is a pose: x y z qw qx qy qz."""
    for row in rows:
        if abs(sum(value * value for value in row[3:]) - 1) > 1e-6:
            raise ValueError(f"quaternion {row[3:]} is not of unit length")


def schema() -> dict[str, Any]:
    """The JSON schema of plan files."""
    files: Any = reduce(or_, [part("plans", kind).File for kind in KINDS])
    adapter: TypeAdapter[Any] = TypeAdapter(Annotated[files, Discriminator("kind")])
    document = adapter.json_schema()
    return {"title": "PlanFile", **document}
