# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots by name, from the package robot_descriptions, which downloads each once."""

from __future__ import annotations

import contextlib
import importlib
import os
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .errors import explain, missing, suggestion

if TYPE_CHECKING:
    from collections.abc import Iterator

MOST_FOLDERS = 2000  # of a repository that are searched for packages


@dataclass
class Described:
    """Files of a robot.

    Attributes
    ----------
    urdf : pathlib.Path
        URDF or xacro file.
    directory : pathlib.Path
        Folder that relative mesh paths start from.
    srdf : pathlib.Path, optional
        SRDF file, if it is not beside the URDF.
    packages : dict
        Folder of each package://NAME/.
    xacro_args : dict
        Arguments of the xacro file.
    """

    urdf: Path
    directory: Path
    srdf: Path | None = None
    packages: dict[str, str] = field(default_factory=dict)
    xacro_args: dict[str, Any] = field(default_factory=dict)


def described(name: str) -> Described:
    """See `graspless.robot.described`. Messages do not repeat the name."""
    module = _module(name)
    urdf = getattr(module, "URDF_PATH", None)
    xacro = getattr(module, "XACRO_PATH", None)
    if not (urdf or xacro):
        raise ValueError("has no URDF; choose another description")
    path = Path(str(urdf or xacro))
    if not path.is_file():
        raise ValueError(f"its cache has no file {path}")
    package, repository = Path(module.PACKAGE_PATH), Path(module.REPOSITORY_PATH)
    srdf = Path(getattr(module, "SRDF_PATH", ""))
    return Described(
        path,
        path.parent if urdf else package,
        srdf if srdf.is_file() else None,
        _packages(repository)
        | {folder.name: str(folder) for folder in (repository, package)}
        | getattr(module, "XACRO_PACKAGE_PATHS", {}),
        getattr(module, "XACRO_ARGS", {}) if xacro else {},
    )


def _module(name: str) -> Any:
    """Imports the description, which downloads it unless it is in the cache."""
    names = _names()
    if name not in names:
        hint = suggestion(name, names, 3) or suggestion(f"{name}_description", names, 3)
        raise ValueError(f"no such robot in robot_descriptions{hint}")
    with _quiet():
        try:
            return importlib.import_module(f"robot_descriptions.{name}")
        except Exception as error:  # git's, and those of the operating system
            stderr = str(getattr(error, "stderr", "") or "").replace("stderr:", "").strip(" '\n")
            why = stderr.splitlines()[-1] if stderr else explain(error)
            raise ValueError(
                f"cannot be downloaded: {why}; it needs git and the network once, or a "
                "cache that was filled before (ROBOT_DESCRIPTIONS_CACHE)"
            ) from error


def _names() -> list[str]:
    """Names of the descriptions; neither git nor a description is imported."""
    try:
        import robot_descriptions
    except ImportError as error:
        raise missing(error, "robots", " for robots by name") from None
    folder = Path(robot_descriptions.__file__).parent
    return sorted(path.stem for path in folder.glob("*_description.py") if path.stem[0] != "_")


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """Keeps messages out of stdout, and git from asking for a password."""
    before = os.environ.get("GIT_TERMINAL_PROMPT")
    os.environ["GIT_TERMINAL_PROMPT"] = "0"
    try:
        with contextlib.redirect_stdout(sys.stderr):
            yield
    finally:
        if before is None:
            del os.environ["GIT_TERMINAL_PROMPT"]
        else:
            os.environ["GIT_TERMINAL_PROMPT"] = before


def _packages(repository: Path) -> dict[str, str]:
    """Returns the folders of a repository's ROS packages by name, as package.xml states it."""
    packages: dict[str, str] = {}
    for count, (folder, folders, files) in enumerate(os.walk(repository)):
        if count == MOST_FOLDERS:
            break
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        if "package.xml" in files:
            text = Path(folder, "package.xml").read_text(encoding="utf-8", errors="replace")
            if found := re.search(r"<name>\s*([\w.-]+)\s*</name>", text):
                packages.setdefault(found[1], folder)
    return packages
