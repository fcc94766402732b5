# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Running nodes until they are interrupted. No exception of a callback ends a node."""

from __future__ import annotations

import os
import signal
import threading
import traceback
from pathlib import Path
from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.signals import SignalHandlerOptions
from rclpy.utilities import remove_ros_args

from ..errors import TaskError

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

_CONFIGURED = (  # variables of a user who has configured Fast DDS
    "FASTDDS_DEFAULT_PROFILES_FILE",
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "FASTDDS_BUILTIN_TRANSPORTS",
)
_RANGE, _PEERS = "ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_STATIC_PEERS"


def use_sockets() -> None:
    """Lets Fast DDS send by UDP alone, unless the user has configured it.

    In shared memory, what is sent to a client that was killed stays until the client is given up:
    when 0.5 MB are full, nobody gets results any more. And the next client takes over the port of
    a killed one, of which the sender learns seconds later: the answers until then are lost. Must be
    called before ROS is initialised.
    """
    if any(os.environ.get(name) for name in _CONFIGURED):
        return
    # For LOCALHOST, ROS adds shared memory. Peers on other computers need its own settings.
    if os.environ.get(_RANGE) == "LOCALHOST" and not os.environ.get(_PEERS):
        os.environ[_RANGE] = "SYSTEM_DEFAULT"
        os.environ[_CONFIGURED[0]] = str(Path(__file__).with_name("localhost.xml"))
    else:
        os.environ["FASTDDS_BUILTIN_TRANSPORTS"] = "UDPv4"


def spin(executor: Any, is_over: Callable[[], bool] = lambda: False) -> None:
    """Spins until ROS is shut down, or `is_over`; exceptions of callbacks are logged."""
    while rclpy.ok(context=executor.context) and not is_over():
        try:
            executor.spin_once(timeout_sec=0.1)
        except ExternalShutdownException:
            return
        except Exception:
            for node in executor.get_nodes():
                node.get_logger().error(traceback.format_exc())
                if hasattr(node, "faults"):
                    node.faults += 1


def run_node(arguments: Sequence[str]) -> bool:
    """Runs the node until it is interrupted; returns False then.

    The robot is stopped first. Raises TaskError if the node cannot start.
    """
    from .node import GrasplessNode

    use_sockets()
    return _run(GrasplessNode, arguments)


def run_fake_robot(arguments: Sequence[str]) -> bool:
    """Runs the simulated robot until it is interrupted; returns False then."""
    from .fake_robot import FakeRobot

    return _run(FakeRobot, arguments)


def _run(make: Callable[[], Any], arguments: Sequence[str]) -> bool:
    left = remove_ros_args(["graspless", *arguments])[1:]
    if left:
        raise TaskError(f"ros: {left[0]}: unknown argument: those of ROS come after --ros-args")
    # By default a signal would close ROS, and nobody could tell the controllers to stop.
    rclpy.init(args=["graspless", *arguments], signal_handler_options=SignalHandlerOptions.NO)
    node = make()
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    stop = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):  # an exception could come from anywhere
        signal.signal(number, lambda *_: stop.set())
    try:
        if hasattr(node, "start") and not node.start():
            raise TaskError("ros: the node could not be configured; its log says why")
        spin(executor, stop.is_set)
        return not stop.is_set()
    finally:
        close(node, executor)
        rclpy.try_shutdown()


def close(node: Any, executor: Any) -> None:
    """Ends the goals of a node while it still hears answers, then the node."""
    if hasattr(node, "end_goals"):
        ending = threading.Thread(target=node.end_goals)
        ending.start()
        spin(executor, lambda: not ending.is_alive())
        ending.join()
        node.close()
    executor.shutdown()
    node.destroy_node()
