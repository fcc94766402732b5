# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot without physics that misbehaves on demand, a client, and the node, in one process."""

import pathlib
import threading
import time

import numpy as np
import rclpy
from control_msgs.action import FollowJointTrajectory
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from graspless_msgs.action import PickObject, PlanTask
from graspless_msgs.srv import CheckPlan
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_sensor_data
from rclpy.task import Future
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CameraInfo, Image, JointState, PointCloud2
from tf2_msgs.msg import TFMessage
from trajectory_msgs.msg import JointTrajectory

from graspless.ros.demo import parameters
from graspless.ros.messages import seconds_of, time_of
from graspless.ros.node import TF_STATIC, GrasplessNode
from graspless.ros.spinning import spin

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
TASK = (EXAMPLES / "01_slide_card.yaml").read_text()
GROUPS = ("arm", "hand")
_TICK = 0.005  # on the wall [s]
_COAST = 4  # ticks
PATIENCE = 30.0  # of the client [s]
_Result = FollowJointTrajectory.Result


class Rig(rclpy.node.Node):
    """Clock, joint states and controllers.

    behaviour of a controller: follow, reject, abort (half way), stuck (never ends, but can be
    cancelled), deaf (accepts, never ends, refuses to be cancelled), coast (goes on for a while after
    it was cancelled).
    """

    def __init__(self, given):
        super().__init__("rig")
        self.given = given
        self.t, self.pace, self.lock = 1000.0, 0.1, threading.RLock()
        self.q = {name: 0.0 for group in GROUPS for name in given[group]["joints"]}
        self.home = dict(self.q)
        self.behaviour = dict.fromkeys(GROUPS, "follow")
        self.is_silent, self.corrupt, self.lag, self.coast = False, {}, 0.0, _COAST
        self.orders, self.heard, self.streamed = {}, [], []
        self.clock_topic = self.create_publisher(Clock, "/clock", 1)
        self.states = self.create_publisher(JointState, "joint_states", qos_profile_sensor_data)
        self.servers = []
        for group in GROUPS:
            self.servers.append(
                ActionServer(
                    self,
                    FollowJointTrajectory,
                    given[group]["action"],
                    self._following(group),
                    goal_callback=self._accepting(group),
                    cancel_callback=self._cancelling(group),
                )
            )
            self.create_subscription(
                JointTrajectory, given[group]["topic"], self._streaming(group), 10
            )
        self.create_timer(_TICK, self.tick)

    def _accepting(self, group):
        return lambda _: (
            GoalResponse.REJECT if self.behaviour[group] == "reject" else GoalResponse.ACCEPT
        )

    def _cancelling(self, group):
        def answer(_):
            is_deaf = self.behaviour[group] == "deaf"
            return CancelResponse.REJECT if is_deaf else CancelResponse.ACCEPT

        return answer

    def _following(self, group):
        async def follow(handle):
            trajectory = handle.request.trajectory
            self.heard.append((group, trajectory))
            future = Future()
            self.orders[group] = (trajectory, handle, future)
            code = await future
            if code == "canceled":
                handle.canceled()
                return _Result()
            handle.succeed() if code == 0 else handle.abort()
            return _Result(error_code=code, error_string="" if code == 0 else "hit something")

        return follow

    def _streaming(self, group):
        def hear(trajectory):
            self.streamed.append((group, trajectory))
            self.q.update(zip(trajectory.joint_names, trajectory.points[-1].positions, strict=True))

        return hear

    def tick(self):
        with self.lock:
            self.t += self.pace
            for group in list(self.orders):
                self._follow(group)
            self.clock_topic.publish(Clock(clock=time_of(self.t)))
            if not self.is_silent:
                state = JointState(name=list(self.q))
                state.header.stamp = time_of(self.t - self.lag)
                state.position = [float(self.corrupt.get(n, v)) for n, v in self.q.items()]
                self.states.publish(state)

    def _follow(self, group):
        trajectory, handle, future = self.orders[group]
        if handle.is_cancel_requested and self.behaviour[group] == "coast" and self.coast:
            self.coast -= 1
        elif handle.is_cancel_requested:
            del self.orders[group]
            future.set_result("canceled")
            return
        t = self.t - seconds_of(trajectory.header.stamp)
        times = [seconds_of(point.time_from_start) for point in trajectory.points]
        rows = np.array([point.positions for point in trajectory.points])
        if t < 0:
            return
        place = [np.interp(t, times, column) for column in rows.T]
        if self.behaviour[group] in ("follow", "abort", "coast"):
            self.q.update(zip(trajectory.joint_names, place, strict=True))
        if self.behaviour[group] == "abort" and t > times[-1] / 2:
            del self.orders[group]
            future.set_result(_Result.PATH_TOLERANCE_VIOLATED)
        elif self.behaviour[group] in ("follow", "coast") and t > times[-1]:
            del self.orders[group]
            future.set_result(0)


