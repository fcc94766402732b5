# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checksums of mesh files, which are not part of a plan file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from .source import Source


def checksum(path: Path) -> str:
    """sha256 of a file."""
    import hashlib

    return hashlib.sha256(path.read_bytes()).hexdigest()


def checksums(paths: Iterable[Path]) -> dict[str, str]:
    """Returns the checksums of meshes by path, for a plan file."""
    return {str(path): checksum(path) for path in sorted(paths)}


def check_files(files: dict[str, str], source: Source) -> None:
    """Raises TaskError if a mesh has changed since the plan was made."""
    for name, expected in files.items():
        path = Path(name)
        if not path.is_file():
            raise source.error(("files",), f"{name}: no such file, and the plan was made with it")
        if checksum(path) != expected:
            raise source.error(("files",), f"{name}: has changed since the plan was made")
