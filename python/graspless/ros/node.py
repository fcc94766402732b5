# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The node: actions plan_task and pick_object, service check_plan, and what it hears and shows."""

from __future__ import annotations

import traceback
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any

from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseWithCovarianceStamped
from graspless_msgs.action import PickObject, PlanTask
from graspless_msgs.srv import CheckPlan
from rclpy.clock import Clock, ClockType, JumpThreshold
from rclpy.duration import Duration
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from rclpy.task import Future
from sensor_msgs.msg import CameraInfo, Image, JointState, PointCloud2
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage
from trajectory_msgs.msg import JointTrajectory
from visualization_msgs.msg import MarkerArray

from ..errors import explain
from . import settings as parameters
from .controllers import Controllers
from .diagnostics import statuses
from .goals import Desk, Ending, Goal
from .jobs import CheckJob, Found
from .markers import markers_of
from .messages import trajectory_of
from .requests import Requests
from .results import pick_result, task_result
from .senses import Camera, Description, Joints, ObjectPose
from .server import Server
from .streaming import Streaming
from .transforms import Transforms
from .workers import Alarm, Workers

if TYPE_CHECKING:
    from collections.abc import Callable

    from .goals import Mover
    from .settings import Settings

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
TF = QoSProfile(depth=100)
TF_STATIC = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)

_LOOK = 0.01  # between looks whether all goals have ended [s]


