# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Execution: both controllers at the same time, and everything that can go wrong there."""

import time
from contextlib import nullcontext

import numpy as np
import pytest
import yaml
from action_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseWithCovarianceStamped
from graspless_msgs.action import PlanTask
from rclpy.action import ActionClient
from rig import EXAMPLES, PATIENCE, TASK
from sensor_msgs.msg import JointState

import graspless
from graspless.ros.controllers import turns_at_start
from graspless.ros.jobs import Found
from graspless.ros.measured import Joint
from graspless.ros.messages import RefusedError, pose_of, seconds_of, time_of
from graspless.ros.senses import Joints
from graspless.ros.settings import Settings

DONE, CANCELED, ABORTED = (
    GoalStatus.STATUS_SUCCEEDED,
    GoalStatus.STATUS_CANCELED,
    GoalStatus.STATUS_ABORTED,
)


def goal(**given):
    return PlanTask.Goal(task=TASK, seed=1, execute=True, **given)


def moved(bus):
    """Largest distance of a joint from home."""
    return max(abs(bus.rig.q[name] - bus.rig.home[name]) for name in bus.rig.q)


def test_both_controllers_follow_at_the_same_time(bus):
    phases = []
    status, result = bus.do(goal(), lambda message: phases.append(message.feedback.phase))
    motion = result.motion
    assert (status, motion.status, motion.reason) == (DONE, "executed", "")
    assert sorted(group for group, _ in bus.rig.heard) == ["arm", "hand"]
    stamps = {seconds_of(trajectory.header.stamp) for _, trajectory in bus.rig.heard}
    assert len(stamps) == 1
    for group, trajectory in bus.rig.heard:
        assert list(trajectory.joint_names) == bus.given[group]["joints"]
        last = dict(zip(trajectory.joint_names, trajectory.points[-1].positions, strict=True))
        for name, value in last.items():
            assert bus.rig.q[name] == pytest.approx(value, abs=1e-6)
    assert phases[:4] == ["reading", "planning", "checking", "timing"]
    assert phases[4:6] == ["approach", "press"]
    assert phases[-1] == "close"


def test_plans_from_the_measured_joints(bus):
    name = bus.given["arm"]["joints"][0]
    with bus.rig.lock:
        bus.rig.q[name] += 0.2
    bus.settle()
    motion = bus.do(goal())[1].motion
    assert motion.status == "executed", motion.reason
    arm = next(trajectory for group, trajectory in bus.rig.heard if group == "arm")
    start = dict(zip(arm.joint_names, arm.points[0].positions, strict=True))
    assert start[name] == pytest.approx(bus.rig.home[name] + 0.2, abs=1e-6)


def test_plans_from_a_joint_that_is_just_beyond_its_limit(bus):
    name = bus.given["hand"]["joints"][0]  # it is open at its lower limit, 0
    with bus.rig.lock:
        bus.rig.q[name] = -0.01
    bus.settle()
    motion = bus.do(goal())[1].motion
    assert motion.status == "executed", motion.reason
    with bus.rig.lock:
        bus.rig.q[name] = -0.1
    bus.settle()
    motion = bus.do(goal())[1].motion
    assert motion.status == "refused"
    assert f"{name}' is -0.1, outside its limits" in motion.reason


@pytest.fixture
def endless(tmp_path):
    """The task for a robot whose first joint is continuous, and that has a wheel."""
    urdf = graspless.robot.builtin("wam_t42")
    text = urdf.read_text().replace('wam_joint_1" type="revolute', 'wam_joint_1" type="continuous')
    wheel = '<link name="wheel"/><joint name="roll" type="continuous"><parent link="base_link"/>'
    text = text.replace("</robot>", wheel + '<child link="wheel"/></joint></robot>')
    (tmp_path / "wam.urdf").write_text(text)
    task = yaml.safe_load(TASK)
    task["robot"] |= {"urdf": str(tmp_path / "wam.urdf"), "directory": str(urdf.parent)}
    task["robot"]["srdf"] = str(urdf.with_suffix(".srdf"))
    return task


@pytest.mark.parametrize("closed_loop", [False, True])
def test_continuous_joints_may_have_made_whole_turns(bus, endless, closed_loop):
    start = bus.rig.home["wam_joint_1"] + 4 * np.pi
    endless["robot"]["home"] = {"wam_joint_1": bus.rig.home["wam_joint_1"]}  # is the same
    sent = bus.rig.streamed if closed_loop else bus.rig.heard
    try:
        with bus.rig.lock:
            bus.rig.q |= {"wam_joint_1": start, "roll": 137.2}
        bus.settle()
        given = {"seed": 1, "execute": True, "closed_loop": closed_loop}
        handle = bus.send(PlanTask.Goal(task=yaml.safe_dump(endless), **given))
        bus.until(lambda: len(sent) > (5 if closed_loop else 1), "nothing was sent")
        bus.wait(handle.cancel_goal_async())
        reason = bus.result(handle)[1].motion.reason
        assert "wam_joint_1" not in reason  # the follower compares without turns
        arm = [trajectory for group, trajectory in sent if group == "arm"]
        assert arm[0].points[0].positions[0] == pytest.approx(start, abs=0.01)
        assert abs(arm[-1].points[-1].positions[0] - start) < np.pi
    finally:
        with bus.rig.lock:
            del bus.rig.q["roll"]


