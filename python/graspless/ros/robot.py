# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The robot that the node knows: its description, and where tf says that it stands."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .._xml import parse
from ..errors import TaskError, explain
from ..tasks.meshes import package_of
from ..tasks.statement import pose_fields
from .messages import RefusedError

if TYPE_CHECKING:
    from .senses import Description
    from .settings import Settings
    from .transforms import Transforms


def robot_fields(
    description: Description, transforms: Transforms, settings: Settings
) -> dict[str, Any] | None:
    """Returns the field `robot` of a task for the robot of the node; None without a description.

    Raises
    ------
    RefusedError
        The description is not well-formed, or tf does not know where its root link is.
    """
    urdf, srdf = description.texts()
    if not urdf:
        return None
    try:
        tree = parse(urdf)
    except (TaskError, ValueError, SyntaxError) as error:
        raise RefusedError(f"robot_description: {explain(error)}") from None
    names = {package_of(mesh.get("filename", "")) for mesh in tree.iterfind(".//mesh")}
    packages = {name: str(folder) for name in names if name and (folder := _share_of(name))}
    children = {child.get("link") for child in tree.iterfind("joint/child")}
    roots = [link.get("name", "") for link in tree.iterfind("link")]
    roots = [name for name in roots if name not in children]
    if len(roots) != 1:
        raise RefusedError(f"robot_description: has {len(roots)} root links, not one")
    X_WB = transforms.lookup(settings.world_frame, roots[0], patience=settings.tf_seconds)
    pose = {key: [float(v) for v in row] for key, row in pose_fields(X_WB).items()}
    fields: dict[str, Any] = {"urdf_text": urdf, "packages": packages, "pose": pose}
    return fields | {"srdf_text": srdf} if srdf else fields


def _share_of(package: str) -> Path | None:
    """Returns the share folder of a package of ROS."""
    for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        folder = Path(prefix) / "share" / package
        if prefix and folder.is_dir():
            return folder
    return None
