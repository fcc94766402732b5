# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Model of task files of kind chain; docs/task-files.md describes the fields.

In a plan file, every stage is a complete task of its kind. It contains the fields that the chain
gives to all stages, and the content of all files.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field

from ..budget import Budget
from ..shapes import Fields

SHARED = (
    "robot", "hand", "object", "support", "obstacles", "fingers", "floor", "walls", "friction",
    "gravity", "carrier", "realize",
)  # fmt: skip


class Options(Fields):
    """Options of the search: docs/reference/options.md."""

    attempts: Annotated[int, Field(ge=1, le=1000)] = Field(
        default=5,
        description="number of searches from the first stage on: another one follows if a stage "
        "cannot continue the others",
    )


class ChainTask(Fields):
    """Tasks one after the other, each from the state that the one before it left."""

    kind: Literal["chain"]
    robot: dict[str, Any] | None = Field(
        default=None, description="robot of every stage with an arm"
    )
    hand: dict[str, Any] | str | None = None
    object: dict[str, Any] | None = None
    support: dict[str, Any] | None = None
    obstacles: list[Any] | None = None
    fingers: dict[str, Any] | None = None
    floor: dict[str, Any] | None = None
    walls: list[Any] | None = None
    friction: float | list[float] | None = None
    gravity: list[float] | None = None
    carrier: dict[str, Any] | None = None
    realize: dict[str, Any] | None = None
    stages: Annotated[list[dict[str, Any]], Field(min_length=1)] = Field(
        description="stages: {name, kind, fields of a task of that kind} or {name, file, fields}"
    )
    options: Options = Options.model_construct()
    budget: Budget = Budget.model_construct()
    files: dict[str, str] = Field(
        default={}, description="sha256 of each mesh that a stage reads; only in plan files"
    )
