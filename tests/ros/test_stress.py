# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Many goals, cancels and killed clients against a node in a process of its own: -m long.

GRASPLESS_STRESS=1000 sends so many goals, cancels three of ten, and kills one client per hundred.
"""

import contextlib
import os
import pathlib
import random
import subprocess
import sys
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import rclpy
import yaml
from diagnostic_msgs.msg import DiagnosticArray
from graspless_msgs.action import PlanTask
from rclpy.action import ActionClient
from rclpy.qos import QoSProfile
from rig import TASK

from graspless.ros.demo import process
from graspless.ros.spinning import use_sockets

GOALS = int(os.environ.get("GRASPLESS_STRESS", "50"))
VICTIMS = max(1, GOALS // 100)
GROWTH = 30  # of the node's memory after the first tenth of the goals [MB]
FEW = yaml.safe_dump(yaml.safe_load(TASK) | {"budget": {"iterations": 1}})
MANY = QoSProfile(depth=1000)  # by default, ten answers to other clients push one's own out
LID = {"name": "lid", "box": [0.9, 0.9, 0.02], "pose": {"position": [0.65, 0.0, 0.05]}}
SLOW = yaml.safe_dump(yaml.safe_load(TASK) | {"obstacles": [LID]})
CLIENT = """
import sys, time, rclpy
from graspless_msgs.action import PlanTask
from rclpy.action import ActionClient
rclpy.init()
node = rclpy.create_node("victim")
many = rclpy.qos.QoSProfile(depth=1000)
client = ActionClient(node, PlanTask, "plan_task", goal_service_qos_profile=many)
assert client.wait_for_server(20)
for _ in range(3):
    answer = client.send_goal_async(PlanTask.Goal(task=sys.argv[1]))
    rclpy.spin_until_future_complete(node, answer, timeout_sec=20)
    assert answer.done()
