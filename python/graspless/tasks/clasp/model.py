# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Model of task files of kind clasp; docs/task-files.md describes the fields.

A task in a plan file has the same fields, with the content of the robot's files, the hand and the
object's points. Meshes of robot and obstacles stay files, and `files` has their checksums.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag, model_validator

from ..._core import clasp
from ..budget import Budget
from ..obstacles import Obstacles
from ..options import described_by
from ..rays import Rays
from ..robots import Robot
from ..scenes import PADDING, RESPECT, Respect, require_scene
from ..shapes import (
    Count,
    Fields,
    Index,
    MeshFile,
    NotNegative,
    Padding,
    Point3,
    Pose,
    Positive,
    Seed,
)
from .hand import Hand


def _kind_of_points(value: Any) -> str:
    return "list" if isinstance(value, list) else "count"


Points = Annotated[
    Annotated[Annotated[int, Field(ge=20, le=1_000_000)], Tag("count")]
    | Annotated[list[Point3], Tag("list")],
    Discriminator(_kind_of_points),
]


class LoopOptions(Fields):
    """Options of the search for holes: graspless.geometry.LoopOptions."""

    max_edge_length: NotNegative | None = Field(
        default=None, description="d [m]; 0: each hole has its own"
    )
    min_ratio: Annotated[float, Field(ge=1)] | None = Field(
        default=None, description="least width of a hole, relative to gaps between points near it"
    )
    max_points: Count | None = Field(default=None, description="larger clouds are downsampled")
    polish: bool | None = Field(
        default=None, description="shorten the loops of a downsampled cloud on all its points"
    )
    drop_meridians: bool | None = Field(
        default=None, description="discard loops that run around a handle, not along it"
    )
    threads: Annotated[int, Field(ge=1, le=256)] | None = Field(
        default=None, description="threads that share the polishing; loops do not depend on it"
    )
    all_sides: bool | None = Field(
        default=None,
        description="the points are of all sides: no loop is the edge of what a camera saw; "
        "default: of closed meshes without views",
    )


class Object(Fields):
    """Object with a hole, given as a cloud of points on its surface, in a frame O."""

    name: str = "object"
    cloud: str | None = Field(default=None, description="a .ply, .pcd, .xyz or .npy file")
    mesh: MeshFile | None = Field(default=None, description="mesh on which points are sampled")
    scene: str | None = Field(
        default=None,
        description="scene file of `graspless see`, whose object with this name it is",
    )
    respect: Respect = Field(default="objects", description=RESPECT, exclude=True)
    padding: Padding = Field(default=0.0, description=PADDING, exclude=True)
    sample: str | None = Field(
        default=None, description="object that comes with graspless, on which points are sampled"
    )
    points: Points | None = Field(
        default=None,
        description="the points themselves, in O [m]; or the number of points to sample, 2000 by "
        "default",
    )
    unit: Literal["m", "mm"] = Field(default="m", description="unit of the file")
    scale: Positive = Field(default=1.0, description="factor of all lengths, about O")
    views: list[Point3] = Field(
        default=[],
        description="positions of cameras in O [m]; only points that are visible from one of them "
        "are kept, and a place without points is one that rays passed",
    )
    noise: NotNegative = Field(
        default=0.0, description="standard deviation of noise that is added to every coordinate [m]"
    )
    seed: Seed = Field(default=1, description="seed of samples and noise")
    pose: Pose = Field(default=Pose.model_construct(), description="pose of O in the world")
    mass: Positive | None = Field(default=None, description="mass in simulations [kg]")
    rays: list[Rays] = Field(
        default=[],
        description="rays of the cameras that saw the points, in O: a hole is then believed if "
        "some passed through it. A scene has its own",
    )
    loops: LoopOptions = LoopOptions()

    @model_validator(mode="after")
    def _check(self) -> Object:
        if isinstance(self.points, list):
            self.one_of("cloud", "mesh", "sample", "points", "scene")
        else:
            self.one_of("cloud", "mesh", "sample", "scene")
        if self.rays and (not isinstance(self.points, list) or self.scale != 1.0):
            raise ValueError("rays are for points in O without a scale")
        if self.rays and self.views:
            raise ValueError("rays and views must not both be given")
        if self.scene is not None:
            self._check_scene()
        else:
            require_scene(self.model_fields_set)
        if self.cloud is not None and self.points is not None:
            raise ValueError(
                "points is the number of samples of a mesh; a cloud has its own points"
            )
        if self.unit != "m" and self.cloud is None and self.mesh is None:
            raise ValueError("unit is for files: cloud or mesh")
        if self.unit != "m" and self.mesh is not None and self.mesh.unit != "m":
            raise ValueError("unit and mesh.unit must not both be given")
        return self

    def _check_scene(self) -> None:
        if "pose" in self.model_fields_set:
            raise ValueError("pose must not be given: the scene says where it is")
        if "name" not in self.model_fields_set:
            raise ValueError("name must be given: that of the object in the scene")
        if self.points is not None:
            raise ValueError(
                "points is the number of samples of a mesh; a scene has its own points"
            )


class Clasp(Fields):
    """Restriction of the points that may be clasped."""

    loops: list[Index] = Field(
        default=[], description="indices of the loops, 0 is the shortest; empty: any"
    )
    marks: list[Point3] = Field(
        default=[], description="points in O [m], near which to clasp; empty: anywhere"
    )
    pull: Point3 | None = Field(
        default=None, description="direction in the world in which the object will be pulled"
    )


@described_by(clasp.StabilityOptions)
class Stability(Fields):
    """Options of the stability test: docs/reference/options.md."""


@described_by(clasp.CertificateOptions)
class Certificate(Fields):
    """Options of the certificate: docs/reference/options.md."""


# Former options and their values: plan files name them.
_CONSTANTS = {
    "pre_expansions": 0,
    "random_probability": 0.1,
    "restart_cycles": 5,
    "dt": 0.5,
    "max_step": 0.12,
    "blend_distance": 0.02,
    "blend_slope": 120.0,
    "position_damping": 0.2,
    "alignment_damping": 0.1,
    "linking_damping": 0.02,
    "patience": 20.0,
    "linking_weight": 0.3,
    "exploring_step": 0.35,
    "max_connect_steps": 150,
    "shortcut_rounds": 60,
}


@described_by(clasp.Options, _CONSTANTS)
class Options(Fields):
    """Options of the search: docs/reference/options.md."""

    stability: Stability = Stability()
    certificate: Certificate = Certificate()


def _kind_of_hand(value: Any) -> str:
    return "file" if isinstance(value, str) else "fields"


class ClaspTask(Fields):
    """A task for the clasp planner."""

    kind: Literal["clasp"]
    robot: Robot
    hand: (
        Annotated[
            Annotated[str, Tag("file")] | Annotated[Hand, Tag("fields")],
            Discriminator(_kind_of_hand),
        ]
        | None
    ) = Field(
        default=None,
        description="fields of the hand, or their file; default: <urdf>.clasp.yaml beside the URDF",
    )
    object: Object
    clasp: Clasp = Clasp()
    obstacles: Obstacles = []
    options: Options = Options.model_construct()
    budget: Budget = Budget.model_construct()
    files: dict[str, str] = Field(
        default={}, description="sha256 of each mesh that the task reads; only in plan files"
    )
    proposed: str | None = Field(
        default=None,
        description="parts of the robot that were proposed from its URDF; only in plan files",
    )
