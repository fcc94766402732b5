# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The field `place` of a pick, as callers and task files write it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from pydantic import Field, model_validator

from ..errors import TaskError, told
from ..tasks.documents import in_plain_types
from ..tasks.shapes import Fields, Points2, Rectangle
from ..tasks.source import Source
from ..tasks.units import warn_of_units

if TYPE_CHECKING:
    from ..frames import Matrix


class PlacePose(Fields):
    """Where the object shall stand, seen from above, in the world."""

    x: float = Field(description="x of the middle of its outline [m]")
    y: float = Field(description="y [m]")
    yaw: float | None = Field(
        default=None, description="yaw of its longest extent [rad]; any of eight by default"
    )


class Region(Fields):
    """Part of a support, seen from above, in the world."""

    rectangle: Rectangle | None = None
    polygon: Points2 | None = Field(default=None, description="instead: corners [m]")

    @model_validator(mode="after")
    def _check(self) -> Region:
        self.one_of("rectangle", "polygon")
        return self

    def corners(self) -> Matrix:
        """[N, 2] in the world [m]."""
        if self.polygon is not None:
            return np.array(self.polygon)
        assert self.rectangle is not None
        half = np.array(self.rectangle.size) / 2
        signs = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
        corners: Matrix = np.array(self.rectangle.center) + signs * half
        return corners


class Place(Fields):
    """Where the object is put down."""

    on: str | None = Field(
        default=None, description="support in the scene; by default the one that it stands on"
    )
    pose: PlacePose | None = Field(default=None, description="place of the object")
    region: Region | None = Field(default=None, description="instead: part of the support")

    @model_validator(mode="after")
    def _check(self) -> Place:
        self.one_of("pose", "region", needed=self.on is None)
        return self


def place_of(given: Any) -> Place:
    """Returns a place from what a caller gave. Raises TaskError that names field and value."""
    if isinstance(given, Place):  # of a task file
        return given
    if not isinstance(given, Mapping):
        raise TaskError(f"place: {given!r}: should have one of the fields pose, region and on")
    with told("place"):
        source = Source("place", in_plain_types(given))
        fields: Place = source.validate(Place)
        warn_of_units(fields, source)
    return fields
