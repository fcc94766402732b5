# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of views: arrays, depth images with a camera file, and clouds with a viewpoint."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import Field

from .._core.perception import View
from ..errors import TaskError, explain, is_of_library, missing
from ..files import absence
from ..tasks.clouds import SUFFIXES, read_array, read_cloud, stated_viewpoint
from ..tasks.rays import RayCamera
from ..tasks.reading import read_yaml
from ..tasks.shapes import Pose, pose_matrix
from .arrays import read_arrays
from .clouds import average, view_of_cloud

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

    from ..tasks.source import Source

IMAGES = (".png", ".tif", ".tiff", ".npy")
MOST = 4_000_000_000  # bytes of the arrays in a file
MOST_PIXELS = 50_000_000  # of an image


class CameraFile(RayCamera):
    """The camera of a depth image without distortion."""

    pose: Pose = Field(
        description="pose of the optical frame in the world: x right, y down, z forward"
    )
    unit: Annotated[float, Field(gt=0, le=0.01)] | None = Field(
        default=None,
        description="distance per count [m], such as 0.001 for millimetres; needed for integers",
    )


def kind_of(path: Path) -> str:
    """Returns the kind of a file: arrays, image or cloud; empty if it is of no such kind.

    An .npy file is a cloud if its last axis has three coordinates.
    """
    suffix = path.suffix.lower()
    if suffix == ".npy":
        try:
            return "cloud" if read_array(path).shape[-1:] == (3,) else "image"
        except Exception as error:  # of a broken file, which `read_view` reports
            if not is_of_library(error):
                raise
            return "image"
    if suffix in IMAGES:
        return "image"
    return "arrays" if suffix == ".npz" else "cloud" if suffix in SUFFIXES else ""


def read_view(path: Path, camera: str | None, viewpoint: list[float] | None) -> View:
    """Reads one view.

    Parameters
    ----------
    path : Path
        An .npz file of arrays, a depth image, or a cloud in the world.
    camera : str or None
        File of the camera of a depth image.
    viewpoint : list of float or None
        Position of the camera that took a cloud, (3,) [m].

    Raises
    ------
    TaskError
        A file is missing or not valid; names file, array or field, and shape.
    """
    kind = kind_of(path)
    if not kind:
        choices = ", ".join(dict.fromkeys((".npz", *IMAGES, *SUFFIXES)))
        raise TaskError(f"{path}: unknown kind of file (one of: {choices})")
    if not path.is_file():
        raise TaskError(f"{path}: {absence(path)}")
    try:
        if kind == "arrays":
            return _view_of_arrays(path)
        if kind == "image":
            return _view_of_image(path, camera)
        return _view_of_points(path, viewpoint)
    except TaskError:
        raise
    except ValueError as error:
        raise TaskError(f"{path}: {error}") from None


def _view_of_points(path: Path, viewpoint: list[float] | None) -> View:
    """Reads a cloud."""
    if viewpoint is None:
        hint = ""
        if (stated := stated_viewpoint(path)) is not None:
            shown = " ".join(f"{value:g}" for value in stated)
            hint = f"; VIEWPOINT in the file is {shown}, if that is in the points' frame"
        raise ValueError(
            "a cloud needs --viewpoint X Y Z, the position of the camera: without it nobody "
            f"knows what the points hide{hint}"
        )
    return view_of_cloud(read_cloud(path), viewpoint)


def _view_of_image(path: Path, camera: str | None) -> View:
    """Reads a depth image and its camera."""
    if camera is None:
        raise ValueError(
            "a depth image needs --camera YAML, a file with the fields focal, center, pose and "
            "unit, see docs/howto/camera.md"
        )
    source: Source = read_yaml(camera)
    fields: CameraFile = source.validate(CameraFile)
    counts = _pixels_of(path)
    if counts.ndim != 2:
        raise ValueError(f"has shape {counts.shape}; a depth image must be (H, W)")
    if counts.size > MOST_PIXELS:
        raise ValueError(f"has {counts.size} pixels; at most {MOST_PIXELS} are read")
    if counts.dtype.kind != "f" and fields.unit is None:
        what = f"missing: {path.name} has integers; should be the distance per count, such as"
        raise source.error(("unit",), f"{what} 0.001 for millimetres")
    depth = counts * (1.0 if fields.unit is None else fields.unit)
    return View(depth, fields.K, pose_matrix(fields.pose))


def _pixels_of(path: Path) -> NDArray[Any]:
    """Returns the values of an image of integers of 16 or 32 bits, or of floats."""
    try:
        if path.suffix.lower() == ".npy":
            return read_array(path)
        from PIL import Image

        with warnings.catch_warnings():
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)  # see MOST_PIXELS
            image = Image.open(path, formats=("PNG", "TIFF"))
        with image:
            if (count := image.width * image.height) > MOST_PIXELS:
                raise ValueError(f"it has {count} pixels; at most {MOST_PIXELS} are read")
            if image.mode != "F" and not image.mode.startswith("I"):
                raise ValueError(
                    f"its pixels are of type {image.mode}; those of a depth image are numbers of "
                    "16 bits or more. A picture of depths for people has lost them"
                )
            return np.asarray(image)
    except ImportError as error:
        raise missing(error, "view", " to read images") from None
    except Exception as error:  # numpy and Pillow raise errors of many types
        if not is_of_library(error):
            raise
        raise ValueError(f"cannot be read as a depth image: {explain(error)}") from None


def _view_of_arrays(path: Path) -> View:
    """Reads depths or frames, K and X_WC."""
    from ..tasks.source import shorten

    try:
        found = read_arrays(path, MOST, wanted=("depth", "frames", "K", "X_WC"))
    except Exception as error:  # numpy and zipfile raise whatever they stumble over
        if not is_of_library(error):
            raise
        raise ValueError(f"cannot be read as arrays: {explain(error)}") from None
    lacking, hint = [name for name in ("K", "X_WC") if name not in found], ""
    if "depth" in found and "frames" in found:
        raise ValueError("has both depth and frames; it must have one of them")
    if "depth" not in found and "frames" not in found:
        lacking.insert(0, "depth (or frames)")
        hint = "; for an organised cloud use perception.view_of_organized, see docs/howto/camera.md"
    if lacking:
        with np.load(path) as arrays:
            has = shorten(", ".join(arrays.files) or "none")
        what = f"array{'s' if len(lacking) > 1 else ''} {', '.join(lacking)}"
        raise ValueError(f"must have the {what}; it has {has}{hint}")
    for name, array in found.items():
        if array.dtype.kind not in "fiu":
            raise ValueError(f"{name} has values of type {array.dtype}, not numbers")
    if "frames" in found and found["frames"].ndim != 3:
        raise ValueError(f"frames has shape {found['frames'].shape}; it must be (N, H, W)")
    depth = found["depth"] if "depth" in found else average(list(found["frames"]))
    return View(depth, found["K"], found["X_WC"])
