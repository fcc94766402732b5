# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A node that finds nobody: no robot, no camera, no controllers. Each goal says what is missing."""

import re
import subprocess
import sys
import threading
import time
from contextlib import nullcontext

import pytest
import rclpy
from graspless_msgs.action import PickObject, PlanTask
from rclpy.action import ActionClient
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter
from rig import TASK
from sensor_msgs.msg import JointState

from graspless import TaskError
from graspless.ros import demo, server, settings
from graspless.ros.demo import Transcript, parameters
from graspless.ros.diagnostics import statuses
from graspless.ros.goals import Desk, Goal
from graspless.ros.node import GrasplessNode
from graspless.ros.results import bytes_of
from graspless.ros.spinning import spin

WHOLE = 500_000  # kept of results [bytes]: few enough to be found before rclpy forgets the first


class Alone:
    """A node and a client in a namespace where nobody else is."""

    def __init__(self):
        self.context = rclpy.Context()
        rclpy.init(context=self.context)
        given = parameters()
        short = {"controller_seconds": 0.3, "image_seconds": 0.3, "tf_seconds": 0.1}
        values = {"controllers": given["controllers"]} | short
        for group in values["controllers"]:
            values |= {f"{group}.{key}": value for key, value in given[group].items()}
            values[f"{group}.action"] = f"/nobody/{group}/follow_joint_trajectory"
            values[f"{group}.topic"] = f"/nobody/{group}/joint_trajectory"
        self.joints = [name for group in values["controllers"] for name in given[group]["joints"]]
        self.node = GrasplessNode(
            namespace="alone",
            context=self.context,
            parameter_overrides=[Parameter(name, value=value) for name, value in values.items()],
        )
        assert self.node.start()
        self.executor = SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self.is_over = threading.Event()
        self.thread = threading.Thread(target=spin, args=(self.executor, self.is_over.is_set))
        self.thread.start()
        self.client = rclpy.create_node("client", namespace="alone", context=self.context)
        self.own = SingleThreadedExecutor(context=self.context)
        self.own.add_node(self.client)
        self.plan_task = ActionClient(self.client, PlanTask, "plan_task")
        self.pick_object = ActionClient(self.client, PickObject, "pick_object")
        self.states = self.client.create_publisher(JointState, "joint_states", 10)

    def close(self):
        self.node.end_goals()
        self.is_over.set()
        self.thread.join()
        self.node.close()
        for executor in (self.own, self.executor):
            executor.shutdown()
        for node in (self.client, self.node):
            node.destroy_node()
        rclpy.shutdown(context=self.context)

    def do(self, goal, states=False):
        """Returns the motion of a goal; publishes that all joints are at 0 meanwhile."""
        handle = self.send(goal, states)
        return self.result(handle, states)

    def send(self, goal, states=False):
        client = self.plan_task if isinstance(goal, PlanTask.Goal) else self.pick_object
        assert client.wait_for_server(20)
        sent = client.send_goal_async(goal)
        self._until(sent.done, states)
        return sent.result()

    def result(self, handle, states=False):
        future = handle.get_result_async()
        self._until(future.done, states)
        return future.result().result.motion

    def _until(self, is_so, states):
        end = time.monotonic() + 20
        while not is_so():
            assert time.monotonic() < end
            if states:
                message = JointState(name=self.joints, position=[0.0] * len(self.joints))
                message.header.stamp = self.client.get_clock().now().to_msg()
                self.states.publish(message)
            self.own.spin_once(timeout_sec=0.02)


@pytest.fixture(scope="module")
def alone():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(server, "WHOLE", WHOLE)
        made = Alone()
    yield made
    assert made.node.faults == 0
    made.close()


def test_a_robot_that_says_nothing_is_not_moved(alone):
    motion = alone.do(PlanTask.Goal(task=TASK, seed=1, execute=True))
    assert motion.status == "refused"
    assert motion.reason.startswith(f"no joint state was heard of {alone.joints[0]}")


@pytest.mark.parametrize(
    ("closed_loop", "reason"),
    [
        (False, "nobody serves /nobody/arm/follow_joint_trajectory"),
        (True, "nobody listens to /nobody/arm/joint_trajectory"),
    ],
)
def test_controllers_that_are_not_there_are_named(alone, closed_loop, reason):
    goal = PlanTask.Goal(task=TASK, seed=1, execute=True, closed_loop=closed_loop)
    motion = alone.do(goal, states=True)
    assert (motion.status, motion.reason) == ("refused", reason)


def test_a_camera_that_is_not_there_is_told(alone):
    motion = alone.do(PickObject.Goal(name="object_0", robot="wam_t42"))
    assert (motion.status, motion.reason) == ("refused", "no depth image came within 0.3 s")


