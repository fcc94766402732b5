# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many goals, cancels and killed clients against a node in a process of its own: -m long.

GRASPLESS_STRESS=1000 sends so many goals, cancels three of ten, and kills one client per hundred.
"""

import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter

import numpy as np
import pytest
import rclpy
import yaml
from diagnostic_msgs.msg import DiagnosticArray
from graspless_msgs.action import PlanTask
from rclpy.action import ActionClient
from rig import TASK

from graspless.ros.demo import process

GOALS = int(os.environ.get("GRASPLESS_STRESS", "50"))
FEW = yaml.safe_dump(yaml.safe_load(TASK) | {"budget": {"iterations": 1}})
LID = {"name": "lid", "box": [0.9, 0.9, 0.02], "pose": {"position": [0.65, 0.0, 0.05]}}
SLOW = yaml.safe_dump(yaml.safe_load(TASK) | {"obstacles": [LID]})
CLIENT = """
import sys, time, rclpy
from graspless_msgs.action import PlanTask
from rclpy.action import ActionClient
rclpy.init()
node = rclpy.create_node("victim")
client = ActionClient(node, PlanTask, "plan_task")
assert client.wait_for_server(20)
for _ in range(3):
    rclpy.spin_until_future_complete(node, client.send_goal_async(PlanTask.Goal(task=sys.argv[1])))
print("sent", flush=True)
time.sleep(60)
"""


class Crowd:
    """A client with many goals at a time."""

    def __init__(self, node):
        self.node = node
        self.client = ActionClient(node, PlanTask, "plan_task")
        self.random = random.Random(1)
        self.sent = self.open = 0
        self.ends, self.statuses = Counter(), Counter()
        self.waits, self.cancels = [], []
        self.counts = {}
        node.create_subscription(DiagnosticArray, "/diagnostics", self.hear, 10)

    def hear(self, message):
        for status in message.status:
            if status.name.endswith(": goals"):
                self.counts = {pair.key: pair.value for pair in status.values}

    def send(self, k):
        cancels = k % 10 in (2, 5, 8)
        task = SLOW if cancels else TASK if k % 10 == 0 else FEW
        self.sent += 1
        self.open += 1
        times = {"sent": time.monotonic()}
        future = self.client.send_goal_async(PlanTask.Goal(task=task, seed=1 + k))
        future.add_done_callback(lambda f: self.accepted(k, f.result(), cancels, times))

    def accepted(self, k, handle, cancels, times):
        assert handle.accepted
        handle.get_result_async().add_done_callback(lambda f: self.ended(k, f.result(), times))
        if cancels:
            delay = self.random.uniform(0.0, 0.1)
            timer = self.node.create_timer(delay, lambda: self.cancel(handle, timer, times))

    def cancel(self, handle, timer, times):
        if "canceled" not in times:
            times["canceled"] = time.monotonic()
            timer.cancel()
            self.node.destroy_timer(timer)
            handle.cancel_goal_async()

    def ended(self, k, answer, times):
        now = time.monotonic()
        self.open -= 1
        self.ends[k] += 1
        self.statuses[answer.result.motion.status] += 1
        if "canceled" in times:
            self.cancels.append(now - times["canceled"])
        else:
            self.waits.append(now - times["sent"])


def memory(pid):
    """Resident memory of a process [MB]."""
    with open(f"/proc/{pid}/status") as file:
        return next(int(line.split()[1]) / 1024 for line in file if line.startswith("VmRSS"))


def kill_a_client():
    """Starts a client, and kills it when its goals are under way."""
    client = subprocess.Popen([sys.executable, "-c", CLIENT, SLOW], stdout=subprocess.PIPE)
    assert client.stdout.readline() == b"sent\n"
    client.send_signal(signal.SIGKILL)
    client.wait()
    client.stdout.close()


@pytest.mark.long
def test_no_goal_is_lost_and_none_ends_twice():
    context = rclpy.Context()
    rclpy.init(context=context, domain_id=int(os.environ["ROS_DOMAIN_ID"]) + 100)
    node = rclpy.create_node("crowd", context=context)
    executor = rclpy.executors.SingleThreadedExecutor(context=context)
    executor.add_node(node)
    before = os.environ["ROS_DOMAIN_ID"]
    os.environ["ROS_DOMAIN_ID"] = str(int(before) + 100)
    try:
        with process("node", "-p", "queue:=1000") as running:
            crowd = Crowd(node)
            assert crowd.client.wait_for_server(60)
            begin = run(crowd, executor, running.pid)
            end = memory(running.pid)
    finally:
        os.environ["ROS_DOMAIN_ID"] = before
        executor.shutdown()
        node.destroy_node()
        rclpy.shutdown(context=context)
    report(crowd, begin, end)
    assert set(crowd.ends) == set(range(GOALS))
    assert set(crowd.ends.values()) == {1}
    assert int(crowd.counts["faults_in_callbacks"]) == 0
    assert crowd.statuses["canceled"] >= len(crowd.cancels)  # others were cancelled, too
    assert end - begin < 30


def run(crowd, executor, pid):
    """Sends all goals, ten at a time; returns the memory after the first tenth [MB]."""
    begin, victims = 0.0, 0
    end = time.monotonic() + 60 + 2 * GOALS
    while crowd.open or crowd.sent < GOALS:
        assert time.monotonic() < end, (crowd.sent, crowd.open)
        if crowd.open < 10 and crowd.sent < GOALS:
            crowd.send(crowd.sent)
        if crowd.sent >= GOALS // 10 and not begin:
            begin = memory(pid)
        if victims < max(1, GOALS // 100) and crowd.sent > (victims + 0.5) * min(GOALS, 100):
            victims += 1
            kill_a_client()
            cancel_all(crowd, executor)
        executor.spin_once(timeout_sec=0.01)
    for _ in range(200):
        executor.spin_once(timeout_sec=0.01)
    return begin


def cancel_all(crowd, executor):
    """Cancels the goals of clients that are gone, as anybody can, and those that are under way."""
    from action_msgs.srv import CancelGoal

    service = crowd.node.create_client(CancelGoal, "plan_task/_action/cancel_goal")
    assert service.wait_for_service(20)
    future = service.call_async(CancelGoal.Request())
    executor.spin_until_future_complete(future, 20)
    assert future.result().goals_canceling
    crowd.node.destroy_client(service)


def report(crowd, begin, end):
    milliseconds = 1000 * np.array(crowd.cancels)
    lost, double = GOALS - len(crowd.ends), sum(n > 1 for n in crowd.ends.values())
    print(f"\n{GOALS} goals: {lost} lost, {double} with two ends; {dict(crowd.statuses)}")
    median, most = np.median(milliseconds), milliseconds.max()
    within = int((milliseconds < 50).sum())
    print(
        f"{len(milliseconds)} cancels: median {median:.1f} ms, largest {most:.0f} ms, {within} within 50 ms"
    )
    waits = np.array(crowd.waits)
    print(
        f"others: median {np.median(waits):.2f} s, largest {waits.max():.2f} s with ten at a time"
    )
    print(f"memory of the node: {begin:.1f} MB after a tenth, {end:.1f} MB at the end")
    print(f"diagnostics: {crowd.counts}")
