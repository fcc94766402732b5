# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of arrays."""

from __future__ import annotations

import io
import zipfile
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import files
from ..tasks.meshes import checksum

if TYPE_CHECKING:
    from collections.abc import Collection, Mapping
    from pathlib import Path

    from numpy.typing import NDArray


def read_arrays(
    path: Path, most: int, wanted: Collection[str] | None = None
) -> dict[str, NDArray[Any]]:
    """Returns the arrays of an .npz file by name.

    Parameters
    ----------
    path : Path
    most : int
        Number of bytes that the file may state, unpacked.
    wanted : collection of str, optional
        Names to read; others are left out. All by default.

    Raises
    ------
    Exception
        The file is not valid: numpy and zipfile raise whatever they stumble over.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            size = sum(entry.file_size for entry in archive.infolist())
    except zipfile.BadZipFile:
        raise ValueError("it is cut off, or no .npz file") from None
    if size > most:
        raise ValueError(f"states {size} bytes; at most {most}")
    with np.load(path, allow_pickle=False) as arrays:
        return {name: arrays[name] for name in arrays.files if wanted is None or name in wanted}


def packed(arrays: Mapping[str, Any]) -> bytes:
    """Returns the content of an .npz file."""
    content = io.BytesIO()
    np.savez_compressed(content, **arrays)
    return content.getvalue()


def keep_other(path: Path, content: bytes, scene: Path) -> Path | None:
    """Sets a file aside that `content` would replace, unless it belongs to the scene file.

    Returns its new path, or None if nothing would be lost.
    """
    if not path.is_file() or path.read_bytes() == content:
        return None
    is_own = scene.is_file() and checksum(path) in scene.read_text(
        encoding="utf-8", errors="replace"
    )
    return None if is_own else files.set_aside(path)
