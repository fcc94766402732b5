# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads .dae, .glb and .gltf for the core, by trimesh in a process of its own (_mesh_process.py).

Meshes are kept in the user's cache by the checksum of their file: reading a .dae takes seconds.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import os
import subprocess
import sys
import zipfile
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ._core import geometry
from .errors import TaskError, explain, missing
from .files import make_folder, write

if TYPE_CHECKING:
    from collections.abc import Iterable

VERSION = 1  # of the files in the cache
LARGEST = 2**28  # [byte] of a file
SECONDS = 60  # [s]
PROCESS = Path(__file__).with_name("_mesh_process.py")


def read(path: str) -> geometry.Mesh:
    """Returns the mesh of a file in metres, in the axes of the file; raises ValueError.

    The up axis that a file states is ignored, as RViz and MoveIt do: the files of real robots count
    on that.
    """
    try:
        data = _content(path)
        kept = _cached(path, data)
        with contextlib.suppress(OSError, ValueError, KeyError):
            return _mesh(kept.read_bytes())
        converted = next(_convert([(path, data)]))
        mesh = _mesh(converted)
    except TaskError as error:
        raise ValueError(f"mesh '{path}' {error}") from None
    except ValueError as error:
        raise ValueError(f"mesh '{path}' cannot be read: {error}") from None
    _keep(kept, converted)
    return mesh


def prepare(paths: Iterable[Path]) -> None:
    """Puts meshes into the cache, by a single process. Faults are left for `read` to report."""
    files: list[tuple[str, bytes]] = []
    for path in sorted(paths):
        if sum(len(data) for _, data in files) > LARGEST:
            return
        with contextlib.suppress(ValueError):
            data = _content(str(path))
            if not _cached(str(path), data).is_file():
                files.append((str(path), data))
    if len(files) < 2:
        return
    try:
        converted = _convert(files)
    except ValueError:
        return
    for name, data in files:
        try:
            _keep(_cached(name, data), next(converted))
        except ValueError:
            continue


def _content(path: str) -> bytes:
    try:
        size = Path(path).stat().st_size
        if size > LARGEST:
            raise ValueError(f"it has {size} bytes, more than {LARGEST}")
        return Path(path).read_bytes()
    except OSError as error:
        if error.errno is None:  # a TimeoutError of the program
            raise
        raise ValueError(str(error.strerror)) from None


def _mesh(data: bytes) -> geometry.Mesh:
    import numpy as np

    try:
        with np.load(io.BytesIO(data), allow_pickle=False) as arrays:
            return geometry.Mesh(arrays["vertices"], arrays["triangles"])
    except (EOFError, SyntaxError, TypeError, zipfile.BadZipFile) as error:  # damaged in the cache
        raise ValueError(explain(error)) from None


class _Answers:
    """Iterator over the converted files, in order; raises ValueError for one with a fault."""

    def __init__(self, output: bytes) -> None:
        self._output = io.BytesIO(output)

    def __next__(self) -> bytes:
        try:
            said: Any = json.loads(self._output.readline())
        except ValueError:
            raise ValueError("it needs too much time or memory") from None
        if "error" in said:
            raise ValueError(str(said["error"]))
        data = self._output.read(said["size"])
        if len(data) < said["size"]:
            raise ValueError("it needs too much time or memory")
        return data


def _convert(files: list[tuple[str, bytes]]) -> _Answers:
    kinds = [Path(path).suffix.lower()[1:] for path, _ in files]
    for package in ("trimesh", "collada") if "dae" in kinds else ("trimesh",):
        if find_spec(package) is None:
            raise missing(ImportError(name=package), "robots", " for .dae, .glb and .gltf files")
    sizes = [len(data) for _, data in files]
    asked = {"kinds": kinds, "sizes": sizes, "sys_path": sys.path, "seconds": SECONDS}
    try:
        done = subprocess.run(
            [sys.executable, "-I", str(PROCESS)],
            input=b"".join([json.dumps(asked).encode(), b"\n", *(data for _, data in files)]),
            capture_output=True,
            timeout=SECONDS,
            env=os.environ | {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"},
        )
    except subprocess.TimeoutExpired as error:
        return _Answers(error.stdout or b"")
    except OSError as error:
        if error.errno is None:  # a TimeoutError of the program
            raise
        raise ValueError(f"its reader cannot be started: {error.strerror}") from None
    return _Answers(done.stdout)


def _cached(path: str, data: bytes) -> Path:
    """Returns the place of a mesh in the user's cache."""
    kind = Path(path).suffix.lower()[1:]
    return _cache() / f"{hashlib.sha256(data).hexdigest()}-{kind}-{VERSION}.npz"


def _cache() -> Path:
    """Returns the folder of meshes in the user's cache."""
    folder = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    return Path(folder) / "graspless" / "meshes"


def _keep(path: Path, data: bytes) -> None:
    """Writes a file to the cache, if that is possible."""
    with contextlib.suppress(TaskError):
        make_folder(path.parent)
        write(path, data)
