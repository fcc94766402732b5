# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading point clouds."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import is_of_library, warn
from ..files import absence

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ..frames import Matrix

SUFFIXES = (".ply", ".pcd", ".xyz", ".npy")
MOST_BYTES = 4_000_000_000  # of arrays in files
LZF_RATIO = 100  # of bytes unpacked to packed, at most: three bytes make 264


def read_cloud(path: str | Path) -> Matrix:
    """Returns the points of a PLY, PCD, XYZ or NPY file; of a PLY with faces, its vertices.

    Points that are not finite are left out, with a warning: depth cameras write NaN for pixels
    without a measurement.

    Parameters
    ----------
    path : str or Path
        .ply (ascii, binary), .pcd (ascii, binary, binary_compressed), .xyz, or .npy of an array
        (N, 3) or (H, W, 3).

    Returns
    -------
    array [N, 3]
        In the file's frame and unit.

    Raises
    ------
    ValueError
        The file is missing or unreadable, holds more or fewer points than it states, or has no
        finite point.
    """
    path = Path(path)
    if path.suffix.lower() not in SUFFIXES:
        raise ValueError(f"unknown kind of point cloud (one of: {', '.join(SUFFIXES)})")
    if not path.is_file():
        raise ValueError(absence(path))
    readers = {".pcd": _read_pcd, ".ply": _read_ply, ".xyz": _read_xyz, ".npy": _read_npy}
    try:
        points = readers[path.suffix.lower()](path)
    except Exception as error:  # readers of broken files raise whatever they stumble over
        if not is_of_library(error):
            raise
        first = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise ValueError(f"cannot be read as a point cloud: {first}") from None
    if not len(points):
        raise ValueError("is empty: has no points")
    is_finite = np.isfinite(points).all(axis=1)
    if broken := int(np.count_nonzero(~is_finite)):
        what = f"{broken} of {len(points)} points are not finite (NaN or Inf)"
        if broken == len(points):
            raise ValueError(what)
        warn(f"{path}: {what} and are left out")
    return np.asarray(points[is_finite])


def array_shape(path: Path) -> tuple[int, ...]:
    """Returns the shape of the array of numbers in an .npy file, from its header.

    Raises
    ------
    ValueError
        The file is not valid, states more values than it has or than are read, or holds no numbers.
    """
    with path.open("rb") as file:
        if file.read(2) == b"PK":
            raise ValueError("is an .npz archive; rename it")
        file.seek(0)
        try:
            version = np.lib.format.read_magic(file)
            header = np.lib.format.read_array_header_1_0
            if version != (1, 0):
                header = np.lib.format.read_array_header_2_0
            shape, _, kind = header(file)
        except Exception as error:  # numpy raises errors of many types
            if not is_of_library(error):
                raise
            raise ValueError("its header is not that of an .npy file") from None
        rest = path.stat().st_size - file.tell()
    if kind.kind not in "fiu":
        raise ValueError(f"holds values of type {kind}, not numbers")
    count = math.prod(shape)
    if count * kind.itemsize > rest:
        raise ValueError(f"its header states {count} numbers, but {rest} bytes follow")
    if 8 * count > MOST_BYTES:
        raise ValueError(f"holds {count} numbers; at most {MOST_BYTES // 8} are read")
    return tuple(shape)


def read_array(path: Path) -> NDArray[Any]:
    """Returns the array of numbers in an .npy file. Raises as `array_shape`."""
    array_shape(path)
    array: NDArray[Any] = np.load(path, allow_pickle=False)
    return array


def stated_viewpoint(path: Path) -> list[float] | None:
    """Returns the position in the VIEWPOINT of a PCD file; None if it has none, or the default."""
    if path.suffix.lower() != ".pcd":
        return None
    try:
        viewpoint = [float(value) for value in _pcd_header(path)[0].viewpoint]
    except Exception as error:  # of a broken file, which `read_cloud` reports
        if not is_of_library(error):
            raise
        return None
    return None if viewpoint == [0, 0, 0, 1, 0, 0, 0] else viewpoint[:3]


