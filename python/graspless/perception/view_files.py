# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of views: arrays, depth images with a camera file, and clouds with a viewpoint."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import Field

from .._core.perception import View
from ..errors import TaskError, explain, is_of_library, missing, told
from ..files import absence
from ..tasks.clouds import (
    MOST_BYTES,
    SUFFIXES,
    array_shape,
    read_array,
    read_cloud,
    stated_viewpoint,
)
from ..tasks.rays import PinholeCamera
from ..tasks.reading import read_yaml
from ..tasks.shapes import Pose, pose_matrix
from .arrays import read_arrays
from .clouds import average, view_of_cloud

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import NDArray

    from ..tasks.source import Source

IMAGES = (".png", ".tif", ".tiff", ".npy")
MOST_PIXELS = 50_000_000  # of an image


class CameraFile(PinholeCamera):
    """The camera of a depth image without distortion."""

    pose: Pose = Field(
        description="pose of the optical frame in the world: x right, y down, z forward"
    )
    unit: Annotated[float, Field(gt=0, le=1)] | None = Field(
        default=None,
        description="distance per count [m], such as 0.001 for millimetres; needed for integers",
    )


def kind_of(path: Path) -> str:
    """Returns the kind of a file: arrays, image or cloud.

    An .npy file is a cloud if its last axis has three coordinates. Raises TaskError if the file is
    missing, is of no such kind, or is an .npy file that is not valid.
    """
    suffix = path.suffix.lower()
    if suffix not in (".npz", *IMAGES, *SUFFIXES):
        choices = ", ".join(dict.fromkeys((".npz", *IMAGES, *SUFFIXES)))
        raise TaskError(f"{path}: unknown kind of file (one of: {choices})")
    if not path.is_file():
        raise TaskError(f"{path}: {absence(path)}")
    if suffix == ".npy":
        with told(str(path)):
            return "cloud" if array_shape(path)[-1:] == (3,) else "image"
    return "arrays" if suffix == ".npz" else "image" if suffix in IMAGES else "cloud"


def read_view(path: Path, kind: str, camera: str | None, viewpoint: list[float] | None) -> View:
    """Reads one view.

    Parameters
    ----------
    path : Path
        An .npz file of arrays, a depth image, or a cloud in the world.
    kind : str
        Its `kind_of`.
    camera : str or None
        File of the camera of a depth image.
    viewpoint : list of float or None
        Position of the camera that took a cloud, (3,) [m].

    Raises
    ------
    TaskError
        A file is missing or not valid; names file, array or field, and shape.
    """
    with told(str(path)):
        if kind == "arrays":
            return _view_of_arrays(path)
        if kind == "image":
            return _view_of_image(path, camera)
        return _view_of_points(path, viewpoint)


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
    if counts.dtype.kind != "f" and fields.unit is None:
        what = f"missing: {path.name} has integers; should be the distance per count, such as"
        raise source.error(("unit",), f"{what} 0.001 for millimetres")
    depth = counts * (1.0 if fields.unit is None else fields.unit)
    return View(depth, fields.K, pose_matrix(fields.pose))


def _pixels_of(path: Path) -> NDArray[Any]:
    """Returns the values [H, W] of an image: integers of 16 bits or more, or floats."""
    if path.suffix.lower() == ".npy":
        shape = array_shape(path)
        if len(shape) != 2:
            raise ValueError(f"has shape {shape}; a depth image must be (H, W)")
        _require_few(shape[0] * shape[1])
        counts = read_array(path)
    else:
        counts = _image_of(path)
    if counts.dtype.itemsize < 2:
        raise ValueError("has 8 bits per pixel; pictures of depths are for viewing only")
    return counts


def _image_of(path: Path) -> NDArray[Any]:
    """Returns the values of a .png or .tiff file."""
    try:
        from PIL import Image
    except ImportError as error:
        raise missing(error, "view", " to read images") from None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Pillow's, about sizes and trailing bytes
            image = Image.open(path, formats=("PNG", "TIFF"))
            with image:
                _require_few(image.width * image.height)
                if (pages := getattr(image, "n_frames", 1)) > 1:
                    raise ValueError(f"has {pages} pages; a depth image has one")
                is_old = image.mode == "I" and image.format == "PNG"  # 16 bits, by older Pillows
                if image.mode == "F" or image.mode.startswith("I;16") or is_old:
                    return np.array(image)
                raise ValueError(
                    f"has pixels of type {image.mode}; those of a depth image are integers of 16 "
                    "bits or floating-point numbers. Pictures of depths are for viewing only"
                )
    except Image.DecompressionBombError:
        raise ValueError(f"has too many pixels; at most {MOST_PIXELS} are read") from None
    except ValueError:
        raise
    except Exception as error:  # Pillow raises errors of many types
        if not is_of_library(error):
            raise
        raise ValueError("is damaged, or no image of type PNG or TIFF") from None


def _require_few(pixels: int) -> None:
    if pixels > MOST_PIXELS:
        raise ValueError(f"has {pixels} pixels; at most {MOST_PIXELS} are read")


def _view_of_arrays(path: Path) -> View:
    """Reads depths or frames, K and X_WC."""
    from ..tasks.source import shorten

    try:
        found = read_arrays(path, MOST_BYTES, wanted=("depth", "frames", "K", "X_WC"))
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
