# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Locations of the robots and examples that come with graspless."""

from __future__ import annotations

from pathlib import Path


def directory(name: str) -> Path:
    """Returns the folder `urdf` or `examples`, of the installed package or of a checkout."""
    package = Path(__file__).resolve().parent
    installed = package / name
    return installed if installed.is_dir() else package.parents[1] / name


def robots() -> list[str]:
    """Names of the robots that come with graspless."""
    return sorted({path.name.split(".")[0] for path in directory("urdf").glob("*.urdf*")})


def robot(name: str) -> Path | None:
    """Returns the URDF or xacro file of a built-in robot, or None if there is no such robot."""
    for suffix in (".urdf", ".urdf.xacro"):
        path = directory("urdf") / f"{name}{suffix}"
        if path.is_file():
            return path
    return None