class GrasplessNode(LifecycleNode):  # type: ignore[misc]  # rclpy may be untyped
    """Node that plans, checks and executes. Its goals are served while it is active.

    Parameters
    ----------
    **given
        Arguments of `rclpy.node.Node`.
    """

    def __init__(self, **given: Any) -> None:
        super().__init__("graspless", **given)
        parameters.declare(self)
        self.declare_parameter("autostart", True)
        self.settings: Settings
        self.jumps = 0
        self.is_active = self._is_idle = False
        self.faults = 0  # exceptions in callbacks
        self._workers = Workers()
        self._parts: list[Callable[[], object]] = []  # that undo what configuring has made
        threshold = JumpThreshold(
            min_forward=None, min_backward=Duration(nanoseconds=-1), on_clock_change=False
        )
        self._jump = self.get_clock().create_jump_callback(threshold, post_callback=self._jumped)

    # Time

    def seconds(self) -> float:
        """Returns the time of the node [s]."""
        return float(self.get_clock().now().nanoseconds) * 1e-9

    now = seconds

    def stamp(self) -> Any:
        """Returns the time of the node as a message."""
        return self.get_clock().now().to_msg()

    def wake(self) -> None:
        """Lets the executor look at its tasks again."""
        if self.executor is not None:
            self.executor.wake()

    def _jumped(self, _: Any) -> None:
        self.jumps += 1
        self.get_logger().warning("time has jumped back: forgetting what was heard")
        if self._parts:
            for heard in (self.transforms, self.joints, self.camera):
                heard.forget()

    # Lifecycle

    def start(self) -> bool:
        """Configures and activates the node, if the parameter autostart is true."""
        if not self.get_parameter("autostart").value:
            return True
        done = self.trigger_configure() == TransitionCallbackReturn.SUCCESS
        return bool(done and self.trigger_activate() == TransitionCallbackReturn.SUCCESS)

    def on_configure(self, state: Any) -> Any:
        """Reads the parameters, and makes all topics, services and actions.

        It takes some seconds: the first process imports what planning needs.
        """
        try:
            self.settings = parameters.read(self)
            self._workers.warm_up()
            self._hear()
            self._speak()
            self._serve()
        except Exception as error:  # rclpy would not say what it was
            self.get_logger().error(explain(error))
            self.close()
            return TransitionCallbackReturn.FAILURE
        return super().on_configure(state)

    def on_activate(self, state: Any) -> Any:
        """Begins to serve goals."""
        self.is_active = True
        self.get_logger().info("ready: actions plan_task and pick_object, service check_plan")
        return super().on_activate(state)

    def on_deactivate(self, state: Any) -> Any:
        """Cancels all goals and stops the robot."""
        self.is_active = False
        self.desk.cancel_all("stopped", "the node was deactivated")
        return super().on_deactivate(state)

    def on_cleanup(self, state: Any) -> Any:
        """Removes all topics, services and actions."""
        self.close()
        return super().on_cleanup(state)

    def on_shutdown(self, state: Any) -> Any:
        """Cancels all goals and stops the robot; removes everything as soon as that is done.

        It does not wait: the executor has to hear the controllers meanwhile.
        """
        self.is_active = False
        if self._parts:
            self.desk.cancel_all("stopped", "the node is shutting down")
            steady = Clock(clock_type=ClockType.STEADY_TIME)  # that of the node may stand still
            timer = self.create_timer(_LOOK, self._close_at_rest, clock=steady)
            self._parts.append(lambda: self.destroy_timer(timer))
        return super().on_shutdown(state)

    def _close_at_rest(self) -> None:
        """Removes everything at the second look without a goal: results are sent between them."""
        is_idle = all(each.is_idle for each in self._servers)
        if is_idle and self._is_idle:
            self.close()
        self._is_idle = is_idle

    def end_goals(self) -> None:
        """Cancels all goals and stops the robot; returns when that is done."""
        self.is_active = False
        if self._parts:
            self.desk.close()

    def close(self) -> None:
        """Cancels all goals, stops the robot, and removes topics, services and actions."""
        self.is_active = False
        while self._parts:
            self._parts.pop()()

    def _hear(self) -> None:
        s = self.settings
        self.transforms = Transforms()
        self.joints = Joints(self.seconds)
        images = self.resolve_topic_name("depth/image_rect")
        self.camera = Camera(self.transforms, s.world_frame, images)
        self.poses = ObjectPose(self.transforms, s.world_frame, self.seconds)
        self.description = Description(s.robot_description, s.robot_description_semantic)
        camera, sensor = self.camera, qos_profile_sensor_data
        self._subscribe(TFMessage, "/tf", lambda m: self.transforms.hear(m, False), TF)
        self._subscribe(TFMessage, "/tf_static", lambda m: self.transforms.hear(m, True), TF_STATIC)
        self._subscribe(JointState, "joint_states", self.joints.hear, sensor)
        self._subscribe(Image, "depth/image_rect", lambda m: camera.hear("image", m), sensor)
        self._subscribe(CameraInfo, "depth/camera_info", lambda m: camera.hear("info", m), sensor)
        self._subscribe(PointCloud2, "points", lambda m: camera.hear("cloud", m), sensor)
        self._subscribe(PoseWithCovarianceStamped, "object_pose", self.poses.hear, sensor)
        if not s.robot_description:
            self._subscribe(String, "robot_description", self.description.hear, LATCHED)
        if not s.robot_description_semantic:
            topic = "robot_description_semantic"
            self._subscribe(String, topic, self.description.hear_semantic, LATCHED)

    def _subscribe(self, kind: Any, topic: str, hear: Callable[[Any], None], qos: Any) -> None:
        def guarded(message: Any) -> None:
            try:
                hear(message)
            except Exception:
                self.faults += 1
                self.get_logger().error(f"{topic}: {traceback.format_exc(limit=-2)}")

        subscription = self.create_subscription(kind, topic, guarded, qos)
        self._parts.append(lambda: self.destroy_subscription(subscription))

    def _speak(self) -> None:
        def publisher(kind: Any, topic: str, qos: Any) -> Any:
            made = self.create_publisher(kind, topic, qos)
            self._parts.append(lambda: self.destroy_publisher(made))
            return made

        self._trajectories = publisher(JointTrajectory, "~/trajectory", LATCHED)
        self._markers = publisher(MarkerArray, "~/markers", LATCHED)
        self._diagnostics = publisher(DiagnosticArray, "/diagnostics", 10)
        timer = self.create_timer(1.0, self._diagnose)
        self._parts.append(lambda: self.destroy_timer(timer))

    def _serve(self) -> None:
        s = self.settings
        self.requests = Requests(s, self.transforms, self.joints, self.camera, self.description)
        self.controllers = Controllers(self, s, self.joints, self)
        self._parts.append(self.controllers.destroy)
        self.streaming = Streaming(self, s, self.joints, self.poses, self)
        self._parts.append(self.streaming.destroy)
        self._servers: list[Server] = []
        self._serve_action(PlanTask, "plan_task", self.requests.task_job, task_result)
        self._serve_action(PickObject, "pick_object", self.requests.pick_job, pick_result)
        service = self.create_service(CheckPlan, "check_plan", self._check)
        self._parts.append(lambda: self.destroy_service(service))
        self.desk = Desk(self._workers, s.jobs, s.queue)
        self._parts.append(self.desk.close)
        self._checker = ThreadPoolExecutor(1, "graspless-check")
        self._parts.append(lambda: self._checker.shutdown(wait=True))

    def _serve_action(
        self, action: Any, name: str, job: Callable[[Goal], Any], result: Callable[..., Any]
    ) -> None:
        def begin(goal: Goal) -> None:
            self._begin(goal, job)

        def end(ending: Ending) -> Any:
            return self._result(ending, result)

        server = Server(self, action, name, begin, lambda goal: self.desk.cancel(goal), end)
        self._parts.append(server.destroy)
        self._servers.append(server)

    # Goals

    def _begin(self, goal: Goal, job: Callable[[Goal], Any]) -> None:
        if not self.is_active:
            goal.end(Ending("refused", "the node is not active"))
            return
        if goal.request.preempt:
            self.desk.cancel_all("preempted", "another goal asked for the robot", besides=goal)
        self.desk.take(goal, job, self._mover)

    def _mover(self, goal: Goal) -> Mover | None:
        if not goal.request.execute:
            return None
        return self.streaming if getattr(goal.request, "closed_loop", False) else self.controllers

    def _result(self, ending: Ending, result: Callable[..., Any]) -> Any:
        found, stamp = ending.found, self.stamp()
        if found.times is not None:
            self._markers.publish(markers_of(found, self.settings.world_frame, stamp))
            arrays = found.times, found.positions, found.velocities, found.accelerations
            self._trajectories.publish(trajectory_of(found.joint_names, *arrays))
        if not ending.is_success:
            self.get_logger().warning(f"goal: {ending.status}: {ending.reason}")
        return result(ending, self.settings, stamp)

    async def _check(self, request: Any, response: Any) -> Any:
        """Serves check_plan."""
        future: Any = Future()

        def run() -> None:
            job = CheckJob(request.plan, request.certify)
            try:
                future.set_result(self._workers.run(job, Alarm(), lambda _: None))
            except Exception as error:
                future.set_result(Found(reason=explain(error)))
            self.wake()

        self._checker.submit(run)
        found = await future
        response.holds, response.faults = found.is_solved, found.faults
        response.reason = found.reason
        return response

    def _diagnose(self) -> None:
        message = DiagnosticArray(status=statuses(self))
        message.header.stamp = self.stamp()
        self._diagnostics.publish(message)
