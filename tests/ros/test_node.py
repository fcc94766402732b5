# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Goals that are planned: results, refusals, cancellation, preemption, and planners that die."""

import json
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import yaml
from action_msgs.msg import GoalStatus
from action_msgs.srv import CancelGoal
from graspless_msgs.action import PlanTask
from graspless_msgs.srv import CheckPlan
from rclpy.serialization import serialize_message
from rig import EXAMPLES, TASK

import graspless
from graspless.plan_files import read_plan
from graspless.ros.results import Kept, bytes_of

DONE, CANCELED, ABORTED = (
    GoalStatus.STATUS_SUCCEEDED,
    GoalStatus.STATUS_CANCELED,
    GoalStatus.STATUS_ABORTED,
)


def slow():
    """A goal for which the search ends at its time limit: the hand cannot pass above the table."""
    task = yaml.safe_load(TASK)
    lid = {"name": "lid", "box": [0.9, 0.9, 0.02], "pose": {"position": [0.65, 0.0, 0.05]}}
    return PlanTask.Goal(task=yaml.safe_dump(task | {"obstacles": [lid]}), seconds=30.0)


def test_plans_a_task(bus):
    phases = []
    goal = PlanTask.Goal(task=TASK, seed=1)
    status, result = bus.do(goal, lambda message: phases.append(message.feedback.phase))
    motion = result.motion
    assert (status, motion.status, motion.reason) == (DONE, "solved", "")
    assert phases == ["reading", "planning", "checking", "timing"]
    here = graspless.plan(EXAMPLES / "01_slide_card.yaml", seed=1).to_json()
    there, here = json.loads(motion.plan), json.loads(here)
    assert there.pop("stats").keys() == here.pop("stats").keys()  # they have times
    assert there == here
    assert {margin.name for margin in motion.margins} == {"overhang"}
    assert motion.object_poses.header.frame_id == "world"
    assert not bus.rig.heard  # nothing was moved


def test_splits_the_motion_by_controllers(bus):
    motion = bus.do(PlanTask.Goal(task=TASK, seed=1))[1].motion
    assert list(motion.controllers) == ["arm", "hand"]
    plan = read_plan(motion.plan, "plan")
    joints = [name for trajectory in motion.trajectories for name in trajectory.joint_names]
    assert sorted(joints) == sorted(plan.joint_names)
    times = {
        tuple((p.time_from_start.sec, p.time_from_start.nanosec) for p in each.points)
        for each in motion.trajectories
    }
    assert len(times) == 1
    assert len(times.pop()) == len(motion.object_poses.poses)
    start = dict(zip(plan.joint_names, plan.segments[0].positions[0], strict=True))
    for each in motion.trajectories:
        np.testing.assert_allclose(each.points[0].positions, [start[n] for n in each.joint_names])
        assert not any(each.points[0].velocities)


def test_squeezes_after_closing(bus):
    motion = bus.do(PlanTask.Goal(task=TASK, seed=1))[1].motion
    plan = read_plan(motion.plan, "plan")
    hand = motion.trajectories[1]
    k = plan.joint_names.index(hand.joint_names[0])
    assert abs(hand.points[-1].positions[0] - plan.segments[-1].positions[-1][k]) > 0.1


@pytest.mark.parametrize(
    ("task", "reason"),
    [
        ("", "task"),
        ("[1, 2", "task"),
        ("kind: juggle", "kind"),
        ("kind: slide", "robot"),
        (TASK.replace("urdf: ", "urdf: no_such_"), "no such file, nor a robot"),
        (TASK.replace("urdf: wam_t42", "urdf: robot_description"), "none was received yet"),
        ("x" * 100000, "task"),
        (TASK + "\nnonsense: 1\n", "nonsense"),
        ("kind: slide\nobject: .nan\n", "task"),
    ],
)
def test_refuses_tasks_that_are_none(bus, task, reason):
    status, result = bus.do(PlanTask.Goal(task=task))
    assert status == ABORTED
    assert result.motion.status == "refused"
    assert reason in result.motion.reason
    assert result.motion.reason


@pytest.mark.parametrize("seconds", [float("nan"), float("inf"), -1.0])
def test_refuses_times_that_are_none(bus, seconds):
    motion = bus.do(PlanTask.Goal(task=TASK, seconds=seconds))[1].motion
    assert motion.status == "refused"
    assert "seconds" in motion.reason


def test_no_plan_is_a_status_with_a_reason(bus):
    task = yaml.safe_load(TASK)
    task["options"] = task.get("options", {})
    motion = bus.do(PlanTask.Goal(task=yaml.safe_dump(task), seconds=1e-3, seed=3))[1].motion
    assert motion.status not in ("solved", "executed", "")
    assert motion.reason
    assert not motion.trajectories


def test_checks_a_plan(bus):
    text = bus.do(PlanTask.Goal(task=TASK, seed=1))[1].motion.plan
    answer = bus.wait(bus.check_plan.call_async(CheckPlan.Request(plan=text)))
    assert answer.holds
    assert not answer.faults
    document = json.loads(text)
    document["segments"][1]["positions"][2][0] += 0.5
    asked = CheckPlan.Request(plan=json.dumps(document))
    answer = bus.wait(bus.check_plan.call_async(asked))
    assert not answer.holds
    assert answer.faults
    answer = bus.wait(bus.check_plan.call_async(CheckPlan.Request(plan="no plan")))
    assert not answer.holds
    assert answer.reason


