# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rays of cameras around an object, as task files and plan files write them."""

from __future__ import annotations

import base64
import binascii
import zlib
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import Field

from .. import geometry
from .shapes import Fields, Point2, Pose, Size2, pose_matrix
from .statement import pose_fields

if TYPE_CHECKING:
    from ..frames import Matrix
    from .source import Location, Source

LARGEST = 5000  # pixels along a side
Side = Annotated[int, Field(ge=1, le=LARGEST)]


class PinholeCamera(Fields):
    """A camera without distortion or skew."""

    focal: Size2 = Field(description="focal lengths along x and y [pixels]")
    center: Point2 = Field(description="principal point [pixels]")

    @property
    def K(self) -> Matrix:
        """Camera matrix [3, 3] [pixels]."""
        (fx, fy), (cx, cy) = self.focal, self.center
        return np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])


class RayCamera(PinholeCamera):
    """The camera of an image of rays."""

    pose: Pose = Field(description="pose of the optical frame in O")

    def image(self, ends: Matrix, clear: Matrix | None = None) -> geometry.RayImage:
        """Returns the rays of this camera. `ends`, `clear`: see geometry.RayImage."""
        return geometry.RayImage(ends, self.K, pose_matrix(self.pose), clear)


class Rays(RayCamera):
    """Rays of a camera around an object, which show where it is open."""

    size: Annotated[list[Side], Field(min_length=2, max_length=2)] = Field(
        description="number of columns and of rows"
    )
    ends: str = Field(
        description="depth of each ray's end [m]; negative: on the object; infinite: it passes; 0: "
        "unknown. Row by row as 32-bit floats, the lowest byte first, packed by zlib, in base64"
    )


def camera_fields(image: geometry.RayImage) -> dict[str, Any]:
    """Returns the camera of an image of rays as files write it."""
    K = np.asarray(image.K)
    return {
        "pose": {name: [float(x) for x in row] for name, row in pose_fields(image.X_OC).items()},
        "focal": [float(K[0, 0]), float(K[1, 1])],
        "center": [float(K[0, 2]), float(K[1, 2])],
    }


def rays_fields(image: geometry.RayImage) -> dict[str, Any]:
    """Returns the rays of a camera as task files write them."""
    ends = np.ascontiguousarray(image.ends, dtype="<f4")
    return {
        **camera_fields(image),
        "size": [int(ends.shape[1]), int(ends.shape[0])],
        "ends": base64.b64encode(zlib.compress(ends.tobytes(), 6)).decode("ascii"),
    }


def build_rays(fields: Rays, source: Source, place: Location) -> geometry.RayImage:
    """Returns the rays of a camera. Raises TaskError that names the field."""
    columns, rows = fields.size
    count = 4 * columns * rows
    try:
        packed = base64.b64decode(fields.ends.encode("ascii"), validate=True)
        unpacker = zlib.decompressobj()
        found = unpacker.decompress(packed, count + 1)
        if len(found) != count:
            raise ValueError(f"holds {len(found)} bytes or more, not the {count} of its size")
        ends = np.frombuffer(found, dtype="<f4").reshape(rows, columns)
        return fields.image(ends)
    except (ValueError, zlib.error, binascii.Error) as error:
        raise source.error((*place, "ends"), str(error)) from None