def test_mimic_joints_of_a_controller_move_as_their_drivers(bus):
    fingers = ["left_finger_joint", "right_finger_joint"]
    node = bus.another_node("fingers", changes={"hand.joints": fingers})
    client = ActionClient(bus.client, PlanTask, "/fingers/plan_task")
    assert client.wait_for_server(PATIENCE)
    try:
        with bus.rig.lock:
            bus.rig.q["right_finger_joint"] = 0.0
        bus.settle()
        motion = bus.wait(bus.wait(client.send_goal_async(goal())).get_result_async()).result.motion
        assert motion.status == "executed", motion.reason
        followed = next(each for group, each in bus.rig.heard if group == "hand")
        for hand in (followed, motion.trajectories[1]):
            assert list(hand.joint_names) == fingers
            for name in ("positions", "velocities", "accelerations"):
                rows = np.array([getattr(point, name) for point in hand.points])
                assert np.ptp(rows[:, 0]) > 0.1
                np.testing.assert_array_equal(rows[:, 1], rows[:, 0])
    finally:
        with bus.rig.lock:
            del bus.rig.q["right_finger_joint"]
        bus.wait(bus.executors[1].create_task(node.trigger_shutdown))  # it takes time of the other


def test_refuses_a_robot_that_is_elsewhere(bus):
    task = yaml.safe_load(TASK)
    task["robot"]["home"] = "home"  # so it is not planned from where the robot is
    with bus.rig.lock:
        bus.rig.q[bus.given["arm"]["joints"][1]] += 0.5
    bus.settle()
    status, result = bus.do(PlanTask.Goal(task=yaml.safe_dump(task), seed=1, execute=True))
    assert (status, result.motion.status) == (ABORTED, "refused")
    assert "not at the start" in result.motion.reason
    assert not bus.rig.heard


@pytest.mark.parametrize(("off", "is_there"), [(0.004, True), (0.006, False)])
def test_sliding_joints_start_within_a_tenth_of_the_tolerance(off, is_there):
    joint = Joint(is_continuous=False, weight=10.0, driver="finger", multiplier=1.0, offset=0.0)
    found = Found(joint_names=["finger"], joints={"finger": joint}, positions=np.zeros((2, 1)))
    joints = Joints(lambda: 0.0)
    joints.hear(JointState(name=["finger"], position=[off]))
    reason = "finger is 0.006 and should be 0.000"
    with nullcontext() if is_there else pytest.raises(RefusedError, match=reason):
        turns_at_start(found, joints, Settings())


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_refuses_joint_states_that_are_no_numbers(bus, value):
    bus.rig.corrupt = {bus.given["arm"]["joints"][2]: value}
    bus.settle()
    motion = bus.do(goal())[1].motion
    assert motion.status == "refused"
    assert bus.given["arm"]["joints"][2] in motion.reason
    assert not bus.rig.heard


def test_refuses_joint_states_that_are_old(bus):
    bus.rig.is_silent = True
    bus.settle(0.7)  # 14 s of the robot's clock
    motion = bus.do(goal())[1].motion
    assert motion.status == "refused"
    assert "s old" in motion.reason
    assert not bus.rig.heard


def test_a_rejected_trajectory_cancels_the_other(bus):
    bus.rig.behaviour["hand"] = "reject"
    motion = bus.do(goal())[1].motion
    assert motion.status == "controller_failed"
    assert "hand rejected" in motion.reason
    bus.until(lambda: not bus.rig.orders, "the arm goes on")
    assert moved(bus) == 0  # it was cancelled before its start


def test_a_controller_that_aborts_half_way_stops_the_other(bus):
    bus.rig.behaviour["arm"] = "abort"
    motion = bus.do(goal())[1].motion
    assert motion.status == "controller_failed"
    assert "arm did not finish: hit something" in motion.reason
    assert not bus.rig.orders
    place = dict(bus.rig.q)
    bus.settle()
    assert bus.rig.q == place


