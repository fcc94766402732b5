# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of the node."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.exceptions import ParameterUninitializedException

from ..errors import TaskError, suggestion


@dataclass(frozen=True)
class Controller:
    """A controller of the robot.

    Attributes
    ----------
    name : str
        As in the parameter `controllers`.
    joints : tuple of str
        Joints that it moves.
    action : str
        Its action of type control_msgs/action/FollowJointTrajectory; empty: none.
    topic : str
        Its topic of type trajectory_msgs/msg/JointTrajectory, for the closed loop; empty: none.
    """

    name: str
    joints: tuple[str, ...]
    action: str
    topic: str


def _about(default: Any, text: str) -> Any:
    return field(default=default, metadata={"text": text})


@dataclass(frozen=True)
class Settings:
    """Parameters of the node; each field is one, with its description."""

    world_frame: str = _about("world", "frame of tasks, scenes and poses")
    robot: str = _about(
        "",
        "robot of picks: one that comes with graspless, or the path of a URDF; empty: the "
        "parameter or the topic robot_description",
    )
    robot_description: str = _about("", "text of the URDF; empty: that of the topic")
    robot_description_semantic: str = _about("", "text of the SRDF; empty: that of the topic")
    task_directory: str = _about("", "folder to which paths in tasks are relative; empty: here")
    jobs: int = _about(1, "number of goals that are planned at a time")
    queue: int = _about(32, "number of goals that wait or are planned; more are refused")
    joint_state_seconds: float = _about(0.5, "age of the oldest joint state to trust [s]")
    start_tolerance: float = _about(
        0.05,
        "distance of a joint from the start of its trajectory [rad; of sliding joints 1/10 m]",
    )
    start_seconds: float = _about(0.3, "time from sending a trajectory to its start [s]")
    image_seconds: float = _about(5.0, "time to wait for an image that is newer than the goal [s]")
    tf_seconds: float = _about(0.5, "time to wait for a transform [s]")
    controller_seconds: float = _about(2.0, "time to wait for an answer of a controller [s]")
    overtime_seconds: float = _about(5.0, "lateness after which a trajectory is stopped [s]")
    rate: float = _about(100.0, "targets per second in closed loop [1/s]")
    trajectory_rate: float = _about(20.0, "points per second of trajectories [1/s]")
    squeeze: float = _about(
        0.2, "closing of the hand beyond contact [rad; of sliding joints 1/10 m]"
    )
    max_velocity: float = _about(0.0, "limit of all joints [rad/s, m/s]; 0: that of the URDF")
    max_acceleration: float = _about(0.0, "limit of all joints [rad/s^2, m/s^2]; 0: 5 and 1")
    max_jerk: float = _about(0.0, "limit of all joints [rad/s^3, m/s^3]; 0: the default")
    contact_speed: float = _about(0.0, "limit of parts in contact [m/s]; 0: the default")
    controllers: tuple[Controller, ...] = ()

    @property
    def joints(self) -> list[str]:
        """Joints of all controllers."""
        return [name for each in self.controllers for name in each.joints]

    @property
    def limits(self) -> dict[str, Any]:
        """Arguments of `graspless.time`."""
        names = ("max_velocity", "max_acceleration", "max_jerk", "contact_speed")
        return {name: getattr(self, name) for name in names if getattr(self, name) > 0}


_POSITIVE = (
    "jobs",
    "queue",
    "joint_state_seconds",
    "start_tolerance",
    "start_seconds",
    "image_seconds",
    "tf_seconds",
    "controller_seconds",
    "overtime_seconds",
    "rate",
    "trajectory_rate",
)


def declare(node: Any) -> None:
    """Declares all parameters but those of the single controllers."""
    for each in fields(Settings):
        if each.name != "controllers":
            about = ParameterDescriptor(description=each.metadata["text"])
            node.declare_parameter(each.name, each.default, about)
    about = ParameterDescriptor(
        description="names of the controllers; each has NAME.joints, NAME.action and NAME.topic"
    )
    node.declare_parameter("controllers", [""], about)


def read(node: Any) -> Settings:
    """Returns the parameters of a node. Raises TaskError if one is out of its range."""
    given = {
        each.name: node.get_parameter(each.name).value
        for each in fields(Settings)
        if each.name != "controllers"
    }
    for name, value in given.items():
        if isinstance(value, str):
            continue
        least = "positive" if name in _POSITIVE else "at least 0"
        if not math.isfinite(value) or value < 0 or (name in _POSITIVE and value <= 0):
            raise TaskError(f"parameter {name}: {value}: should be finite and {least}")
    names = _names(node, "controllers", "name a controller, or be left out")
    controllers = tuple(_controller(node, name) for name in names)
    taken: dict[str, str] = {}
    for controller in controllers:
        for joint in controller.joints:
            if joint in taken:
                raise TaskError(
                    f"parameter {controller.name}.joints: {joint}: is a joint of the controller "
                    f"{taken[joint]}, too"
                )
            taken[joint] = controller.name
    _check_names(node)
    return Settings(**given, controllers=controllers)


def _check_names(node: Any) -> None:
    """Raises TaskError if a parameter is misspelt; warns of others that the node does not know."""
    known = [*node.get_parameters_by_prefix("")]
    for name in node._parameter_overrides:  # rclpy tells them in no other way
        if node.has_parameter(name) or name.startswith("qos_overrides."):
            continue
        if hint := suggestion(name, known, cutoff=0.8):
            raise TaskError(f"parameter {name}: unknown{hint}")
        node.get_logger().warning(f"parameter {name}: unknown, and ignored")


def _names(node: Any, name: str, wanted: str) -> tuple[str, ...]:
    """Returns a parameter that is a list of names, without empty ones."""
    try:
        return tuple(each for each in node.get_parameter(name).value if each)
    except ParameterUninitializedException:  # ROS has no type for an empty list
        raise TaskError(f"parameter {name}: []: should {wanted}") from None


def _controller(node: Any, name: str) -> Controller:
    for key, default in (("joints", [""]), ("action", ""), ("topic", "")):
        if not node.has_parameter(f"{name}.{key}"):
            node.declare_parameter(f"{name}.{key}", default)
    wanted = "name the joints of this controller"
    joints = _names(node, f"{name}.joints", wanted)
    if not joints:
        raise TaskError(f"parameter {name}.joints: should {wanted}")
    return Controller(
        name,
        joints,
        node.get_parameter(f"{name}.action").value,
        node.get_parameter(f"{name}.topic").value,
    )
