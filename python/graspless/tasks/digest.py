# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Digest of a task that does not depend on the place of its files."""

from __future__ import annotations

import hashlib
import json
import xml.etree.ElementTree as ET
from typing import Any

from .._xml import parse
from .meshes import mesh_path


def digest(document: dict[str, Any]) -> str:
    """sha256, the same for tasks that say the same.

    Parameters
    ----------
    document : dict
        Document from `Task.to_dict`. Where the robot's files stand says nothing. Places of meshes
        do, in `files`: a plan is read only where they are.
    """
    said = _said(document, document.get("files", {}))
    return hashlib.sha256(json.dumps(said, sort_keys=True).encode()).hexdigest()


def _said(value: Any, files: dict[str, str]) -> Any:
    if isinstance(value, list):
        return [_said(item, files) for item in value]
    if not isinstance(value, dict):
        return value
    if "urdf_text" in value:
        value = _robot(value, files)
    return {key: _said(item, files) for key, item in value.items()}


def _robot(robot: dict[str, Any], files: dict[str, str]) -> dict[str, Any]:
    """Returns the fields of a robot without folders, with mesh contents in place of names."""
    packages, folder = robot.get("packages", {}), robot.get("directory")
    said = {key: value for key, value in robot.items() if key not in ("packages", "directory")}
    for key in {"urdf_text", "srdf_text"} & set(said):
        try:
            root = parse(said[key])  # drops remarks: xacro's has the path of its file
        except ValueError:  # which the robot's reader tells
            continue
        for mesh in root.iter("mesh"):
            name = mesh.get("filename", "")
            mesh.set("filename", files.get(str(mesh_path(name, packages, folder)), name))
        said[key] = ET.tostring(root, encoding="unicode")
    return said
