# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Model of task files of kind fingertip; docs/task-files.md describes the fields.

A task in a plan file has the same fields, with the content of the robot's files. Meshes stay
files, and `files` has their checksums.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import AfterValidator, Discriminator, Field, Tag, model_validator

from ..._core import fingertip, mechanics
from ..budget import Budget
from ..obstacles import Obstacles
from ..options import described_by
from ..robots import Robot
from ..shapes import (
    Fields,
    MeshFile,
    NotNegative,
    Point3,
    Positive,
    Size3,
    Triangle,
    given_twice,
)
from .motion import Motion

Direction = Annotated[list[float], Field(min_length=6, max_length=6)]


def _kind_of_friction(value: Any) -> str:
    return "interval" if isinstance(value, list) else "number"


def _kind_of_inertia(value: Any) -> str:
    return "matrix" if value and isinstance(value, list) and isinstance(value[0], list) else "axes"


def _in_order(bounds: list[float]) -> list[float]:
    if bounds[0] > bounds[1]:
        raise ValueError(f"{bounds}: the first must not exceed the second")
    return bounds


Friction = Annotated[
    Annotated[NotNegative, Tag("number")]
    | Annotated[
        Annotated[list[NotNegative], Field(min_length=2, max_length=2), AfterValidator(_in_order)],
        Tag("interval"),
    ],
    Discriminator(_kind_of_friction),
]
Inertia = Annotated[
    Annotated[Size3, Tag("axes")]
    | Annotated[Annotated[list[Point3], Field(min_length=3, max_length=3)], Tag("matrix")],
    Discriminator(_kind_of_inertia),
]


OWN_FRICTION = "coefficient of friction of the object on this plane, instead of the task's"


class Object(Fields):
    """Object to move: a box or any closed mesh, in a frame O."""

    name: str = "object"
    box: Size3 | None = Field(default=None, description="side lengths of a box centred at O [m]")
    mesh: MeshFile | None = Field(default=None, description="closed triangle mesh in a file")
    vertices: Annotated[list[Point3], Field(min_length=4)] | None = Field(
        default=None, description="vertices of the mesh, in O [m]"
    )
    triangles: Annotated[list[Triangle], Field(min_length=4)] | None = Field(
        default=None, description="triangles of the mesh: three vertex indices each, from 0"
    )
    mass: Positive | None = Field(default=None, description="mass [kg]")
    density: Positive | None = Field(default=None, description="instead of mass: density [kg/m^3]")
    com: Point3 | None = Field(
        default=None, description="centre of mass in O [m]; by default that of a uniform density"
    )
    inertia: Inertia | None = Field(
        default=None,
        description="inertia about the centre of mass, in O [kg m^2]: 3 x 3, or its diagonal; by "
        "default that of a uniform density",
    )

    @model_validator(mode="after")
    def _check(self) -> Object:
        self.one_of("box", "mesh", "vertices")
        self.one_of("mass", "density")
        if (self.vertices is None) != (self.triangles is None):
            raise ValueError("vertices and triangles must be given together")
        return self


class Fingers(Fields):
    """Fingertips: equal spheres that neither slide nor roll."""

    count: Annotated[int, Field(ge=1, le=4)] = 2
    radius: Positive = Field(default=0.01, description="radius of a fingertip [m]")
    max_normal_force: Positive = Field(
        default=10.0, description="upper limit of the normal force of a fingertip [N]"
    )
    max_span: Positive | None = Field(
        default=None, description="largest distance between the centres of two fingertips [m]"
    )
    friction: Friction = Field(
        default=0.7,
        description="coefficient of friction between fingertip and object, or [lower, upper]",
    )
    start: list[Point3] = Field(
        default=[],
        description="contact point of each finger at the start, in the object's frame [m]; "
        "none: the planner chooses",
    )


class Floor(Fields):
    """Level plane under the object."""

    height: float = Field(default=0.0, description="height in the world [m]")
    friction: Friction | None = Field(default=None, description=OWN_FRICTION)


class Wall(Fields):
    """A half-space that the object may touch and the fingertips may not."""

    name: str = "wall"
    normal: Point3 = Field(description="normal in the world, out of the wall")
    offset: float | None = Field(
        default=None, description="offset of the surface along the normal [m]"
    )
    point: Point3 | None = Field(
        default=None, description="instead of offset: point on the surface [m]"
    )
    friction: Friction | None = Field(default=None, description=OWN_FRICTION)

    @model_validator(mode="after")
    def _check(self) -> Wall:
        self.one_of("offset", "point")
        return self


@described_by(mechanics.Compliance)
class Compliance(Fields):
    """Springs at the contacts, of which only ratios matter: docs/reference/options.md."""


@described_by(fingertip.Options)
class Options(Fields):
    """Options of the search: docs/reference/options.md."""

    disturbance_directions: list[Direction] | None = Field(
        default=None, description="(N, 6) directions; default: the paper's 76"
    )
    compliance: Compliance = Compliance.model_construct()


class Carrier(Fields):
    """Parts of the robot that carry the fingertips."""

    fingertips: Annotated[list[str], Field(min_length=1)] | None = Field(
        default=None, description="frames at the centres of the spheres, one for each finger"
    )
    links: list[list[str]] | None = Field(
        default=None, description="for each finger, the links that may touch the object"
    )


@described_by(fingertip.RealizeOptions)
class Realize(Fields):
    """Options of the joint paths: docs/reference/options.md."""


class FingertipTask(Fields):
    """A task for the fingertip planner."""

    kind: Literal["fingertip"]
    object: Object
    fingers: Fingers = Fingers()
    floor: Floor = Floor()
    walls: list[Wall] = []
    friction: Friction = Field(
        default=0.5,
        description="coefficient of friction of the object on floor and walls without their own, "
        "or [lower, upper]",
    )
    gravity: Point3 = Field(
        default=[0.0, 0.0, -9.8], description="acceleration of gravity in the world [m/s^2]"
    )
    motion: Motion
    obstacles: Obstacles = []
    robot: Robot | None = Field(default=None, description="robot that carries the fingertips")
    carrier: Carrier | None = None
    realize: Realize | None = None
    options: Options = Options.model_construct()
    budget: Budget = Budget.model_construct()
    files: dict[str, str] = Field(
        default={}, description="sha256 of each mesh that the task reads; only in plan files"
    )

    @model_validator(mode="after")
    def _check(self) -> FingertipTask:
        if twice := given_twice(["floor", *(wall.name for wall in self.walls)]):
            raise ValueError(f"walls: name given twice: {twice}")
        for field in ("carrier", "realize"):
            if getattr(self, field) is not None and self.robot is None:
                raise ValueError(f"{field} is for a robot, and none is given")
        return self
