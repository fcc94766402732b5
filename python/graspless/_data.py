# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the robots and examples that come with graspless are."""

from __future__ import annotations

from pathlib import Path


def directory(name: str) -> Path:
    """`urdf` or `examples`: in the installed package, or at the root of a checkout."""
    package = Path(__file__).resolve().parent
    installed = package / name
    return installed if installed.is_dir() else package.parents[1] / name


def robots() -> list[str]:
    """Names of the robots that come with graspless."""
    return sorted({path.name.split(".")[0] for path in directory("urdf").glob("*.urdf*")})


def robot(name: str) -> Path | None:
    """The URDF or xacro file of a built-in robot."""
    for suffix in (".urdf", ".urdf.xacro"):
        path = directory("urdf") / f"{name}{suffix}"
        if path.is_file():
            return path
    return None