print("sent", flush=True)
time.sleep(60)
"""


class Crowd:
    """A client with many goals at a time."""

    def __init__(self, node):
        self.node = node
        self.client = ActionClient(node, PlanTask, "plan_task", goal_service_qos_profile=MANY)
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
    """Starts a client, and kills it when its goals are under way; takes a second."""
    command = [sys.executable, "-c", CLIENT, SLOW]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as client:
        said = client.stdout.readline()
        client.kill()
    assert said == b"sent\n"


@contextlib.contextmanager
def crowded(*arguments):
    """A node in a process of its own and a Crowd, in a domain of their own."""
    domain = int(os.environ["ROS_DOMAIN_ID"])
    context = rclpy.Context()
    rclpy.init(context=context, domain_id=domain + 100)
    node = rclpy.create_node("crowd", context=context)
    executor = rclpy.executors.SingleThreadedExecutor(context=context)
    executor.add_node(node)
    os.environ["ROS_DOMAIN_ID"] = str(domain + 100)
    try:
        with process("node", *arguments) as running:
            crowd = Crowd(node)
            assert crowd.client.wait_for_server(60)
            yield crowd, executor, running.pid
    finally:
        os.environ["ROS_DOMAIN_ID"] = str(domain)
        executor.shutdown()
        node.destroy_node()
        rclpy.shutdown(context=context)


def test_the_node_has_no_shared_memory():
    """With it, the long test below hangs, or a client that follows a killed one gets no answer."""
    with crowded() as (_, _, pid), open(f"/proc/{pid}/maps") as file:
        assert "/dev/shm/fastdds_" not in file.read()


VARIABLES = (
    "ROS_AUTOMATIC_DISCOVERY_RANGE",
    "FASTDDS_BUILTIN_TRANSPORTS",
    "FASTDDS_DEFAULT_PROFILES_FILE",
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "ROS_STATIC_PEERS",
)


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ([None] * 5, [None, "UDPv4", None, None, None]),
        (["SUBNET", "", None, None, None], ["SUBNET", "UDPv4", None, None, None]),
        (["LOCALHOST", *[None] * 4], ["SYSTEM_DEFAULT", None, "localhost.xml", None, None]),
        (["LOCALHOST", *[None] * 3, "10.0.0.2"], ["LOCALHOST", "UDPv4", None, None, "10.0.0.2"]),
        (["LOCALHOST", "SHM", None, None, None], ["LOCALHOST", "SHM", None, None, None]),
        (["LOCALHOST", None, "mine.xml", None, None], ["LOCALHOST", None, "mine.xml", None, None]),
        ([None, None, None, "mine.xml", None], [None, None, None, "mine.xml", None]),
    ],
)
def test_the_node_speaks_udp_unless_the_user_has_configured_fast_dds(monkeypatch, given, expected):
    for name, value in zip(VARIABLES, given, strict=True):
        monkeypatch.setenv(name, "")  # so that it is restored
        monkeypatch.delenv(name) if value is None else monkeypatch.setenv(name, value)
    use_sockets()
    for name, value in zip(VARIABLES, expected, strict=True):
        found = os.environ.get(name)
        assert found == value or pathlib.Path(found).name == value


@pytest.mark.long
def test_no_goal_is_lost_and_none_ends_twice():
    with crowded("-p", "queue:=1000") as (crowd, executor, pid):
        curve = run(crowd, executor, pid)
    report(crowd, curve)
    assert set(crowd.ends) == set(range(GOALS))
    assert set(crowd.ends.values()) == {1}
    assert int(crowd.counts["faults_in_callbacks"]) == 0
    ends = sum(int(crowd.counts.get(status, 0)) for status in {*crowd.statuses, "canceled"})
    assert ends == GOALS + 3 * VICTIMS  # each goal has one end at the node, too
    assert crowd.statuses["canceled"] >= len(crowd.cancels)  # others were cancelled, too
    assert np.median(crowd.cancels) < 0.05
    assert max(curve[1:]) - curve[0] < GROWTH


def run(crowd, executor, pid):
    """Sends all goals, ten at a time; returns the memory after each tenth of them [MB]."""
    curve, victim, victims = [], None, 0
    killers = ThreadPoolExecutor(1)
    end = time.monotonic() + 60 + 2 * GOALS
    while crowd.open or victim or crowd.sent < GOALS:
        assert time.monotonic() < end, (crowd.sent, crowd.open)
        if crowd.open < 10 and crowd.sent < GOALS:
            crowd.send(crowd.sent)
        if crowd.sent >= (len(curve) + 1) * GOALS // 10:
            curve.append(memory(pid))
        if not victim and crowd.sent > (victims + 0.5) * GOALS / VICTIMS:
            victims += 1
            victim = killers.submit(kill_a_client)  # the crowd goes on meanwhile
        if victim and victim.done():
            victim.result()
            victim = None
            cancel_all(crowd, executor)
        executor.spin_once(timeout_sec=0.01)
    for _ in range(200):
        executor.spin_once(timeout_sec=0.01)
    return [*curve, memory(pid)]


def cancel_all(crowd, executor):
    """Cancels the goals of clients that are gone, as anybody can, and those that are under way."""
    from action_msgs.srv import CancelGoal

    service = crowd.node.create_client(CancelGoal, "plan_task/_action/cancel_goal")
    assert service.wait_for_service(20)
    future = service.call_async(CancelGoal.Request())
    executor.spin_until_future_complete(future, 20)
    assert future.result().goals_canceling
    crowd.node.destroy_client(service)


def report(crowd, curve):
    lost, double = GOALS - len(crowd.ends), sum(n > 1 for n in crowd.ends.values())
    print(f"\n{GOALS} goals: {lost} lost, {double} with two ends; {dict(crowd.statuses)}")
    waits = 1000 * np.array(crowd.cancels)
    p50, p99 = np.quantile(waits, [0.5, 0.99])
    print(
        f"{len(waits)} cancels: p50 {p50:.1f} ms, p99 {p99:.1f} ms, largest {waits.max():.0f} ms, "
        f"{(waits < 50).sum()} within 50 ms"
    )
    others = np.array(crowd.waits)
    print(f"others: p50 {np.median(others):.2f} s, largest {others.max():.2f} s, ten at a time")
    print(f"memory of the node after each tenth [MB]: {' '.join(f'{each:.0f}' for each in curve)}")
    print(f"diagnostics: {crowd.counts}")
