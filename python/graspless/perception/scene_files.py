# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scene files: YAML for people, with the points of the objects in an .npz file beside it."""

from __future__ import annotations

import contextlib
import hashlib
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from pydantic import Field, model_validator

from .. import files
from .._core.perception import EdgeLabel, Object, Scene, Status, Support, Unseen
from ..errors import TaskError, explain, is_of_library
from ..tasks.meshes import checksum
from ..tasks.rays import RayCamera, camera_fields
from ..tasks.reading import read_yaml
from ..tasks.shapes import (
    Fields,
    NotNegative,
    Point3,
    Points2,
    Pose,
    Positive,
    pose_matrix,
)
from ..tasks.source import Source
from ..tasks.statement import pose_fields
from .arrays import keep_other, packed, read_arrays

if TYPE_CHECKING:
    from ..frames import Matrix

Label = Literal["real", "image_border", "occluded"]
MOST = 400_000_000  # bytes of the points in a file
CLEAR = "clear"  # in names of arrays


class SupportFields(Fields):
    """A support, with what is beyond each edge."""

    name: str
    pose: Pose = Field(description="pose of S in the world, z out of the plane")
    polygon: Points2 = Field(description="corners in S, counter-clockwise [m]")
    edges: list[Label] = Field(description="label of the edge from each corner to the next")
    height_error: NotNegative = Field(description="standard error of the height [m]")
    angle_error: NotNegative = Field(description="standard error of the tilt [rad]")
    noise: NotNegative = Field(description="standard deviation of the depth [m]")
    least_thickness: NotNegative = Field(
        description="least thickness of an object that would have been seen [m]"
    )

    @model_validator(mode="after")
    def _check(self) -> SupportFields:
        if len(self.edges) != len(self.polygon):
            raise ValueError(
                f"edges has {len(self.edges)} labels, the polygon {len(self.polygon)} corners"
            )
        return self


class ObjectFields(Fields):
    """An object on a support."""

    name: str
    support: str = Field(description="name of the support")
    pose: Pose = Field(description="pose of O in the world: its origin is on the support")
    outline: Points2 = Field(description="corners in O, counter-clockwise [m]")
    thickness: Positive = Field(description="height of the top above the support [m]")
    thickness_error: NotNegative = Field(description="standard error of the thickness [m]")
    is_flat: bool = Field(description="true if all of the top is equally high")
    position_error: NotNegative = Field(description="standard error along the support [m]")
    yaw_error: NotNegative = Field(description="standard error of the direction of x [rad]")
    touches_border: bool = Field(description="true if the image cuts the object off")
    rays: list[RayCamera] = Field(
        default=[],
        description="rays of each camera; the array 'object_0 rays 0' of the .npz file has the "
        "depths of their ends, and 'object_0 clear 0' how far rays of unknown end met nothing",
    )
    warnings: list[str] = []


class UnseenFields(Fields):
    """Space that no ray reached: a convex hull."""

    behind: str = Field(description="object that hides it; empty: a patch without depth")
    vertices: Annotated[list[Point3], Field(min_length=4)] = Field(
        description="corners in the world [m]"
    )


class SceneFields(Fields):
    """A scene file."""

    kind: Literal["scene"]
    status: Literal["found", "no_depth", "not_metres", "no_support", "camera_below"]
    reason: str
    stamp: float | None = Field(
        default=None, description="when the images were taken [s since 1970]"
    )
    warnings: list[str] = []
    supports: list[SupportFields] = []
    objects: list[ObjectFields] = []
    unseen: list[UnseenFields] = []
    points: str | None = Field(
        default=None, description=".npz file beside this one: the points of each object in O [m]"
    )
    points_sha256: str | None = Field(
        default=None, description="sha256 of that file; files of older versions have none"
    )

    @model_validator(mode="after")
    def _check(self) -> SceneFields:
        known = {support.name for support in self.supports}
        for thing in self.objects:
            if thing.support not in known:
                names = ", ".join(sorted(known)) or "none"
                raise ValueError(
                    f"{thing.name} lies on {thing.support}, which is no support (one of: {names})"
                )
        if self.objects and self.points is None:
            raise ValueError("points must be given: the .npz file with the objects' points")
        return self


def save_scene(scene: Scene, path: str | Path) -> Path | None:
    """Writes a scene file, and the points of its objects to an .npz file beside it.

    Parameters
    ----------
    scene : Scene
    path : str or Path
        .yaml file to write. The other file has the same name with the ending .npz.

    Returns
    -------
    Path or None
        An .npz file of other origin that had this name, kept under its name with ``~``.

    Raises
    ------
    TaskError
        A file cannot be written.
    """
    import yaml

    path = Path(path)
    document: dict[str, Any] = {
        "kind": "scene",
        "status": scene.status.name,
        "reason": scene.reason,
        **({} if scene.stamp is None else {"stamp": scene.stamp}),
        "warnings": list(scene.warnings),
        "supports": [_support(support) for support in scene.supports],
        "objects": [_object(thing) for thing in scene.objects],
        "unseen": [
            {"behind": space.behind, "vertices": _rounded(space.vertices)} for space in scene.unseen
        ],
    }
    kept = None
    if scene.objects:
        clouds: dict[str, Any] = {
            thing.name: thing.points.astype(np.float32) for thing in scene.objects
        }
        for thing in scene.objects:
            for i, image in enumerate(thing.rays):
                clouds[_name_of(thing.name, i)] = image.ends
                clouds[_name_of(thing.name, i, CLEAR)] = image.clear
        content, arrays = packed(clouds), path.with_suffix(".npz")
        kept = keep_other(arrays, content, path)
        files.write(arrays, content)
        document |= {"points": arrays.name, "points_sha256": hashlib.sha256(content).hexdigest()}
    files.write(path, yaml.safe_dump(document, sort_keys=False, default_flow_style=None, width=110))
    return kept


