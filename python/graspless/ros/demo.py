# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Command `graspless ros demo`: from the image to the lifted object, over ROS, without a robot."""

from __future__ import annotations

import contextlib
import os
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import rclpy
import yaml
from geometry_msgs.msg import PoseWithCovarianceStamped
from graspless_msgs.action import PickObject
from graspless_msgs.srv import CheckPlan
from rclpy.action import ActionClient
from rclpy.qos import qos_profile_sensor_data

from .._commands import FOUND, NOT_FOUND
from ..errors import TaskError
from .fake_world import SCENE

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

LIFTED = 0.05  # height that counts [m]
_PATIENCE = 60.0  # for each step [s]


def demo(arguments: Sequence[str]) -> int:
    """Starts a simulated robot and the node, picks up a bar, and prints what goes over ROS.

    Nothing leaves this computer: discovery is limited to it, in a domain of its own.
    """
    began = time.monotonic()
    os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
    os.environ.setdefault("ROS_DOMAIN_ID", str(random.SystemRandom().randint(1, 101)))
    with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as stack:
        file = Path(folder) / "node.yaml"
        text = yaml.safe_dump({"/**": {"ros__parameters": parameters()}})
        file.write_text(text, encoding="utf-8")
        robot = stack.enter_context(process("fake-robot"))
        served = stack.enter_context(process("node", "--params-file", str(file)))
        rclpy.init(args=["demo", *arguments])
        stack.callback(rclpy.try_shutdown)
        node = rclpy.create_node("demo")
        stack.callback(node.destroy_node)
        running = {"fake-robot": robot, "node": served}
        return FOUND if Transcript(node, began, running).run() else NOT_FOUND


def parameters() -> dict[str, Any]:
    """Returns the parameters of the node for the simulated robot."""
    from .fake_world import World

    world = World("wam_t42", ())
    given: dict[str, Any] = {"use_sim_time": True, "controllers": ["arm", "hand"]}
    for group in ("arm", "hand"):
        given[group] = {
            "joints": [world.robot.joint_names[j] for j in world.robot.group(group)],
            "action": f"/{group}_controller/follow_joint_trajectory",
            "topic": f"/{group}_controller/joint_trajectory",
        }
    return given


@contextlib.contextmanager
def process(what: str, *arguments: str) -> Iterator[subprocess.Popen[bytes]]:
    """Runs `graspless ros WHAT` until the block ends."""
    command = [sys.executable, "-m", "graspless", "ros", what, "--ros-args", *arguments]
    running = subprocess.Popen(command)
    try:
        yield running
    finally:
        running.terminate()
        try:
            running.wait(10)
        except subprocess.TimeoutExpired:
            running.kill()
            running.wait()


class Transcript:
    """A client that prints what it hears.

    Parameters
    ----------
    node : rclpy.node.Node
    began : float
        Start, by time.monotonic [s].
    running : dict of Popen
        Processes that have to go on, by their names.
    """

    def __init__(
        self, node: Any, began: float, running: dict[str, subprocess.Popen[bytes]]
    ) -> None:
        self._node, self._began, self._running = node, began, running
        self._height: Any = None  # of the bar [m]
        sensor = qos_profile_sensor_data
        node.create_subscription(PoseWithCovarianceStamped, "object_pose", self._hear, sensor)

    def _hear(self, message: Any) -> None:
        self._height = message.pose.pose.position.z

    def say(self, text: str) -> None:
        """Prints a line with the time since the start."""
        print(f"{time.monotonic() - self._began:6.2f} s  {text}", flush=True)

    def _until(self, is_done: Any, what: str) -> None:
        end = time.monotonic() + _PATIENCE
        while not is_done():
            for name, each in self._running.items():
                if each.poll() is not None:
                    raise TaskError(
                        f"ros demo: the process {name} ended with exit code {each.returncode}"
                    )
            if time.monotonic() > end:
                raise TaskError(f"ros demo: {what} did not come within {_PATIENCE:g} s")
            rclpy.spin_once(self._node, timeout_sec=0.1)

    def _answer(self, future: Any, what: str) -> Any:
        self._until(future.done, what)
        return future.result()

    def run(self) -> bool:
        """Picks up the bar; returns True if it was lifted."""
        client = ActionClient(self._node, PickObject, "pick_object")
        self._until(lambda: client.server_is_ready(), "the action pick_object")
        self._until(lambda: self._height is not None, "the topic object_pose")
        low = self._height
        self.say(f"/object_pose: the bar is at a height of {100 * low:.1f} cm")
        result = self._picked(client)
        if result is None:
            return False
        self._check(result.motion.plan)
        rclpy.spin_once(self._node, timeout_sec=0.5)
        self._height = None
        self._until(lambda: self._height is not None, "the topic object_pose")
        lifted = self._height - low
        self.say(f"/object_pose: the bar was lifted by {100 * lifted:.1f} cm")
        return bool(lifted > LIFTED)

    def _picked(self, client: Any) -> Any:
        bar = next(block for block in SCENE if block.name == "bar")
        goal = PickObject.Goal(robot="wam_t42", execute=True)
        goal.at.header.frame_id = "world"
        goal.at.point.x, goal.at.point.y, goal.at.point.z = bar.center
        self.say("goal to /pick_object: the object at the bar, robot wam_t42, execute")
        future = client.send_goal_async(goal, feedback_callback=self._feedback)
        handle = self._answer(future, "an answer of pick_object")
        result = self._answer(handle.get_result_async(), "a result of pick_object").result
        motion = result.motion
        self.say(f"result: {motion.status} {motion.reason}")
        self.say(f"  objects seen: {', '.join(result.objects)}; picked {result.name}")
        for each in result.attempts:
            self.say(f"  {each.strategy}: {each.status} {each.reason}")
        for name, trajectory in zip(motion.controllers, motion.trajectories, strict=True):
            last = trajectory.points[-1].time_from_start
            seconds = last.sec + 1e-9 * last.nanosec
            joints = ", ".join(trajectory.joint_names)
            self.say(f"  {name}: {len(trajectory.points)} points, {seconds:.2f} s: {joints}")
        return result if motion.status == motion.EXECUTED else None

    def _feedback(self, message: Any) -> None:
        feedback = message.feedback
        self.say(f"feedback: {feedback.phase} ({feedback.seconds:.2f} s)")

    def _check(self, plan: str) -> None:
        service = self._node.create_client(CheckPlan, "check_plan")
        self._until(service.service_is_ready, "the service check_plan")
        answer = self._answer(service.call_async(CheckPlan.Request(plan=plan)), "a check")
        self.say(f"/check_plan: {'holds' if answer.holds else '; '.join(answer.faults)}")
