# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A node that stands in for a robot: MuJoCo behind the topics and actions of ros2_control.

It serves FollowJointTrajectory for each controller, listens to its topic of trajectories, and
publishes joint states, a depth image with its camera info, tf, the pose of a block, and /clock.
"""

from __future__ import annotations

import threading
import time
from array import array
from typing import TYPE_CHECKING, Any

import numpy as np
from builtin_interfaces.msg import Time
from control_msgs.action import FollowJointTrajectory
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from rclpy.action import ActionServer, CancelResponse
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from rclpy.task import Future
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CameraInfo, Image, JointState
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage
from trajectory_msgs.msg import JointTrajectory

from .. import perception
from .fake_world import X_WC, World
from .messages import pose_of, seconds_of, time_of
from .node import LATCHED, TF_STATIC

if TYPE_CHECKING:
    from ..frames import Matrix

CAMERA = "camera_depth_optical_frame"
CONTROLLERS = {"arm": "arm_controller", "hand": "hand_controller"}  # by group of the SRDF
_TICK = 0.005  # of the loop on the wall [s]
_MOST = 0.05  # physics in one tick [s]
_PERIODS = {"joints": 0.01, "clock": 0.005, "pose": 1 / 30, "image": 0.5}  # by topic [s]
_Result = FollowJointTrajectory.Result


class Servos:
    """The controller of some joints: a trajectory at a time, from an action or the topic.

    Parameters
    ----------
    node : FakeRobot
    name : str
        Name of the controller.
    joints : list of str
    tolerance : float
        Largest distance of a joint from its trajectory; 0: any [rad or m].
    """

    def __init__(self, node: FakeRobot, name: str, joints: list[str], tolerance: float) -> None:
        self._node, self._joints, self._tolerance = node, joints, tolerance
        self._columns = [node.world.joint_names.index(joint) for joint in joints]
        self._order: tuple[float, Matrix, Matrix, Any, Any] | None = None
        action = f"{name}/follow_joint_trajectory"
        self.server = ActionServer(
            node,
            FollowJointTrajectory,
            action,
            self._execute,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )
        topic = f"{name}/joint_trajectory"
        node.create_subscription(JointTrajectory, topic, self._hear, 1)

    async def _execute(self, handle: Any) -> Any:
        fault = self._fault(handle.request.trajectory)
        if fault:
            handle.abort()
            return _Result(error_code=_Result.INVALID_GOAL, error_string=fault)
        future: Any = Future()
        self._begin(handle.request.trajectory, handle, future)
        code, text = await future
        if code is None:
            handle.canceled()
            return _Result()
        handle.succeed() if code == _Result.SUCCESSFUL else handle.abort()
        return _Result(error_code=code, error_string=text)

    def _hear(self, trajectory: Any) -> None:
        fault = self._fault(trajectory)
        if fault:
            self._node.get_logger().warning(f"trajectory ignored: {fault}")
        else:
            self._begin(trajectory, None, None)

    def _fault(self, trajectory: Any) -> str:
        if list(trajectory.joint_names) != self._joints:
            return f"its joints are {', '.join(trajectory.joint_names)}"
        times = [seconds_of(point.time_from_start) for point in trajectory.points]
        if not times or any(b <= a for a, b in zip(times, times[1:], strict=False)):
            return "its times do not increase"
        rows = [point.positions for point in trajectory.points]
        if any(len(row) != len(self._joints) or not np.isfinite(row).all() for row in rows):
            return "its positions are not finite, or not one for each joint"
        return ""

    def _begin(self, trajectory: Any, handle: Any, future: Any) -> None:
        self._end(_Result.INVALID_GOAL, "another trajectory came")
        start = seconds_of(trajectory.header.stamp) or self._node.world.time
        times = np.array([seconds_of(point.time_from_start) for point in trajectory.points])
        rows = np.array([point.positions for point in trajectory.points])
        if times[0] > 0:
            now = self._node.world.command[self._columns]
            times, rows = np.append(0.0, times), np.vstack([now, rows])
        self._order = start, times, rows, handle, future

    def _end(self, code: int | None, text: str = "") -> None:
        order, self._order = self._order, None
        if order is not None and order[4] is not None:
            order[4].set_result((code, text))

    def command(self) -> None:
        """Sets the targets of the servos for now."""
        if self._order is None:
            return
        start, times, rows, handle, _ = self._order
        world = self._node.world
        t = world.time - start
        if handle is not None and handle.is_cancel_requested:
            self._end(None)
            return
        if t < 0:
            return
        world.command[self._columns] = [np.interp(t, times, column) for column in rows.T]
        off = np.abs(world.positions - world.command)[self._columns]
        if 0 < self._tolerance < off.max():
            text = f"{self._joints[int(off.argmax())]} is {off.max():.3f} off"
            self._end(_Result.PATH_TOLERANCE_VIOLATED, text)
            world.command[self._columns] = world.positions[self._columns]
        elif t >= times[-1]:
            self._end(_Result.SUCCESSFUL)


class FakeRobot(Node):  # type: ignore[misc]  # rclpy may be untyped
    """The node. Its parameters: robot, block, tolerance of the arm, and speed.

    Parameters
    ----------
    name : str
        Name of the node.
    **given
        Arguments of `rclpy.node.Node`.
    """

    def __init__(self, name: str = "fake_robot", **given: Any) -> None:
        super().__init__(name, **given)
        self.declare_parameter("robot", "wam_t42")
        self.declare_parameter("block", "bar")
        self.declare_parameter("tolerance", 0.2)
        self.declare_parameter("speed", 1.0)
        self._speed = float(self.get_parameter("speed").value)
        self._block = str(self.get_parameter("block").value)
        self.world = World(str(self.get_parameter("robot").value))
        robot = self.world.robot
        self.servos = [
            Servos(
                self,
                controller,
                [robot.joint_names[j] for j in robot.group(group)],
                float(self.get_parameter("tolerance").value) if group == "arm" else 0.0,
            )
            for group, controller in CONTROLLERS.items()
        ]
        sensor = qos_profile_sensor_data
        self._clock_topic = self.create_publisher(Clock, "/clock", 1)
        self._states = self.create_publisher(JointState, "joint_states", sensor)
        self._poses = self.create_publisher(PoseWithCovarianceStamped, "object_pose", sensor)
        self._images = self.create_publisher(Image, "depth/image_rect", sensor)
        self._infos = self.create_publisher(CameraInfo, "depth/camera_info", sensor)
        self._describe()
        self._due = dict.fromkeys(_PERIODS, 0.0)
        self._wall = time.monotonic()
        self._picture = threading.Event()  # asks for an image
        self._is_open = True
        self._snapshot: tuple[float, Any] = (0.0, [])
        self._painter = threading.Thread(target=self._paint, daemon=True)
        self._painter.start()
        self.create_timer(_TICK, self._tick)

    def destroy_node(self) -> None:
        """Ends the thread that renders, and the node."""
        self._is_open = False
        self._picture.set()
        self._painter.join()
        super().destroy_node()

    def _describe(self) -> None:
        texts = self.create_publisher(String, "robot_description", LATCHED)
        texts.publish(String(data=self.world.fields.urdf_text))
        semantics = self.create_publisher(String, "robot_description_semantic", LATCHED)
        semantics.publish(String(data=self.world.fields.srdf_text or ""))
        fixed = self.create_publisher(TFMessage, "/tf_static", TF_STATIC)
        root = self.world.robot.frame_names[0]
        places = [(CAMERA, X_WC), (root, np.array(self.world.robot.X_WB))]
        if root == "world":
            places.pop()
        transforms = []
        for child, X in places:
            each, pose = TransformStamped(child_frame_id=child), pose_of(X)
            each.header.frame_id = "world"
            each.transform.rotation = pose.orientation
            p = each.transform.translation
            p.x, p.y, p.z = pose.position.x, pose.position.y, pose.position.z
            transforms.append(each)
        fixed.publish(TFMessage(transforms=transforms))

    def _tick(self) -> None:
        """Lets the physics catch up with the wall, and publishes."""
        now = time.monotonic()
        ahead = min(_MOST, self._speed * (now - self._wall))
        self._wall = now
        end = self.world.time + ahead
        while self.world.time < end:
            for servos in self.servos:
                servos.command()
            self.world.step()
            self._publish()

    def _publish(self) -> None:
        t = self.world.time
        due = [what for what, when in self._due.items() if t >= when]
        for what in due:
            self._due[what] = t + _PERIODS[what]
        stamp: Time = time_of(t)
        if "clock" in due:
            self._clock_topic.publish(Clock(clock=stamp))
        if "joints" in due:
            state = JointState(name=self.world.joint_names)
            state.header.stamp, state.position = stamp, self.world.positions.tolist()
            self._states.publish(state)
        if "pose" in due and self._block:
            message = PoseWithCovarianceStamped()
            message.header.frame_id, message.header.stamp = "world", stamp
            message.pose.pose = pose_of(self.world.pose(self._block))
            self._poses.publish(message)
        if "image" in due and not self._picture.is_set():
            self._snapshot = t, self.world.bodies()
            self._picture.set()

    def _paint(self) -> None:
        """Renders images, beside the physics."""
        camera = perception.Camera(320, 240, np.deg2rad(60))
        while self._picture.wait() and self._is_open:
            t, bodies = self._snapshot
            frame = perception.render(bodies, X_WC, camera, seed=1 + int(1000 * t))
            image = Image(encoding="32FC1")
            image.header.frame_id, image.header.stamp = CAMERA, time_of(t)
            image.height, image.width = frame.depth.shape
            image.step = 4 * image.width
            image.data = array("B", frame.depth.astype("<f4").tobytes())  # bytes would be checked
            info = CameraInfo(height=image.height, width=image.width, header=image.header)
            info.distortion_model = "plumb_bob"
            info.k = frame.K.ravel().tolist()
            try:
                self._infos.publish(info)
                self._images.publish(image)
            except Exception:  # the node was destroyed meanwhile
                return
            self._picture.clear()