def load_scene(path: str | Path) -> Scene:
    """Reads a scene file.

    Parameters
    ----------
    path : str or Path
        .yaml file, as `save_scene` wrote it.

    Returns
    -------
    Scene
        Supports, objects and unseen space.

    Raises
    ------
    TaskError
        A file is missing or not valid; names file, line, field and value.
    """
    path = Path(path)
    with contextlib.suppress(OSError):  # of a name that is too long
        if not path.is_file():
            raise TaskError(f"{path}: {files.absence(path)}")
    source = read_yaml(path)
    fields: SceneFields = source.validate(SceneFields)
    clouds = _clouds(fields, source, path.parent)
    try:
        return Scene(
            status=Status.__members__[fields.status],
            reason=fields.reason,
            supports=[_built_support(support) for support in fields.supports],
            objects=[_built_object(thing, clouds) for thing in fields.objects],
            unseen=[
                Unseen(behind=space.behind, vertices=np.array(space.vertices))
                for space in fields.unseen
            ],
            warnings=fields.warnings,
            stamp=fields.stamp,
        )
    except ValueError as error:
        raise TaskError(f"{path}: {error}") from None


def _support(support: Support) -> dict[str, Any]:
    return {
        "name": support.name,
        "pose": pose_fields(support.X_WS),
        "polygon": _rounded(support.polygon),
        "edges": [label.name for label in support.edges],
        **_figures(support, "height_error", "angle_error", "noise", "least_thickness"),
    }


def _object(thing: Object) -> dict[str, Any]:
    return {
        "name": thing.name,
        "support": thing.support,
        "pose": pose_fields(thing.X_WO),
        "outline": _rounded(thing.outline),
        **_figures(thing, "thickness", "thickness_error"),
        "is_flat": thing.is_flat,
        **_figures(thing, "position_error", "yaw_error"),
        "touches_border": thing.touches_border,
        "rays": [camera_fields(image) for image in thing.rays],
        "warnings": list(thing.warnings),
    }


def _name_of(thing: str, index: int, what: str = "rays") -> str:
    """Returns the name of an array of a camera's rays."""
    return f"{thing} {what} {index}"


def _figures(owner: Support | Object, *names: str) -> dict[str, float]:
    return {name: float(f"{getattr(owner, name):.4g}") for name in names}


def _rounded(points: Matrix) -> list[list[float]]:
    """Returns coordinates in steps of 10 micrometres, far below what a camera resolves."""
    return [[round(float(value), 5) for value in row] for row in points]


def _built_support(fields: SupportFields) -> Support:
    values = fields.model_dump(exclude={"pose", "polygon", "edges"})
    return Support(
        polygon=np.array(fields.polygon),
        edges=[EdgeLabel.__members__[label] for label in fields.edges],
        X_WS=pose_matrix(fields.pose),
        **values,
    )


def _built_object(fields: ObjectFields, arrays: dict[str, Matrix]) -> Object:
    values = fields.model_dump(exclude={"pose", "outline", "rays"})
    return Object(
        outline=np.array(fields.outline),
        X_WO=pose_matrix(fields.pose),
        points=arrays[fields.name],
        rays=[
            camera.image(
                arrays[_name_of(fields.name, i)], arrays.get(_name_of(fields.name, i, CLEAR))
            )
            for i, camera in enumerate(fields.rays)
        ],
        **values,
    )


def _clouds(fields: SceneFields, source: Source, directory: Path) -> dict[str, Matrix]:
    """Reads the points and rays of all objects."""
    if fields.points is None:
        return {}
    path = directory / fields.points
    if not path.is_file():
        raise source.error(("points",), files.absence(path))
    try:
        clouds = {name: np.asarray(rows, float) for name, rows in read_arrays(path, MOST).items()}
    except Exception as error:  # numpy and zipfile raise whatever they stumble over
        if not is_of_library(error):
            raise
        raise source.error(("points",), f"cannot be read: {explain(error)}") from None
    for thing in fields.objects:
        for name in (thing.name, *(_name_of(thing.name, i) for i in range(len(thing.rays)))):
            if name not in clouds:
                raise source.error(("points",), f"has no array '{name}'")
    if fields.points_sha256 is not None and checksum(path) != fields.points_sha256:
        what = "is not the file that belongs to this scene: its points_sha256 differs"
        raise source.error(("points",), what)
    return clouds
