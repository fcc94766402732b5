# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Model of task files of kind carry; docs/task-files.md describes the fields.

A carry moves a held object along a straight path, or puts it down. It is mostly a stage of a chain:
fields that are None come from the stage before it.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, model_validator

from ..._core import carry
from ..budget import Budget
from ..clasp.model import Object as ClaspObject
from ..obstacles import Obstacles
from ..options import described_by
from ..robots import Robot
from ..shapes import Direction, Fields, Point3, Pose, Shape, Size3
from ..slide.model import Object as SlideObject
from ..slide.model import Support

LONGEST = 1e4  # path [m], as far as poses may be from the origin


def _posed(value: Any) -> Any:
    """Adds a placeholder pose: a slide's object needs one, but here `pose` gives it."""
    return {"pose": {}, **value} if isinstance(value, dict) else value


class Object(Fields):
    """Held object, described like in a task of the planner that grasped it."""

    name: str = "object"
    box: Size3 | None = Field(default=None, description="side lengths of a box centred at O [m]")
    slide: Annotated[SlideObject, BeforeValidator(_posed)] | None = Field(
        default=None, description="object as in a task of kind slide"
    )
    clasp: ClaspObject | None = Field(default=None, description="object as in a task of kind clasp")
    parts: Annotated[list[Shape], Field(min_length=1)] | None = Field(
        default=None, description="instead: several shapes, in O"
    )

    @model_validator(mode="after")
    def _check(self) -> Object:
        self.one_of("box", "slide", "clasp", "parts")
        return self


class Line(Fields):
    """A straight way."""

    direction: Direction = Field(description="direction in the world, of any length but 0")
    distance: Annotated[float, Field(gt=0, le=LONGEST)] = Field(
        description=f"length of the path, at most {LONGEST:g} [m]"
    )


class Places(Fields):
    """Places where the held object is put down."""

    on: str = Field(
        default="support",
        description="obstacle on which the object then stands; support: that of the stage before",
    )
    normal: Direction = Field(
        default=[0.0, 0.0, 1.0], description="normal of its surface, of any length but 0"
    )
    poses: Annotated[list[Pose], Field(min_length=1)] = Field(
        description="poses of O in the world, the best first"
    )


@described_by(carry.Options)
class Options(Fields):
    """Options of the search: docs/reference/options.md."""


class CarryTask(Fields):
    """Task of the carry planner."""

    kind: Literal["carry"]
    robot: Robot | None = Field(
        default=None,
        description="robot whose home is the configuration in which it holds the object",
    )
    arm: str = Field(default="arm", description="group of joints that carry the hand")
    frame: str | None = Field(default=None, description="link to which the object is fixed")
    object: Object | None = None
    pose: Pose | None = Field(default=None, description="pose of O in the world at the start")
    hanging: Pose | None = Field(
        default=None,
        description="pose of a loose object at the start, as it hangs in the hand; nothing may "
        "touch it there either",
    )
    line: Line | None = Field(default=None, description="straight path along a direction")
    offset: Point3 | None = Field(default=None, description="instead: translation in the world [m]")
    goal: Pose | None = Field(
        default=None, description="instead: pose of O in the world at the end"
    )
    place: Places | None = Field(
        default=None, description="instead: places, at the first of which that works it is put down"
    )
    open: list[float] | None = Field(
        default=None,
        description="with a place: all joints, of which those of the hand open it [rad or m]",
    )
    way_out: list[list[float]] | None = Field(
        default=None,
        description="with a place: all joints, on a way along which the hand leaves the object, "
        "from open around it; relative to the object, it leaves the same way. Default: straight",
    )
    down: Direction | None = Field(
        default=None,
        description="with a place: direction in O in which the object comes down; by default "
        "against the normal",
    )
    support: Support | None = Field(
        default=None, description="support of the slide before the carry"
    )
    rests_on: list[str] = Field(
        default=[], description="obstacles that the object rests on and may be dragged over"
    )
    obstacles: Obstacles | None = None
    options: Options = Options.model_construct()
    budget: Budget = Budget.model_construct()
    files: dict[str, str] = Field(
        default={}, description="sha256 of each mesh that the task reads; only in plan files"
    )

    @model_validator(mode="after")
    def _check(self) -> CarryTask:
        self.one_of("line", "offset", "goal", "place")
        if self.offset is not None and not any(self.offset):
            raise ValueError("offset must not be zero")
        return self
