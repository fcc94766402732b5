# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading point clouds."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from ..frames import Matrix

SUFFIXES = (".ply", ".pcd", ".xyz")
LZF_RATIO = 100  # of bytes unpacked to packed, at most: three bytes make 264


def read_cloud(path: str | Path) -> Matrix:
    """Returns the points of a PLY, PCD or XYZ file; of a PLY with faces, its vertices.

    Parameters
    ----------
    path : str or Path
        .ply (ascii, binary), .pcd (ascii, binary, binary_compressed) or .xyz.

    Returns
    -------
    array [N, 3]
        In the file's frame and unit.

    Raises
    ------
    ValueError
        The file is missing, unreadable, empty, or has values that are not finite.
    """
    path = Path(path)
    if path.suffix.lower() not in SUFFIXES:
        raise ValueError(f"unknown kind of point cloud (one of: {', '.join(SUFFIXES)})")
    if not path.is_file():
        raise ValueError("no such file")
    readers = {".pcd": _read_pcd, ".ply": _read_ply, ".xyz": _read_xyz}
    try:
        points = readers[path.suffix.lower()](path)
    except Exception as error:  # readers of broken files raise whatever they stumble over
        first = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise ValueError(f"cannot be read as a point cloud: {first}") from None
    if not len(points):
        raise ValueError("is empty: has no points")
    if broken := int(np.count_nonzero(~np.isfinite(points).all(axis=1))):
        raise ValueError(f"{broken} of {len(points)} points are not finite (NaN or Inf)")
    return points


def _read_ply(path: Path) -> Matrix:
    import trimesh

    loaded: Any = trimesh.load(path, process=False)
    parts = loaded.geometry.values() if isinstance(loaded, trimesh.Scene) else [loaded]
    points = [np.asarray(part.vertices, dtype=float) for part in parts]
    return np.concatenate(points) if points else np.empty((0, 3))


def _read_xyz(path: Path) -> Matrix:
    """Three numbers a line; further columns (colours, normals) and # comments are skipped."""
    rows = []
    for number, line in enumerate(path.read_text(encoding="utf-8-sig").splitlines(), 1):
        words = line.split("#")[0].replace(",", " ").split()
        if not words:
            continue
        try:
            rows.append([float(word) for word in words[:3]])
        except ValueError:
            raise ValueError(f"line {number} must have three numbers: {line[:40]}") from None
        if len(words) < 3:
            raise ValueError(f"line {number} holds {len(words)} numbers, not three")
    return np.array(rows, dtype=float).reshape(-1, 3)


def _read_pcd(path: Path) -> Matrix:
    from pypcd4.pypcd4 import PointCloud

    _check_counts(path)
    points = PointCloud.from_path(path).numpy(("x", "y", "z"))
    return np.asarray(points, dtype=float).reshape(-1, 3)


def _check_counts(path: Path) -> None:
    """Raises ValueError if the header of a PCD states more values than the file can hold.

    The reader takes memory for each of them, before it looks for them.
    """
    from pypcd4.pypcd4 import Encoding, MetaData

    lines: list[str] = []
    with path.open("rb") as file:
        for line in file:  # as the reader finds the header's end
            if (words := line.decode().strip()) and not words.startswith("#"):
                lines.append(words)
            if words.startswith("DATA") or len(lines) >= 10:
                break
        size = path.stat().st_size
        rest = size - file.tell()
        sizes = file.read(8)
    header = MetaData.parse_header(lines)
    columns = sum(header.count)
    needed = header.points * sum(
        width * n for width, n in zip(header.size, header.count, strict=True)
    )
    room = rest
    if header.data == Encoding.ASCII:
        needed, room = 2 * columns * header.points, rest + 1  # a digit and a space each
    elif header.data != Encoding.BINARY:
        room = int.from_bytes(sizes[4:], "little")
        if room > LZF_RATIO * rest:
            raise ValueError(f"states {room} bytes of points, packed in {rest} bytes")
    if columns > size:
        raise ValueError(f"COUNT has {columns} values a point, but the file only {size} bytes")
    if needed > room:
        what = f"POINTS is {header.points}, which takes at least {needed} bytes"
        raise ValueError(f"{what}; {room} bytes follow the header")
