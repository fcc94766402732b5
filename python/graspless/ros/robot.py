# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The robot that the node knows: its description, and where tf says that it stands."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._xml import origin, parse
from ..errors import TaskError, explain
from ..tasks.meshes import package_of
from ..tasks.statement import pose_fields
from .messages import RefusedError

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from ..frames import Matrix
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
        The description is not well-formed, or tf does not know where the robot is.
    """
    urdf, srdf = description.texts()
    if not urdf:
        return None
    try:
        tree = parse(urdf)
        link, X_CB = _placed_link(tree)
    except (TaskError, ValueError, SyntaxError) as error:
        raise RefusedError(f"robot_description: {explain(error)}") from None
    names = {package_of(mesh.get("filename", "")) for mesh in tree.iterfind(".//mesh")}
    packages = {name: str(folder) for name in names if name and (folder := _share_of(name))}
    X_WC = transforms.lookup(settings.world_frame, link, patience=settings.tf_seconds)
    X_WB = X_WC @ X_CB
    pose = {key: [float(v) for v in row] for key, row in pose_fields(X_WB).items()}
    fields: dict[str, Any] = {"urdf_text": urdf, "packages": packages, "pose": pose}
    return fields | {"srdf_text": srdf} if srdf else fields


def _placed_link(tree: Element) -> tuple[str, Matrix]:
    """Returns a link C that tf is asked for, and the pose X_CB of the root link in it.

    It is the root link, or the link that a planar or floating joint carries there: planners take
    such a joint for fixed at 0, and tf knows where it is.
    """
    children = {child.get("link") for child in tree.iterfind("joint/child")}
    roots = [link.get("name", "") for link in tree.iterfind("link")]
    roots = [name for name in roots if name not in children]
    if len(roots) != 1:
        raise ValueError(f"has {len(roots)} root links, not one")
    free = [
        joint for joint in tree.iterfind("joint") if joint.get("type") in ("planar", "floating")
    ]
    if not free:
        return roots[0], np.eye(4)
    if len(free) > 1:
        names = ", ".join(joint.get("name", "") for joint in free)
        raise ValueError(f"has {len(free)} planar or floating joints, not one: {names}")
    child, X_BC = free[0].find("child"), origin(free[0])
    return "" if child is None else child.get("link", ""), np.asarray(np.linalg.inv(X_BC), float)


def _share_of(package: str) -> Path | None:
    """Returns the share folder of a package of ROS."""
    for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        folder = Path(prefix) / "share" / package
        if prefix and folder.is_dir():
            return folder
    return None