def test_a_description_that_never_came_is_told(alone):
    motion = alone.do(PickObject.Goal(name="object_0"))
    assert motion.status == "refused"
    assert "no robot_description was received" in motion.reason


def test_results_can_be_asked_for_again_until_others_need_the_memory(alone):
    goal = PlanTask.Goal(task=TASK, seed=1)
    handle = alone.send(goal)
    size = bytes_of(alone.result(handle))
    assert alone.result(handle).trajectories
    motions = [alone.result(handle)]
    while motions[-1].trajectories:
        assert alone.do(goal).trajectories
        motions.append(alone.result(handle))
    assert len(motions) - 1 == WHOLE // size
    motion = motions[-1]
    assert (motion.status, motion.plan) == ("solved", "")
    assert "not kept" in motion.warnings[-1]


def test_diagnostics_say_what_is_missing(alone):
    texts = {status.name: status.message for status in statuses(alone.node)}
    assert texts["graspless: depth image"] == "none was heard"
    assert texts["graspless: controllers"] == "nobody serves arm, hand"


def test_a_client_that_finds_no_node_says_so(bench, monkeypatch):
    monkeypatch.setattr(demo, "_PATIENCE", 0.3)
    node = rclpy.create_node("lost", namespace="lost")
    try:
        with pytest.raises(TaskError, match="the action pick_object did not come within 0.3 s"):
            Transcript(node, time.monotonic(), {}).run()
    finally:
        node.destroy_node()


def test_a_demo_whose_process_has_ended_says_so(bench, monkeypatch):
    monkeypatch.setattr(demo, "_PATIENCE", 5.0)
    node = rclpy.create_node("lost", namespace="lost")
    ended = subprocess.Popen([sys.executable, "-c", "raise SystemExit(3)"])
    try:
        with pytest.raises(TaskError, match="the process fake-robot ended with exit code 3"):
            Transcript(node, time.monotonic(), {"fake-robot": ended}).run()
    finally:
        ended.wait()
        node.destroy_node()


def test_arguments_that_ros_would_ignore_are_refused():
    command = [sys.executable, "-m", "graspless", "ros", "node", "-p", "jobs:=2"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 2
    assert "ros: -p: unknown argument: those of ROS come after --ros-args" in done.stderr


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("max_velocty", "parameter max_velocty: unknown; did you mean 'max_velocity'?"),
        ("arm.joint", "parameter arm.joint: unknown; did you mean 'arm.joints'?"),
        ("colour", ""),  # a warning: files of parameters can be for many nodes
    ],
)
def test_a_misspelt_parameter_is_an_error(alone, name, reason):
    given = {"controllers": ["arm"], "arm.joints": ["a"], name: 1.0}
    overrides = [Parameter(each, value=value) for each, value in given.items()]
    node = rclpy.create_node("misspelt", context=alone.context, parameter_overrides=overrides)
    settings.declare(node)
    with pytest.raises(TaskError, match=re.escape(reason)) if reason else nullcontext():
        settings.read(node)
    node.destroy_node()


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("controllers: []", "parameter controllers: []: should name a controller, or be left out"),
        (
            "{controllers: [arm], arm: {joints: []}}",
            "parameter arm.joints: []: should name the joints of this controller",
        ),
    ],
)
def test_an_empty_list_is_told(alone, tmp_path, text, reason):
    file = tmp_path / "node.yaml"
    file.write_text(f"/**:\n  ros__parameters:\n    {text}\n")
    arguments = ["--ros-args", "--params-file", str(file)]
    node = rclpy.create_node("empty", context=alone.context, cli_args=arguments)
    settings.declare(node)
    try:
        with pytest.raises(TaskError, match=re.escape(reason)):
            settings.read(node)
    finally:
        node.destroy_node()


def test_a_parameter_of_another_type_is_told(alone, capfd):
    overrides = [Parameter("controllers", value=["arm"]), Parameter("arm.joints", value="elbow")]
    node = GrasplessNode(context=alone.context, parameter_overrides=overrides)
    try:
        assert not node.start()
    finally:
        node.destroy_node()
    assert "'arm.joints' to 'elbow'" in capfd.readouterr().err


def test_a_goal_that_comes_while_the_desk_closes_is_refused():
    desk = Desk(workers=None, jobs=1, queue=1)
    desk.close()
    goal = Goal(handle=None, began=0.0, tell=lambda *_: None)
    goal.wakes = lambda: None
    desk.take(goal, job=None, mover=None)
    ending = goal.future.result()
    assert (ending.status, ending.reason) == ("refused", "the node is shutting down")
    assert desk.size == 0
