# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts .dae, .glb and .gltf files to vertices and triangles, in a process with limits.

Run as a script by path: it imports nothing of graspless. It gets the content of files and opens
none: textures are not read, and a .gltf must hold its own data.
"""

from __future__ import annotations

import io
import json
import sys
import xml.etree.ElementTree as ET
from typing import Any

MEMORY = 2**32  # [byte]


def _main() -> None:
    asked = json.loads(sys.stdin.buffer.readline())
    sys.path[:] = asked["sys_path"]
    told, sys.stdout = sys.stdout.buffer, sys.stderr  # messages of libraries must not mix with ours
    _limit_resources(asked["seconds"])
    for kind, size in zip(asked["kinds"], asked["sizes"], strict=True):
        data = sys.stdin.buffer.read(size)
        try:
            mesh = _converted(data, kind)
            answer: dict[str, Any] = {"size": len(mesh)}
        except Exception as error:  # trimesh and pycollada raise many kinds
            lines = str(error).splitlines()
            mesh, answer = b"", {"error": lines[0] if lines and lines[0] else type(error).__name__}
        told.write(json.dumps(answer).encode() + b"\n" + mesh)
        told.flush()


def _converted(data: bytes, kind: str) -> bytes:
    """Returns an .npz file with the vertices [m] and triangles of all geometries."""
    import numpy as np
    import trimesh

    if kind == "dae" and data[:2] == b"PK":
        raise ValueError("it is an archive; unpack it")
    if kind == "gltf":
        _require_own_data(data)
    scene: Any = trimesh.load(io.BytesIO(data), file_type=kind, force="scene", process=False)
    parts = []
    for node in scene.graph.nodes_geometry:
        X, name = scene.graph[node]
        part = scene.geometry[name]
        if isinstance(part, trimesh.Trimesh) and len(part.faces):
            parts.append(part.copy().apply_transform(X))
    if not parts:
        raise ValueError("it has no triangles")
    mesh: Any = trimesh.util.concatenate(parts)
    mesh.merge_vertices(merge_tex=True, merge_norm=True)
    if kind == "dae":
        mesh.vertices = mesh.vertices * _metres(data)
    buffer = io.BytesIO()
    triangles = mesh.faces.astype(np.int32)
    np.savez(buffer, vertices=np.asarray(mesh.vertices, dtype=float), triangles=triangles)
    return buffer.getvalue()


def _metres(data: bytes) -> float:
    """Returns the unit of a .dae file [m], which trimesh does not apply."""
    for _, element in ET.iterparse(io.BytesIO(data), events=("start",)):
        tag = element.tag.rpartition("}")[2]
        if tag == "unit":
            return float(element.get("meter", "1"))
        if tag.startswith("library"):
            break
    return 1.0


def _require_own_data(data: bytes) -> None:
    for buffer in json.loads(data).get("buffers", []):
        if not str(buffer.get("uri", "")).startswith("data:"):
            raise ValueError("it has its data in another file; save it as .glb")


def _limit_resources(seconds: int) -> None:
    try:
        import resource
    except ImportError:  # not on this platform
        return
    for kind, most in ((resource.RLIMIT_AS, MEMORY), (resource.RLIMIT_CPU, seconds)):
        _, hard = resource.getrlimit(kind)
        if hard == resource.RLIM_INFINITY or hard > most:
            resource.setrlimit(kind, (most, hard))


if __name__ == "__main__":
    _main()