def test_cancelling_stops_both(bus):
    handle = bus.send(goal())
    bus.until(lambda: moved(bus) > 0.05, "nothing moved")
    began = time.monotonic()
    bus.wait(handle.cancel_goal_async())
    status, result = bus.result(handle)
    assert (status, result.motion.status) == (CANCELED, "canceled")
    assert "confirm" not in result.motion.reason
    assert not bus.rig.orders
    assert time.monotonic() - began < 0.5
    place = dict(bus.rig.q)
    bus.settle()
    assert bus.rig.q == place


def test_says_if_a_controller_does_not_stop(bus):
    bus.rig.behaviour["hand"] = "deaf"
    handle = bus.send(goal())
    bus.until(lambda: len(bus.rig.heard) == 2)
    bus.settle()
    bus.wait(handle.cancel_goal_async())
    motion = bus.result(handle)[1].motion
    assert motion.status == "canceled"
    assert "hand did not confirm that it stopped" in motion.reason


def test_a_trajectory_that_never_ends_is_stopped(bus):
    bus.rig.behaviour["hand"] = "stuck"
    motion = bus.do(goal())[1].motion
    assert motion.status == "stopped"
    assert "not done" in motion.reason
    assert not bus.rig.orders


def test_stops_when_the_joint_states_are_lost(bus):
    handle = bus.send(goal())
    bus.until(lambda: moved(bus) > 0.05, "nothing moved")
    bus.rig.corrupt = {bus.given["arm"]["joints"][0]: float("nan")}
    motion = bus.result(handle)[1].motion
    assert motion.status == "stopped"
    assert bus.given["arm"]["joints"][0] in motion.reason
    assert not bus.rig.orders


def test_stops_when_time_jumps_back(bus):
    handle = bus.send(goal())
    bus.until(lambda: moved(bus) > 0.05, "nothing moved")
    with bus.rig.lock:
        bus.rig.t -= 100.0
    motion = bus.result(handle)[1].motion
    assert motion.status == "stopped"
    assert "time has jumped back" in motion.reason
    assert not bus.rig.orders
    bus.settle()
    bus.rest()
    assert bus.do(goal())[1].motion.status == "executed"


def test_one_goal_at_a_time_moves_the_robot(bus):
    first = bus.send(goal())
    bus.until(lambda: bus.rig.orders, "nothing moved")
    second = bus.do(goal())[1].motion
    if bus.rig.orders:
        assert second.status == "refused"
        assert "another goal" in second.reason or "start" in second.reason
    assert bus.result(first)[1].motion.status == "executed"


def test_a_goal_can_preempt_the_motion(bus):
    first = bus.send(goal())
    bus.until(lambda: moved(bus) > 0.05, "nothing moved")
    assert bus.do(PlanTask.Goal(task=TASK, seed=1, preempt=True))[1].motion.status == "solved"
    assert bus.result(first)[1].motion.status == "preempted"
    assert not bus.rig.orders


def test_a_goal_that_preempts_starts_where_the_motion_has_stopped(bus):
    bus.rig.behaviour["arm"] = "coast"
    first = bus.send(goal())
    bus.until(lambda: moved(bus) > 0.05, "nothing moved")
    motion = bus.do(goal(preempt=True))[1].motion
    assert (motion.status, motion.reason) == ("executed", "")
    motion = bus.result(first)[1].motion
    assert motion.status == "preempted"
    assert "confirm" not in motion.reason
    assert bus.rig.coast == 0


def test_deactivating_stops_the_robot(bus):
    handle = bus.send(goal())
    bus.until(lambda: moved(bus) > 0.05, "nothing moved")
    bus.node.trigger_deactivate()
    try:
        motion = bus.result(handle)[1].motion
        assert motion.status == "stopped"
        assert "deactivated" in motion.reason
        assert not bus.rig.orders
    finally:
        bus.node.trigger_activate()


def test_shutting_down_stops_the_robot_and_ends_the_goals(bus):
    node = bus.another_node("ending")
    client = ActionClient(bus.client, PlanTask, "/ending/plan_task")
    assert client.wait_for_server(PATIENCE)
    result = bus.wait(client.send_goal_async(goal())).get_result_async()
    bus.until(lambda: moved(bus) > 0.05, "nothing moved")
    bus.wait(bus.executors[1].create_task(node.trigger_shutdown))
    motion = bus.wait(result, "result").result.motion
    assert (motion.status, motion.reason) == ("stopped", "the node is shutting down")
    assert not bus.rig.orders
    bus.until(lambda: not client.server_is_ready(), "the action is still served")
    assert node.faults == 0


