# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Motion of the object in task files."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from ..shapes import Count, CountOrZero, Fields, Point3, Pose, Positive

MOST_POSES = 100_000  # of a motion
MOST_SEGMENTS = MOST_POSES - 1
Segments = Annotated[int, Field(ge=1, le=MOST_SEGMENTS)]
Side = Literal["+x", "-x", "+y", "-y"]
STANDING = "of O in the world; default: standing on the floor over the origin, unturned"


class Slide(Fields):
    """A straight slide."""

    pose: Pose | None = Field(default=None, description=STANDING)
    translation: Point3 = Field(description="translation in the world [m]")
    segments: Segments = 30


class Turn(Fields):
    """A turn on the floor."""

    pose: Pose | None = Field(default=None, description=STANDING)
    point: Point3 | None = Field(
        default=None, description="point on the axis [m]; default: the centre of mass"
    )
    axis: Point3 = Field(default=[0.0, 0.0, 1.0], description="axis in the world")
    angle: float = Field(description="angle, right-handed about the axis [rad]")
    segments: Segments = 30


class Tumble(Fields):
    """Tumble over an edge of the face that the object stands on."""

    pose: Pose | None = Field(default=None, description=STANDING)
    over: Side | None = Field(
        default=None,
        description="side of the face that the object stands on, whose edge it tumbles over",
    )
    point: Point3 | None = Field(default=None, description="instead of over: point on the edge [m]")
    axis: Point3 | None = Field(default=None, description="with point: direction of the edge")
    angle: Positive | None = Field(
        default=None, description="angle [rad]; with over, by default until the next face lies down"
    )
    segments: Segments = 30

    @model_validator(mode="after")
    def _check(self) -> Tumble:
        self.one_of("over", "point")
        if (self.point is None) != (self.axis is None):
            raise ValueError("point and axis must be given together")
        if self.point is not None and self.angle is None:
            raise ValueError("angle must be given with point and axis [rad]")
        return self


class Step(Fields):
    """Part of a sequence. It starts at the end of the part before it."""

    slide: Slide | None = None
    turn: Turn | None = None
    tumble: Tumble | None = None

    @model_validator(mode="after")
    def _check(self) -> Step:
        self.one_of("slide", "turn", "tumble")
        return self


class Lattice(Fields):
    """Motion over the floor from start to goal, through a lattice of positions and yaws."""

    start: Pose | None = Field(default=None, description=STANDING)
    goal: Pose = Field(description="pose of O in the world, on the lattice")
    lower: Point3 = Field(description="least x, y, yaw relative to the start [m, m, rad]")
    upper: Point3 = Field(description="largest x, y, yaw relative to the start [m, m, rad]")
    counts: Annotated[list[Count], Field(min_length=3, max_length=3)] = Field(
        default=[30, 30, 30],
        description="number of values of x, y and yaw, with start and goal among them: 1 where "
        "lower and upper are equal, an odd number where the start is in their middle",
    )


class Goal(Fields):
    """Goal pose of the object, on any face. The planner finds the motion."""

    start: Pose | None = Field(default=None, description=STANDING)
    pose: Pose = Field(description="pose of O in the world")
    slide_step: Positive | None = Field(default=None, description="longest step of a slide [m]")
    turn_step: Positive | None = Field(default=None, description="largest step of a turn [rad]")
    max_tumbles: CountOrZero | None = None


class Motion(Fields):
    """Motion of the object: exactly one of these fields."""

    slide: Slide | None = None
    turn: Turn | None = None
    tumble: Tumble | None = None
    path: Annotated[list[Pose], Field(min_length=2, max_length=MOST_POSES)] | None = Field(
        default=None,
        description="poses of O in the world; the object moves along a screw from each to the next",
    )
    sequence: Annotated[list[Step], Field(min_length=1)] | None = None
    lattice: Lattice | None = None
    goal: Goal | None = None

    @model_validator(mode="after")
    def _check(self) -> Motion:
        self.one_of("slide", "turn", "tumble", "path", "sequence", "lattice", "goal")
        return self
