# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots of a pick, as they were given."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..errors import TaskError
from ..tasks.documents import in_plain_types
from ..tasks.robot_files import find_urdf
from ..tasks.source import Source
from .result import FILE


def labelled(robot: Any) -> dict[str, Any]:
    """Returns robots by name: that of the URDF; the second one of a name ends with (2).

    Raises TaskError if there is none.
    """
    several = list(robot) if isinstance(robot, (list, tuple)) else [robot]
    if not several:
        raise TaskError("robot: none: at least one is needed")
    for one in several:
        if not isinstance(one, (str, os.PathLike, Mapping)):
            what = "should be a robot's name, the path of a URDF, or the fields of a robot"
            raise TaskError(f"robot: {one!r}: {what}")
    labels: dict[str, Any] = {}
    for one in several:
        fields = one if isinstance(one, Mapping) else {"urdf": str(one)}
        given = next((fields[key] for key in ("urdf", "name", "arm") if key in fields), "robot")
        name = label = str(given).replace("\\", "/").rsplit("/", 1)[-1].removesuffix(".urdf")
        count = 1
        while label in labels:
            count += 1
            label = f"{name} ({count})"
        labels[label] = in_plain_types(one)
    return labels


def require_found(robots: list[Any]) -> None:
    """Raises TaskError that names a robot whose URDF, or whose gripper's, does not exist."""
    given = [one if isinstance(one, Mapping) else {"urdf": str(one)} for one in robots]
    source = Source(FILE, {"robot": given if len(given) > 1 else given[0]})
    for i, fields in enumerate(given):
        place = ("robot", i) if len(given) > 1 else ("robot",)
        hand = fields.get("gripper")
        parts = [(fields, place, key) for key in ("urdf", "arm")]
        if isinstance(hand, Mapping):
            parts.append((hand, (*place, "gripper"), "file"))
        for part, where, key in parts:
            if isinstance(part.get(key), str):
                find_urdf(part[key], key, (*where, key), source, Path.cwd())