def _read_ply(path: Path) -> Matrix:
    import trimesh

    counts, is_ascii, body = _ply_header(path)
    stated = " and ".join(f"{count} {name}" for name, count in counts.items())
    rows = sum(counts.values())
    if is_ascii and (found := len(body.decode().rstrip().splitlines())) != rows:
        raise ValueError(f"its header states {rows} rows ({stated}), but {found} follow")
    try:
        loaded: Any = trimesh.load(path, process=False)
    except ValueError as error:
        if "unexpected length" not in str(error):
            raise
        what = f"the {len(body)} bytes after its header are not those of"
        raise ValueError(f"{what} {rows} rows ({stated}), as it states") from None
    parts = loaded.geometry.values() if isinstance(loaded, trimesh.Scene) else [loaded]
    points = [np.asarray(part.vertices, dtype=float) for part in parts]
    return np.concatenate(points) if points else np.empty((0, 3))


def _ply_header(path: Path) -> tuple[dict[str, int], bool, bytes]:
    """Returns the rows of each element that a PLY states, if it is ASCII, and what follows."""
    counts: dict[str, int] = {}
    is_ascii = False
    with path.open("rb") as file:
        for line in file:
            words = line.decode().split()
            if "end_header" in words:
                return counts, is_ascii, file.read()
            is_ascii = is_ascii or words[:2] == ["format", "ascii"]
            if words[:1] == ["element"]:
                name, count = words[1:]
                counts[name] = int(count)
    raise ValueError("its header has no end_header")


def _read_xyz(path: Path) -> Matrix:
    """Three numbers a line, separated by spaces or by commas.

    Further columns (colours, normals) and # comments are skipped.
    """
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(), 1):
        text = line.split("#")[0].strip()
        words = text.split()
        if "," in text:
            if len(words) > 1 and any("," in word.strip(",") for word in words):
                what = "separates numbers by spaces and by commas; decimals have a point"
                raise ValueError(f"line {number} {what}: {line[:40]}")
            words = re.split(r"\s*,\s*|\s+", text)
        if not words:
            continue
        try:
            rows.append([float(word) for word in words[:3]])
        except ValueError:
            raise ValueError(f"line {number} must have three numbers: {line[:40]}") from None
        if len(words) < 3:
            raise ValueError(f"line {number} holds {len(words)} numbers, not three")
    return np.array(rows, dtype=float).reshape(-1, 3)


def _read_npy(path: Path) -> Matrix:
    found = read_array(path)
    if found.ndim not in (2, 3) or found.shape[-1] != 3:
        raise ValueError(f"the array has shape {found.shape}; it must be (N, 3) or (H, W, 3)")
    if found.dtype.itemsize < 2:
        raise ValueError("the array has 8 bits per value, like the colours of a picture")
    return np.array(found, dtype=float).reshape(-1, 3)


def _read_pcd(path: Path) -> Matrix:
    from pypcd4.pypcd4 import PointCloud

    stated = _check_counts(path)
    points = PointCloud.from_path(path).numpy(("x", "y", "z")).reshape(-1, 3)
    if len(points) != stated:
        raise ValueError(f"POINTS is {stated}, but {len(points)} rows follow the header")
    return np.asarray(points, dtype=float)


def _pcd_header(path: Path) -> tuple[Any, int]:
    """Returns the header of a PCD, and the number of bytes in it."""
    from pypcd4.pypcd4 import MetaData

    lines: list[str] = []
    with path.open("rb") as file:
        for line in file:  # as the reader finds the header's end
            if (words := line.decode().strip()) and not words.startswith("#"):
                lines.append(words)
            if words.startswith("DATA") or len(lines) >= 10:
                break
        return MetaData.parse_header(lines), file.tell()


def _check_counts(path: Path) -> int:
    """Returns the number of points that the header of a PCD states.

    Raises ValueError if the file cannot hold them: the reader takes memory for each of them, before
    it looks for them.
    """
    from pypcd4.pypcd4 import Encoding

    header, start = _pcd_header(path)
    size = path.stat().st_size
    rest = size - start
    columns = sum(header.count)
    needed = header.points * sum(
        width * n for width, n in zip(header.size, header.count, strict=True)
    )
    room = rest
    if header.data == Encoding.ASCII:
        needed, room = 2 * columns * header.points, rest + 1  # a digit and a space each
    elif header.data != Encoding.BINARY:
        with path.open("rb") as file:
            file.seek(start + 4)
            room = int.from_bytes(file.read(4), "little")
        if room > LZF_RATIO * rest:
            raise ValueError(f"states {room} bytes of points, packed in {rest} bytes")
    if columns > size:
        raise ValueError(f"COUNT has {columns} values a point, but the file only {size} bytes")
    if needed > room:
        what = f"POINTS is {header.points}, which takes at least {needed} bytes"
        raise ValueError(f"{what}; {room} bytes follow the header")
    return int(header.points)