def test_follows_a_slide_in_closed_loop(bus):
    """Nobody measures the object: the plan is followed blindly."""
    motion = bus.do(goal(closed_loop=True))[1].motion
    assert motion.status == "executed", motion.reason
    assert {group for group, _ in bus.rig.streamed} == {"arm", "hand"}
    assert not bus.rig.heard
    arm = [trajectory for group, trajectory in bus.rig.streamed if group == "arm"]
    rows = np.array([trajectory.points[0].positions for trajectory in arm])
    assert np.abs(np.diff(rows, axis=0)).max() < 0.3  # the plan moves a joint by 2.3 rad/s
    assert not any(arm[-1].points[0].velocities)


def object_pose():
    """The card where it is at the start."""
    X_WO = graspless.load_task(EXAMPLES / "01_slide_card.yaml").problem.X_WO_start
    message = PoseWithCovarianceStamped()
    message.header.frame_id, message.pose.pose = "world", pose_of(X_WO)
    return message


def test_closed_loop_stops_when_the_object_is_not_seen_any_more(bus):
    phases = []
    handle = bus.send(goal(closed_loop=True), lambda message: phases.append(message.feedback.phase))
    message = object_pose()
    end = time.monotonic() + 20
    while "slide" not in phases and time.monotonic() < end:
        message.header.stamp = time_of(bus.rig.t)
        bus.poses.publish(message)
        time.sleep(0.005)
    motion = bus.result(handle)[1].motion
    assert motion.status == "stopped"
    assert "pose" in motion.reason
    arm = [trajectory for group, trajectory in bus.rig.streamed if group == "arm"]
    assert not any(arm[-1].points[0].velocities)


@pytest.mark.parametrize(
    ("spoil", "reason"),
    [
        (lambda m: setattr(m.pose.pose.position, "x", float("nan")), "not finite"),
        (lambda m: setattr(m.pose.pose.orientation, "w", 0.0), "quaternion of norm 0"),
        (lambda m: m.pose.covariance.__setitem__(0, float("nan")), "covariance"),
        (lambda m: m.pose.covariance.__setitem__(0, -1.0), "covariance"),
        (lambda m: setattr(m.header, "frame_id", "moon"), "'moon'"),
        (lambda m: setattr(m.header, "frame_id", ""), "names no frame"),
    ],
)
def test_closed_loop_uses_no_pose_that_cannot_be_trusted(bus, spoil, reason):
    """Such poses count as none: the slide is followed blindly, as it was planned."""
    refused = bus.node.poses.refused
    message = object_pose()
    spoil(message)
    handle = bus.send(goal(closed_loop=True))
    future = handle.get_result_async()
    while not future.done():
        message.header.stamp = time_of(bus.rig.t)
        bus.poses.publish(message)
        bus.settle(0.02)
    assert future.result().result.motion.status == "executed"
    assert bus.node.poses.refused > refused
    assert reason in bus.node.poses.reason


@pytest.mark.parametrize("when", ["slide", "squeeze"])
def test_closed_loop_stops_when_time_jumps_back(bus, when):
    handle = bus.send(goal(closed_loop=True))
    if when == "slide":
        bus.until(lambda: moved(bus) > 0.05, "nothing moved")
    else:  # at the end, only the hand moves
        bus.until(lambda: squeezes(bus), "the hand does not close on")
    with bus.rig.lock:
        bus.rig.t -= 100.0
    motion = bus.result(handle)[1].motion
    assert (motion.status, motion.reason) == ("stopped", "time has jumped back")


def squeezes(bus):
    """True once the hand is farther closed than the plan closes it."""
    plan = graspless.plan(EXAMPLES / "01_slide_card.yaml", seed=1)
    end = dict(zip(plan.joint_names, plan.segments[-1].positions[-1], strict=True))
    begin = dict(zip(plan.joint_names, plan.segments[0].positions[0], strict=True))
    name = bus.given["hand"]["joints"][0]
    way = np.sign(end[name] - begin[name])
    return way * (bus.rig.q[name] - end[name]) > 0.02


def test_closed_loop_can_be_cancelled(bus):
    handle = bus.send(goal(closed_loop=True))
    bus.until(lambda: moved(bus) > 0.05, "nothing moved")
    bus.wait(handle.cancel_goal_async())
    status, result = bus.result(handle)
    assert (status, result.motion.status) == (CANCELED, "canceled")
    place = dict(bus.rig.q)
    bus.settle()
    assert bus.rig.q == place


def test_only_slides_are_followed(bus):
    task = (TASK.replace("01_slide_card", "")).replace("kind: slide", "kind: pinch")
    task = task.replace("[0.12, 0.08]", "[0.12, 0.03]").replace(
        "thickness: 0.003", "thickness: 0.05"
    )
    motion = bus.do(PlanTask.Goal(task=task, execute=True, closed_loop=True))[1].motion
    assert motion.status == "refused"
    assert "only slide plans can be followed" in motion.reason
    assert not bus.rig.streamed
