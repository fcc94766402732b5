# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Poses, shapes and obstacles as files write them."""

from __future__ import annotations

import math
from collections import Counter
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, model_validator

from .. import frames

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ..frames import Matrix

Positive = Annotated[float, Field(gt=0)]
MOST_PADDING = 0.5  # [m]
Padding = Annotated[float, Field(ge=0, le=MOST_PADDING)]
NotNegative = Annotated[float, Field(ge=0)]
Point2 = Annotated[list[float], Field(min_length=2, max_length=2)]
Point3 = Annotated[list[float], Field(min_length=3, max_length=3)]
LARGEST_INT = 2**31 - 1  # of the core
Count = Annotated[int, Field(ge=1, le=LARGEST_INT)]
CountOrZero = Annotated[int, Field(ge=0, le=LARGEST_INT)]
Index = CountOrZero
IndexOrNone = Annotated[int, Field(ge=-1, le=LARGEST_INT)]
Seed = Annotated[int, Field(ge=0, lt=2**64)]
Triangle = Annotated[list[Index], Field(min_length=3, max_length=3)]
Points2 = Annotated[list[Point2], Field(min_length=3)]
Size2 = Annotated[list[Positive], Field(min_length=2, max_length=2)]
Size3 = Annotated[list[Positive], Field(min_length=3, max_length=3)]


def _along_each_axis(value: Any) -> Any:
    return [value] * 3 if isinstance(value, (int, float)) else value


def _not_zero(direction: list[float]) -> list[float]:
    if math.hypot(*direction) < 1e-9:
        raise ValueError(f"{direction}: must not be zero")
    return direction


Direction = Annotated[Point3, AfterValidator(_not_zero)]


Scale3 = Annotated[Size3, BeforeValidator(_along_each_axis)]


class Fields(BaseModel):
    """Base of all: unknown fields, text for numbers and NaN are refused."""

    # Validators of a file's parts are built with that of the file, and only of the kinds in use.
    model_config = ConfigDict(extra="forbid", strict=True, allow_inf_nan=False, defer_build=True)

    def one_of(self, *names: str, needed: bool = True) -> None:
        """Raises ValueError unless exactly one field is given (at most one if not `needed`)."""
        given = [name for name in names if getattr(self, name) is not None]
        if len(given) > 1 or (needed and not given):
            count = "exactly one" if needed else "at most one"
            found = " and ".join(given) or "none"
            raise ValueError(f"{count} of {', '.join(names)} must be given, not {found}")

    def first_of(self, *names: str) -> str:
        """Returns the first of some fields, by default of all, that is given."""
        fields = names or type(self).model_fields
        return next(name for name in fields if getattr(self, name) is not None)


def given_twice(names: Iterable[str]) -> str:
    """Returns the names that occur more than once, as text."""
    return ", ".join(sorted(name for name, times in Counter(names).items() if times > 1))


class Pose(Fields):
    """Pose of a frame in another; angles about fixed x, y, z as in URDF."""

    position: Point3 = Field(default=[0.0, 0.0, 0.0], description="position [m]")
    rpy: Point3 | None = Field(default=None, description="roll, pitch, yaw [rad]")
    quaternion: Annotated[list[float], Field(min_length=4, max_length=4)] | None = Field(
        default=None, description="unit quaternion w, x, y, z"
    )

    @model_validator(mode="after")
    def _check(self) -> Pose:
        self.one_of("rpy", "quaternion", needed=False)
        if self.quaternion and abs(math.hypot(*self.quaternion) - 1) > 1e-3:
            raise ValueError(f"quaternion has length {math.hypot(*self.quaternion):.4g}, not 1")
        return self


def pose_matrix(pose: Pose) -> Matrix:
    """Returns the 4 x 4 matrix of a pose in a file."""
    if pose.quaternion is not None:
        return frames.translation(pose.position) @ frames.from_quaternion(pose.quaternion)
    return frames.translation(pose.position) @ frames.from_rpy(pose.rpy or [0.0, 0.0, 0.0])


class PlanarPose(Fields):
    """Pose of the object on the support, in S."""

    x: float = Field(default=0.0, description="x [m]")
    y: float = Field(default=0.0, description="y [m]")
    yaw: float = Field(default=0.0, description="yaw [rad]")


class Circle(Fields):
    """A circle as a regular polygon."""

    center: Point2 = Field(default=[0.0, 0.0], description="centre [m]")
    radius: Positive = Field(description="radius [m]")
    points: Annotated[int, Field(ge=3, le=10000)] = 100


class Rectangle(Fields):
    """A rectangle with sides along x and y."""

    center: Point2 = Field(default=[0.0, 0.0], description="centre [m]")
    size: Size2 = Field(description="side lengths along x and y [m]")


class Sphere(Fields):
    """Centred at its frame's origin."""

    radius: Positive = Field(description="radius [m]")


class Rod(Fields):
    """A cylinder or capsule along z, centred at its frame's origin."""

    radius: Positive = Field(description="[m]")
    length: Positive = Field(description="along z; of a capsule without its half spheres [m]")


class MeshFile(Fields):
    """A triangle mesh in a file."""

    file: str = Field(description=".stl, .obj, .off or .ply")
    scale: Scale3 = Field(default=[1.0, 1.0, 1.0], description="factor, or one per axis")
    unit: Literal["m", "mm"] = Field(default="m", description="unit of the file")

    @property
    def factors(self) -> Matrix:
        """Factors from the numbers in the file to metres, one per axis [3]."""
        return np.array(self.scale) * (0.001 if self.unit == "mm" else 1.0)


class Named(Fields):
    """Something with a name."""

    name: str


class Shape(Fields):
    """Shape at a pose."""

    box: Size3 | None = Field(default=None, description="side lengths [m]")
    sphere: Sphere | None = None
    capsule: Rod | None = None
    cylinder: Rod | None = None
    mesh: MeshFile | None = None
    pose: Pose = Field(
        default=Pose.model_construct(),
        description="pose in the world; for a part, in its body's frame",
    )
    convex: Annotated[list[Point3], Field(min_length=4)] | None = Field(
        default=None, description="instead: convex hull of these points [m]"
    )
    vertices: Annotated[list[Point3], Field(min_length=3)] | None = Field(
        default=None, description="instead: of a mesh [m]"
    )
    triangles: list[Triangle] | None = Field(
        default=None, description="of that mesh: three vertices each, from 0"
    )

    @model_validator(mode="after")
    def _check(self) -> Shape:
        self.one_of(*self.CHOICES)
        if (self.vertices is None) != (self.triangles is None):
            raise ValueError("vertices and triangles must be given together")
        return self

    CHOICES: ClassVar[tuple[str, ...]] = (
        "box",
        "sphere",
        "capsule",
        "cylinder",
        "mesh",
        "convex",
        "vertices",
    )


class Obstacle(Shape, Named):
    """Body that neither the arm nor the object may touch."""

    parts: Annotated[list[Shape], Field(min_length=1)] | None = Field(
        default=None, description="instead: several shapes, in the obstacle's frame"
    )
    padding: Padding = Field(default=0.0, description="distance that motions keep [m]")

    CHOICES: ClassVar[tuple[str, ...]] = (*Shape.CHOICES, "parts")


def regular_polygon(radius: float, n: int) -> Matrix:
    """[n, 2] corners about the origin, the first on x."""
    angles = 2 * np.pi * np.arange(n) / n
    return np.asarray(radius * np.column_stack([np.cos(angles), np.sin(angles)]))
