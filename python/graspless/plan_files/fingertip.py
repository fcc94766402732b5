# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Table of a plan file of kind fingertip."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Literal

import numpy as np
from pydantic import Field, model_validator

from .. import fingertip
from .._core.fingertip import _rows as core_rows
from ..tasks.fingertip.model import FingertipTask
from ..tasks.options import described_by
from ..tasks.shapes import CountOrZero, IndexOrNone, Point3
from .table import Counters, PlanFields, PoseRow, Table, require_rows, require_unit_quaternions

if TYPE_CHECKING:
    Status = str
else:
    Status = Literal[tuple(fingertip.Status.__members__)]


_MARGINS = (
    "stability", "compliant_stability", "nominal_margin", "withstands", "place_tolerance",
)  # fmt: skip


def _segment(**columns: Any) -> fingertip.Segment:
    """Returns a segment from its columns: of each row, and in it of each finger."""
    given = columns["fingers"]
    numbers = np.zeros((len(given), len(given[0]) if given else 0, 12))
    if numbers.size:
        numbers[..., 0] = [[p is not None for p in row] for row in given]
        numbers[..., 1:4] = [[p or (0, 0, 0) for p in row] for row in given]
        numbers[..., 4:7] = [[n or (0, 0, 1) for n in row] for row in columns["normals"]]
        numbers[..., 7] = np.array(columns["modes"]) == "force"
        numbers[..., 8] = columns["commanded_forces"]
        numbers[..., 9:] = columns["nominal_forces"]
    margins = np.transpose([columns[name] for name in _MARGINS])
    rows = core_rows(columns["object_poses"], margins, numbers)
    return fingertip.Segment(columns["name"], columns["X_WO"], rows, columns["finger"])


class Segment(Table):
    """Part of a plan without a change of fingers, or one regrasp: N rows, n fingers."""

    MAKE: ClassVar = _segment

    name: str = Field(description="slide, turn, tumble or regrasp")
    finger: IndexOrNone = Field(description="index of the finger that regrasps, else -1")
    X_WO: list[PoseRow] = Field(
        description="(K, 7) poses of the lattice, x y z qw qx qy qz in the world"
    )
    object_poses: list[PoseRow] = Field(description="(N, 7) pose of each row")
    fingers: list[list[Point3 | None]] = Field(
        description="(N, n, 3) contact points in the object frame [m]; null: off the object"
    )
    normals: list[list[Point3 | None]] = Field(
        description="(N, n, 3) unit normals into the object, in the object frame"
    )
    modes: list[list[Literal["position", "force"]]] = Field(description="(N, n) control modes")
    commanded_forces: list[list[float]] = Field(
        description="(N, n) normal force in force control, else 0 [N]"
    )
    nominal_forces: list[list[Point3]] = Field(
        description="(N, n, 3) forces on the object, in the object frame, for feed-forward [N]"
    )
    stability: list[float] = Field(description="(N,) stability z [N]")
    compliant_stability: list[float] = Field(
        description="(N,) stability with contacts as springs [N]"
    )
    nominal_margin: list[float] = Field(description="(N,) margin of the nominal forces [N]")
    withstands: list[float] = Field(
        description="(N,) largest disturbance that each row withstands, fingers in their places [N]"
    )
    place_tolerance: list[float] = Field(
        description="(N,) error of every finger's place that each row tolerates [m]"
    )

    def check(self, where: str, fingers: int) -> None:
        """Raises unless there is one of everything a row, and one a finger in each."""
        rows = len(self.object_poses)
        of_rows = (
            "fingers", "normals", "modes", "commanded_forces", "nominal_forces", *_MARGINS,
        )  # fmt: skip
        for field in of_rows:
            values = getattr(self, field)
            if len(values) != rows:
                what = f"{len(values)} {field} and {rows} object_poses: one per row is needed"
                raise ValueError(f"{where} has {what}")
            for i, row in enumerate(values):
                if isinstance(row, list) and len(row) != fingers:
                    what = f"{len(row)} {field} for {fingers} fingers"
                    raise ValueError(f"row {i} of {where} has {what}")
        for i, (points, normals) in enumerate(zip(self.fingers, self.normals, strict=True)):
            if [p is None for p in points] != [n is None for n in normals]:
                raise ValueError(
                    f"row {i} of {where}: a finger must have both a point and a normal, or neither"
                )
        if not -1 <= self.finger < fingers:
            raise ValueError(f"{where} moves finger {self.finger} of {fingers}")
        require_unit_quaternions([*self.X_WO, *self.object_poses])


