# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots read from URDF, and their inverse kinematics."""

from __future__ import annotations

from pathlib import Path

from ._core.robot import (
    Ik,
    Robot,
)


def builtin(name: str) -> Path:
    """The URDF or xacro file of a robot that comes with graspless.

    Parameters
    ----------
    name : str
        wam_t42, wam_t42_tips, kr5_t42, kr5_sdh, kr5_dlr, kr5_icub or kr5_armar.

    Raises
    ------
    ValueError
        There is no such robot; lists those there are.
    """
    from . import _data

    path = _data.robot(name)
    if path is None:
        names = ", ".join(_data.robots())
        raise ValueError(f"{name}: no such robot comes with graspless (one of: {names})")
    return path


__all__ = [
    "Ik",
    "Robot",
    "builtin",
]


def __dir__() -> list[str]:
    return __all__
