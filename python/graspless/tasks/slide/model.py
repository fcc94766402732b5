# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Model of task files of kind slide; docs/task-files.md describes the fields.

A task in a plan file has the same fields, with the content of every file that it names
(`urdf_text` for `urdf`, `points` for `cloud`, and so on). Meshes stay files, and `files` has their
checksums.
"""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag, model_validator

from ..._core import slide
from ..budget import Budget
from ..obstacles import Obstacles
from ..options import described_by
from ..robots import Robot
from ..scenes import PADDING, RESPECT, Respect, require_scene
from ..shapes import (
    Circle,
    Fields,
    Index,
    NotNegative,
    Padding,
    PlanarPose,
    Point2,
    Point3,
    Points2,
    Pose,
    Positive,
    Rectangle,
)


def _kind_of_hand(value: Any) -> str:
    return "file" if isinstance(value, str) else "fields"


@described_by(slide.Hand)
class CoreHand(Fields):
    """Names of the robot's parts, and how the finger gives way: docs/reference/options.md."""


class Hand(CoreHand):
    """Description of a hand, with the pitch that suits it."""

    pitch: Annotated[float, Field(gt=0, lt=math.pi / 2)] | None = Field(
        default=None,
        exclude=True,
        description="angle between the sliding finger and the surface, instead of the default of "
        "options.pitch [rad]",
    )


class PointMass(Fields):
    """Part of a mass distribution."""

    position: Point3 = Field(description="position in O [m]")
    mass: NotNegative = Field(description="mass [kg], or any unit shared by all")


class Heights(Fields):
    """Heights of an object on square cells, as a camera saw them: it is no prism."""

    corner: Point2 = Field(description="least x and y of the first cell, in O [m]")
    cell: Positive = Field(description="side of a cell [m]")
    rows: Annotated[list[list[NotNegative]], Field(min_length=1)] = Field(
        description="(nx, ny) heights over the support, the first index along x; 0: nothing [m]"
    )
    undersides: list[list[NotNegative]] | None = Field(
        default=None,
        description="(nx, ny) lowest heights at which the cells were seen [m]; default: they are "
        "known to be solid",
    )

    @model_validator(mode="after")
    def _check(self) -> Heights:
        for name in ("rows", "undersides"):
            lengths = {len(row) for row in getattr(self, name) or []}
            if len(lengths) > 1:
                raise ValueError(f"{name} must be equally long, not of {sorted(lengths)} cells")
        return self


class Object(Fields):
    """Thin object: an outline and a thickness, or points on its top surface."""

    name: str = "object"
    polygon: Points2 | None = Field(default=None, description="outline in O [m]")
    rectangle: Rectangle | None = None
    circle: Circle | None = None
    cloud: str | None = Field(default=None, description="a .ply, .pcd, .xyz or .npy file")
    points: list[Point3] | None = Field(default=None, description="the points themselves, in O [m]")
    scene: str | None = Field(
        default=None,
        description="scene file of `graspless see`, whose object with this name it is; gives the "
        "support too",
    )
    respect: Respect = Field(default="objects", description=RESPECT, exclude=True)
    padding: Padding = Field(default=0.0, description=PADDING, exclude=True)
    frame: Literal["object", "world"] = Field(
        default="object", description="frame of the cloud's file"
    )
    unit: Literal["m", "mm"] = Field(default="m", description="unit of the cloud's file")
    thickness: Positive | None = Field(default=None, description="thickness [m]")
    heights: Heights | None = Field(
        default=None, description="heights of an object that is no prism"
    )
    hollow: bool | None = Field(
        default=None,
        description="the underside may be hollow: the object may rest on its rim alone; default: "
        "of an object of a scene, whose underside no camera saw",
    )
    spacing: Positive | None = Field(
        default=None, description="distance between contact points [m]"
    )
    scale: Positive = Field(default=1.0, description="factor in the plane; thickness and mass stay")
    com: Annotated[list[float], Field(min_length=2, max_length=3)] | None = Field(
        default=None, description="centre of mass in O, after scaling [m]"
    )
    masses: Annotated[list[PointMass], Field(min_length=1)] | None = Field(
        default=None, description="instead of com: a mass distribution, whose sum is the mass"
    )
    mass: Positive | None = Field(default=None, description="mass [kg]")
    pose: PlanarPose | None = None

    @model_validator(mode="after")
    def _check(self) -> Object:
        self.one_of("polygon", "rectangle", "circle", "cloud", "points", "scene")
        self.one_of("com", "masses", needed=False)
        has_points = self.cloud is not None or self.points is not None
        if self.scene is not None:
            self._check_scene()
            return self
        require_scene(self.model_fields_set)
        if not has_points and self.thickness is None:
            raise ValueError("thickness must be given with an outline [m]")
        if self.cloud is not None and self.frame == "world":
            if self.pose is not None:
                raise ValueError("pose must not be given: a cloud in the world says where it is")
        elif self.pose is None:
            raise ValueError("pose must be given: where it lies on the support, {x, y, yaw}")
        if has_points and self.heights is not None:
            raise ValueError("heights are for outlines: the cloud is the top of a thin object")
        if has_points and self.spacing is not None:
            raise ValueError("spacing is for outlines: a cloud's points are the contact points")
        return self

    def _check_scene(self) -> None:
        if self.pose is not None:
            raise ValueError("pose must not be given: the scene says where it is")
        if self.heights is not None:
            raise ValueError("heights must not be given with an object of a scene")
        if "name" not in self.model_fields_set:
            raise ValueError("name must be given: that of the object in the scene")