def test_cancels_within_50_ms(bus):
    waits = []
    for _ in range(5):
        handle = bus.send(slow())
        time.sleep(0.1)
        began = time.monotonic()
        future = handle.get_result_async()
        bus.wait(handle.cancel_goal_async())
        answer = bus.wait(future)
        waits.append(time.monotonic() - began)
        assert answer.status == CANCELED
        assert answer.result.motion.status == "canceled"
        assert "client" in answer.result.motion.reason
    assert min(waits) < 0.05, waits  # others wait for the machine


def test_cancels_twice_and_after_the_end(bus):
    handle = bus.send(slow())
    first, second = handle.cancel_goal_async(), handle.cancel_goal_async()
    assert bus.result(handle)[0] == CANCELED
    assert bus.wait(first).return_code == 0
    bus.wait(second)
    bus.wait(handle.cancel_goal_async())
    assert bus.result(handle)[1].motion.status == "canceled"


def test_cancels_goals_that_wait(bus):
    first, second = bus.send(slow()), bus.send(slow())
    bus.wait(second.cancel_goal_async())
    assert bus.result(second)[0] == CANCELED
    assert first.status != CANCELED
    bus.wait(first.cancel_goal_async())
    assert bus.result(first)[0] == CANCELED


def test_preempts(bus):
    first, second = bus.send(slow()), bus.send(slow())
    status, result = bus.do(PlanTask.Goal(task=TASK, seed=1, preempt=True))
    assert (status, result.motion.status) == (DONE, "solved")
    for handle in (first, second):
        status, result = bus.result(handle)
        assert (status, result.motion.status) == (ABORTED, "preempted")
        assert "another goal" in result.motion.reason


def test_refuses_more_goals_than_the_queue_holds(bus):
    handles = [bus.send(slow()) for _ in range(bus.node.settings.queue)]
    motion = bus.do(PlanTask.Goal(task=TASK))[1].motion
    assert motion.status == "refused"
    assert "queue" in motion.reason
    for handle in handles:
        handle.cancel_goal_async()
    assert {bus.result(handle)[0] for handle in handles} == {CANCELED}


def worker():
    """Process id of the worker that is planning."""
    own, found = str(os.getpid()), []
    for entry in os.listdir("/proc"):
        try:
            with open(f"/proc/{entry}/stat") as file:
                fields = file.read().rpartition(")")[2].split()
            with open(f"/proc/{fields[1]}/stat") as file:
                grandparent = file.read().rpartition(")")[2].split()[1]
        except (OSError, IndexError):
            continue
        if grandparent == own:
            found.append(int(entry))
    return found


def test_survives_a_planner_that_dies(bus):
    handle = bus.send(slow())
    bus.until(lambda: len(worker()) == 1)
    os.kill(worker()[0], signal.SIGKILL)
    status, result = bus.result(handle)
    assert (status, result.motion.status) == (ABORTED, "crashed")
    assert "died" in result.motion.reason
    assert bus.do(PlanTask.Goal(task=TASK, seed=1))[1].motion.status == "solved"


CLIENT = """
import sys, time, rclpy
from graspless_msgs.action import PlanTask
from rclpy.action import ActionClient
rclpy.init()
node = rclpy.create_node("victim")
client = ActionClient(node, PlanTask, "plan_task")
assert client.wait_for_server(20)
goal = PlanTask.Goal(task=sys.argv[1], seconds=30.0)
rclpy.spin_until_future_complete(node, client.send_goal_async(goal))
print("sent", flush=True)
time.sleep(60)
"""


def test_the_goal_of_a_killed_client_goes_on_and_others_can_cancel_it(bus):
    command = [sys.executable, "-c", CLIENT, slow().task]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as client:
        assert client.stdout.readline() == b"sent\n"
        client.kill()
    bus.settle()
    assert bus.node.desk.size == 1
    before = bus.node.desk.counts.get("canceled", 0)
    service = bus.client.create_client(CancelGoal, "plan_task/_action/cancel_goal")
    assert service.wait_for_service(20)
    answer = bus.wait(service.call_async(CancelGoal.Request()))
    bus.client.destroy_client(service)
    assert len(answer.goals_canceling) == 1
    bus.until(lambda: bus.node.desk.size == 0)
    assert bus.node.desk.counts["canceled"] == before + 1


def test_the_oldest_results_lose_their_motions(bus):
    results = [bus.do(PlanTask.Goal(task=TASK, seed=1))[1] for _ in range(3)]
    size = bytes_of(results[0].motion)
    assert size == pytest.approx(len(serialize_message(results[0])), rel=0.1)
    kept = Kept(int(2.5 * size))
    for result in results:
        kept.add(result.motion)
    assert [bool(result.motion.plan) for result in results] == [False, True, True]
    motion = results[0].motion
    assert bytes_of(motion) == 0
    assert (motion.status, len(motion.margins)) == ("solved", 1)
    assert "not kept" in motion.warnings[-1]
    Kept(1).add(results[1].motion)  # the newest one is kept however large it is
    assert results[1].motion.plan


def test_an_inactive_node_refuses(bus):
    assert bus.node.trigger_deactivate()
    try:
        motion = bus.do(PlanTask.Goal(task=TASK))[1].motion
        assert (motion.status, motion.reason) == ("refused", "the node is not active")
    finally:
        bus.node.trigger_activate()