class Bench:
    """The node, the rig and a client, each with a thread of its own."""

    def __init__(self):
        rclpy.init()
        self.given = parameters()
        self.rig = Rig(self.given)
        self.overrides = [Parameter(name, value=value) for name, value in self._flat(self.given)]
        self.node = GrasplessNode(parameter_overrides=self.overrides)
        assert self.node.start()
        self.client = rclpy.create_node("client")
        self.others = []
        self.executors = []
        self.threads = []
        self.is_over = threading.Event()
        for each in (self.rig, self.node, self.client):
            executor = SingleThreadedExecutor()
            executor.add_node(each)
            self.executors.append(executor)
            thread = threading.Thread(target=spin, args=(executor, self.is_over.is_set))
            thread.start()
            self.threads.append(thread)
        self.results = {}
        self.plan_task = ActionClient(self.client, PlanTask, "plan_task")
        self.pick_object = ActionClient(self.client, PickObject, "pick_object")
        self.check_plan = self.client.create_client(CheckPlan, "check_plan")
        sensor = qos_profile_sensor_data
        self.images = self.client.create_publisher(Image, "depth/image_rect", sensor)
        self.infos = self.client.create_publisher(CameraInfo, "depth/camera_info", sensor)
        self.clouds = self.client.create_publisher(PointCloud2, "points", sensor)
        self.poses = self.client.create_publisher(PoseWithCovarianceStamped, "object_pose", sensor)
        self.fixed = self.client.create_publisher(TFMessage, "/tf_static", TF_STATIC)
        assert self.plan_task.wait_for_server(PATIENCE)
        assert self.pick_object.wait_for_server(PATIENCE)
        assert self.check_plan.wait_for_service(PATIENCE)

    @staticmethod
    def _flat(given):
        extra = {"joint_state_seconds": 10.0, "controller_seconds": 1.0, "image_seconds": 1.0}
        extra |= {"queue": 64, "contact_speed": 0.5, "start_seconds": 5.0}
        for name, value in (given | extra).items():
            if isinstance(value, dict):
                yield from ((f"{name}.{key}", inner) for key, inner in value.items())
            else:
                yield name, value

    def another_node(self, namespace, remap="joint_states:=/joint_states", changes=()):
        """Returns a node beside the first, for the same robot and in the same thread.

        It lives as long as the bench: no thread may destroy what another one waits for.
        """
        arguments = ["--ros-args", "-r", remap]
        changed = [Parameter(name, value=value) for name, value in dict(changes).items()]
        kept = [each for each in self.overrides if each.name not in dict(changes)]
        given = {"parameter_overrides": kept + changed, "cli_args": arguments}
        self.others.append(GrasplessNode(namespace=namespace, **given))
        assert self.others[-1].start()
        self.executors[1].add_node(self.others[-1])
        return self.others[-1]

    def close(self):
        self.node.end_goals()
        self.is_over.set()
        for thread in self.threads:
            thread.join()
        for each in (self.node, *self.others):
            each.close()
        for executor in self.executors:
            executor.shutdown()
        for each in (self.client, self.node, *self.others, self.rig):
            each.destroy_node()
        rclpy.shutdown()

    def rest(self):
        """Puts the robot home and lets it do as it is told."""
        rig = self.rig
        with rig.lock:
            rig.orders.clear()
            rig.q.update(rig.home)
            rig.behaviour = dict.fromkeys(GROUPS, "follow")
            rig.is_silent, rig.corrupt, rig.lag, rig.coast = False, {}, 0.0, _COAST
            rig.heard.clear()
            rig.streamed.clear()
        self.settle()

    def settle(self, seconds=0.1):
        time.sleep(seconds)

    @staticmethod
    def wait(future, what="answer"):
        end = time.monotonic() + PATIENCE
        while not future.done():
            assert time.monotonic() < end, f"no {what}"
            time.sleep(0.001)
        return future.result()

    def send(self, goal, feedback=None):
        """Returns the handle of a goal, and asks for its result, which is kept for 10 s."""
        client = self.plan_task if isinstance(goal, PlanTask.Goal) else self.pick_object
        handle = self.wait(client.send_goal_async(goal, feedback_callback=feedback))
        self.results[bytes(handle.goal_id.uuid)] = handle.get_result_async()
        return handle

    def result(self, handle):
        """Returns status and result of a goal."""
        answer = self.wait(self.results[bytes(handle.goal_id.uuid)], "result")
        return answer.status, answer.result

    def do(self, goal, feedback=None):
        return self.result(self.send(goal, feedback))

    def until(self, is_so, what="it did not happen"):
        end = time.monotonic() + PATIENCE
        while not is_so():
            assert time.monotonic() < end, what
            time.sleep(0.005)

    def place(self, frame, X, parent="world"):
        """Publishes a static frame."""
        from graspless.ros.messages import pose_of

        each, pose = TransformStamped(child_frame_id=frame), pose_of(X)
        each.header.frame_id, each.transform.rotation = parent, pose.orientation
        p = each.transform.translation
        p.x, p.y, p.z = pose.position.x, pose.position.y, pose.position.z
        self.fixed.publish(TFMessage(transforms=[each]))
        self.settle()
