# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A node of ROS 2 that plans, checks and executes, and a simulated robot to try it on.

Nothing else in graspless imports this package, and nothing here needs ROS until it runs.
"""

from __future__ import annotations

import importlib

from ..errors import TaskError

HOW = (
    "source ROS 2 and the workspace with graspless_msgs, or run tools/install-ros in a checkout "
    "(docs/howto/ros2.md)"
)


def require_ros() -> None:
    """Raises TaskError if ROS 2 or the interfaces of graspless cannot be imported."""
    try:
        importlib.import_module("rclpy")
        for package in ("control_msgs.action", "graspless_msgs.action", "tf2_msgs.msg"):
            importlib.import_module(package)
    except ImportError as error:
        name = (error.name or str(error)).partition(".")[0]
        raise TaskError(f"ros: needs {name} of ROS 2: {HOW}") from None
