# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Supports and objects in depth images, and depth images of known scenes.

Lengths are in metres. Images are arrays (H, W); the optical frame of a camera has x right, y down
and z forward.

>>> scene = graspless.perceive(depth, K, X_WC)  # doctest: +SKIP
>>> for thing in scene.objects:  # doctest: +SKIP
...     print(thing.name, thing.thickness, thing.thickness_error)
"""

from .._core.perception import (
    Body,
    Camera,
    EdgeLabel,
    Object,
    Options,
    Rendering,
    Scene,
    Status,
    Support,
    Unseen,
    View,
    cast_rays,
)
from .._core.perception import perceive as perceive_views
from .clouds import average, view_of_cloud, view_of_organized
from .front import perceive
from .rendering import Frame, Noise, look_at, render
from .scene_files import load_scene, save_scene

__all__ = [
    "Body",
    "Camera",
    "EdgeLabel",
    "Frame",
    "Noise",
    "Object",
    "Options",
    "Rendering",
    "Scene",
    "Status",
    "Support",
    "Unseen",
    "View",
    "average",
    "cast_rays",
    "load_scene",
    "look_at",
    "perceive",
    "perceive_views",
    "render",
    "save_scene",
    "view_of_cloud",
    "view_of_organized",
]


def __dir__() -> list[str]:
    return __all__
