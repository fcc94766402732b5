# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Markers of a plan for RViz: the path of the object, and its frame on the way."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from geometry_msgs.msg import Point
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

if TYPE_CHECKING:
    from ..frames import Matrix
    from .jobs import Found

_AXES, _LENGTH, _WIDTH = 8, 0.04, 0.003  # number of frames; lengths [m]


def markers_of(found: Found, frame: str, stamp: Any) -> Any:
    """Returns the MarkerArray of a plan. It replaces that of the plan before."""
    message = MarkerArray(markers=[_marker(0, Marker.DELETEALL, frame, stamp)])
    if found.object_poses is None or not len(found.object_poses):
        return message
    poses = np.asarray(found.object_poses)
    path = _marker(1, Marker.ADD, frame, stamp)
    path.type, path.color = Marker.LINE_STRIP, ColorRGBA(r=1.0, g=0.6, b=0.0, a=1.0)
    path.points = [_point(X[:3, 3]) for X in poses]
    axes = _marker(2, Marker.ADD, frame, stamp)
    axes.type = Marker.LINE_LIST
    for k in np.unique(np.linspace(0, len(poses) - 1, _AXES).astype(int)):
        _add_axes(axes, poses[k])
    message.markers += [path, axes]
    return message


def _marker(number: int, action: int, frame: str, stamp: Any) -> Any:
    marker = Marker(ns="graspless", id=number, action=action)
    marker.header.frame_id, marker.header.stamp = frame, stamp
    marker.pose.orientation.w, marker.scale.x = 1.0, _WIDTH
    return marker


def _add_axes(marker: Any, X: Matrix) -> None:
    for k in range(3):
        color = ColorRGBA(a=1.0, **{"rgb"[k]: 1.0})
        marker.points += [_point(X[:3, 3]), _point(X[:3, 3] + _LENGTH * X[:3, k])]
        marker.colors += [color, color]


def _point(p: Matrix) -> Any:
    return Point(x=float(p[0]), y=float(p[1]), z=float(p[2]))