class JointSegment(Table):
    """Part of a joint motion."""

    MAKE: ClassVar = fingertip.JointSegment
    ATTRIBUTES: ClassVar = {"object_poses": "X_WO"}

    name: str = Field(description="approach, touch, slide, turn, tumble, release, reach or retreat")
    plan_segment: IndexOrNone = Field(
        description="index in `segments` of the segment that it carries out, or -1"
    )
    scrub: float = Field(
        description="largest distance by which a turning fingertip slips on its contact [m]"
    )
    positions: list[list[float]] = Field(description="(N, dof) joint positions, rad or m")
    object_poses: list[PoseRow] = Field(
        description="(N, 7) poses of the object, x y z qw qx qy qz in the world"
    )


class Realization(Table):
    """Joint paths that carry the fingertips, or the reason why there are none."""

    MAKE: ClassVar = fingertip.Realization

    found: bool
    reason: str = Field(description="segment, row and finger that fail, and the reason")
    joint_names: list[str]
    finger_of_fingertip: list[IndexOrNone] = Field(
        description="index of the plan's finger for each fingertip of the task's carrier"
    )
    segments: list[JointSegment]

    def check(self) -> None:
        """Raises unless there is one value a joint in each row, and one pose a row."""
        dof = len(self.joint_names)
        for segment in self.segments:
            where = f"'{segment.name}'"
            require_rows(where, segment.positions, segment.object_poses, dof)


class Relaxation(Table):
    """Smallest change of one field that makes a plan possible."""

    MAKE: ClassVar = fingertip.Relaxation

    field: str
    value: float


class Weakest(Table):
    """Row of least stability."""

    MAKE: ClassVar = fingertip.Weakest

    segment: IndexOrNone
    row: IndexOrNone


@described_by(fingertip.Statistics)
class FingertipStatistics(Counters):
    """Counters of the search."""


class FingertipPlanFile(PlanFields):
    """A plan with its whole task."""

    kind: Literal["fingertip"]
    status: Status
    stats: FingertipStatistics
    cost: float | None = Field(
        default=None, description="cost by Eqs. (9) and (10) [m]; null unless solved"
    )
    lower_bound: float | None = Field(
        default=None, description="lower bound on the cost of every plan on this lattice [m]"
    )
    regrasps: CountOrZero
    withstands: float | None = Field(
        default=None,
        description="largest disturbance that every row withstands, fingers in their places [N]; "
        "null unless solved",
    )
    place_tolerance: float | None = Field(
        default=None,
        description="error of every finger's place that every row tolerates [m]; null "
        "unless solved",
    )
    weakest: Weakest | None = Field(default=None, description="row of least stability")
    warnings: list[str]
    limit: str = Field(description="limiting condition if not solved, else empty")
    relaxations: list[Relaxation] = Field(
        description="single changes that would help if not solved"
    )
    segments: list[Segment]
    realization: Realization | None = Field(
        default=None, description="joint paths, if the task has a robot"
    )
    task: FingertipTask = Field(
        description="fields of the task file, with the content of all files that it names"
    )

    @model_validator(mode="after")
    def _check(self) -> FingertipPlanFile:
        for k, segment in enumerate(self.segments):
            segment.check(f"segment {k} '{segment.name}'", self.task.fingers.count)
        if self.weakest is not None:
            rows = [len(segment.object_poses) for segment in self.segments]
            place = self.weakest
            if not (0 <= place.segment < len(rows) and 0 <= place.row < rows[place.segment]):
                raise ValueError(f"weakest: there is no row {place.row} of {place.segment}")
        if self.realization is not None:
            self.realization.check()
        return self


File = FingertipPlanFile
