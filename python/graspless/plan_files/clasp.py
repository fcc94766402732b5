# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table of a plan file of kind clasp."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic import Field, model_validator

from .. import clasp, geometry
from ..tasks.clasp.model import ClaspTask
from ..tasks.options import described_by
from ..tasks.shapes import Index, NotNegative, Point3
from .table import Counters, MotionRows, PlanFields, PoseRow, Table

if TYPE_CHECKING:
    Status = str
else:
    Status = Literal[tuple(clasp.Status.__members__)]


class Segment(MotionRows):
    """Part of a motion."""

    MAKE: ClassVar = clasp.Segment

    name: str = Field(description="reach or close")
    object_poses: list[PoseRow] = Field(
        description="(N, 7) pose of the object, x y z qw qx qy qz in the world, equal in all rows"
    )
    virtual_linking: list[list[float]] = Field(
        description="(N, curves) virtual linking of every finger curve with the clasped loop"
    )


class Target(Table):
    """Target on the loop that is clasped."""

    MAKE: ClassVar = geometry.ClaspTarget

    point: Point3 = Field(description="point in the object frame [m]")
    tangent: Point3 = Field(description="unit tangent of the loop, in the object frame")


class Stability(Table):
    """Result of the stability test at the last row."""

    MAKE: ClassVar = clasp.Stability

    secure: bool
    escapes: Index = Field(description="number of sequences of moves in which the loop escaped")
    margin: float = Field(description="1: the loop cannot move; 0 or less: it escaped")
    withstands: NotNegative = Field(
        default=0.0,
        description="largest sudden force in any direction, with moments in proportion as in the "
        "options, before a joint gives way [N]; 1e6 if none does, 0 if that was not tested",
    )
    opens_first: str = Field(default="", description="the joint that gives way first, if any")
    checks: Index = Field(description="number of poses checked")


class Pinch(Table):
    """Result of the test of a pinch at the last row: forces that friction resists."""

    MAKE: ClassVar = clasp.Pinch

    holds: bool
    strength: NotNegative = Field(
        description="largest force that is resisted in any direction, per newton of a finger"
    )
    press: NotNegative = Field(
        default=0.0,
        description="normal force of each finger at half the effort limits of the joints [N]",
    )
    load: NotNegative = Field(
        default=0.0, description="largest multiple of the load that friction resists at that force"
    )
    gap: float = Field(description="of the finger that is farther from the object [m]")


class Certificate(Table):
    """Bounds on the opening through which the loop can leave the hand at the last row."""

    MAKE: ClassVar = clasp.Certificate

    caged: bool = Field(description="no motion takes the loop out of the hand: upper is below 0")
    lower: float = Field(description="clearance on a way out that was found [m]")
    upper: float = Field(
        description="proven bound on the clearance on any way out [m]; 1e6 if no ring of the hand "
        "is linked with the loop"
    )
    thickness: NotNegative = Field(
        description="diameter of a ball that fits into the object all along the loop [m]"
    )
    gap: float = Field(description="widest gap in the ring of the hand [m]")
    between: Annotated[list[str], Field(min_length=2, max_length=2)] = Field(
        description="links on both sides of the gap; empty names without a ring"
    )
    moves: Index = Field(description="number of moves that were tried")


class Tree(Table):
    """Search tree that contains the clasp."""

    MAKE: ClassVar = clasp.Tree
    ATTRIBUTES: ClassVar = {"points": "p_W"}

    points: list[Point3] = Field(description="(N, 3) centres of the hand's curves in the world [m]")
    parents: list[Index] = Field(description="(N,) index of a node's parent; its own for the root")
    path: list[Index] = Field(description="nodes from the root to the clasp")

    @model_validator(mode="after")
    def _check(self) -> Tree:
        if len(self.parents) != len(self.points):
            counts = f"{len(self.points)} points and {len(self.parents)} parents"
            raise ValueError(f"the tree has {counts}: one per node is needed")
        if any(node >= len(self.points) for node in [*self.parents, *self.path]):
            raise ValueError(f"the tree names a node beyond its {len(self.points)}")
        return self


@described_by(clasp.Statistics)
class ClaspStatistics(Counters):
    """Counters of the search."""


class ClaspPlanFile(PlanFields):
    """A plan with its whole task."""

    kind: Literal["clasp"]
    status: Status
    stats: ClaspStatistics
    joint_names: list[str]
    loop: Index | None = Field(
        default=None, description="index of the clasped loop; 0 is the shortest"
    )
    fingers: list[str] = Field(
        default_factory=list,
        description="names of the fingers that clasp the loop together with the thumb, one per "
        "curve of virtual_linking; none: all of the hand",
    )
    pre_shape: str = Field(
        default="", description="pre-shape with which the search began; empty: the hand's first"
    )
    target: Target | None = Field(default=None, description="place on the clasped loop")
    min_linking: NotNegative = Field(description="threshold of virtual linking")
    stability: Stability | None = Field(default=None, description="result at the last row")
    pinch: Pinch | None = Field(
        default=None,
        description="result at the last row, if only friction between two fingers holds",
    )
    certificate: Certificate | None = Field(
        default=None, description="bounds for the last row; missing if no time was left"
    )
    segments: list[Segment]
    tree: Tree
    warnings: list[str]
    task: ClaspTask = Field(
        description="fields of the task file, with the content of all files that it names"
    )

    @model_validator(mode="after")
    def _check(self) -> ClaspPlanFile:
        curves = {len(row) for segment in self.segments for row in segment.virtual_linking}
        if len(curves) > 1:
            raise ValueError(f"virtual_linking has rows of {sorted(curves)} curves")
        if self.fingers and curves - {len(self.fingers)}:
            counts = f"{curves.pop()} curves, and there are {len(self.fingers)} fingers"
            raise ValueError(f"virtual_linking has {counts}")
        for segment in self.segments:
            segment.check(len(self.joint_names))
            if len(segment.virtual_linking) != len(segment.positions):
                counts = f"{len(segment.virtual_linking)} virtual_linking"
                raise ValueError(f"segment '{segment.name}' has {counts}: one per row is needed")
        found = (self.loop, self.target, self.stability)
        if self.status == "solved" and None in found:
            raise ValueError("a solved plan must have loop, target and stability")
        return self


File = ClaspPlanFile