class Support(Fields):
    """Surface to slide on."""

    polygon: Points2 | None = Field(default=None, description="outline in S, convex or not [m]")
    rectangle: Rectangle | None = None
    circle: Circle | None = None
    scene: str | None = Field(
        default=None, description="scene file; set by an object of a scene, not by hand"
    )
    height: float | None = Field(default=None, description="height of a level top in the world [m]")
    pose: Pose | None = Field(default=None, description="pose of S in the world, z out of the top")
    slab: Positive | None = Field(default=None, description="thickness of the top [m]")
    band_width: Positive | None = Field(
        default=None, description="width of the band P_g along the edges [m]"
    )
    friction: Positive | None = Field(
        default=None, description="coefficient of friction between object and support"
    )

    usable_edges: list[Index] | None = Field(
        default=None,
        description="edges over which the object may stick out, by the corners of the polygon "
        "where they begin, from 0; default: all, or of a scene the real ones",
    )

    @model_validator(mode="after")
    def _check(self) -> Support:
        self.one_of("polygon", "rectangle", "circle", "scene")
        self.one_of("height", "pose", needed=False)
        if self.scene is not None and (self.height is not None or self.pose is not None):
            raise ValueError("height and pose must not be given: the scene says where it is")
        return self


# Former options and their values: plan files name them.
_CONSTANTS = {"height_tolerance": 5e-4, "roll_tolerance": 1e-3, "shortcut": True}


@described_by(slide.Options, _CONSTANTS)
class Options(Fields):
    """Options of the search: docs/reference/options.md."""


class OnSupport(Fields):
    """A task for a hand of two fingers and an object that lies on a support."""

    kind: str
    robot: Robot
    hand: (
        Annotated[
            Annotated[str, Tag("file")] | Annotated[Hand, Tag("fields")],
            Discriminator(_kind_of_hand),
        ]
        | None
    ) = Field(
        default=None,
        description="file of the hand, or fields that replace those of <urdf>.hand.yaml beside the "
        "URDF",
    )
    object: Object
    support: Support
    obstacles: Obstacles = []
    options: Any = None
    budget: Budget = Budget.model_construct()
    files: dict[str, str] = Field(
        default={}, description="sha256 of each mesh that the task reads; only in plan files"
    )
    proposed: str | None = Field(
        default=None,
        description="parts of the robot that were proposed from its URDF; only in plan files",
    )

    @model_validator(mode="before")
    @classmethod
    def _add_support(cls, data: Any) -> Any:
        """An object of a scene brings its support."""
        thing = data.get("object") if isinstance(data, dict) else None
        if not isinstance(thing, dict) or not isinstance(thing.get("scene"), str):
            return data
        support = data.get("support", {})
        if not isinstance(support, dict):
            return data
        return {**data, "support": {**support, "scene": thing["scene"]}}


class SlideTask(OnSupport):
    """A task for the sliding planner."""

    kind: Literal["slide"]
    end: PlanarPose | None = Field(
        default=None,
        description="pose of the object on the support, in S, at which it is left: the finger "
        "lifts off there. By default the hand grasps it over an edge",
    )
    options: Options = Options.model_construct()
