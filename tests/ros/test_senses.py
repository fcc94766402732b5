# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the node hears: frames, images, clouds and joints, good and bad; and picks from them."""

import json
from array import array
from contextlib import nullcontext

import numpy as np
import pytest
from geometry_msgs.msg import TransformStamped
from graspless_msgs.action import PickObject
from rig import PATIENCE
from sensor_msgs.msg import CameraInfo, Image, JointState, PointCloud2, PointField
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from graspless import frames, perception
from graspless.robot import Robot
from graspless.ros.fake_world import SCENE, X_WC, World, _shape
from graspless.ros.halting import HaltedError, Timer, positions
from graspless.ros.messages import (
    RefusedError,
    camera_matrix_of,
    depth_of,
    matrix_of,
    points_of,
    pose_of,
    time_of,
)
from graspless.ros.robot import robot_fields
from graspless.ros.senses import Description, Joints
from graspless.ros.settings import Settings
from graspless.ros.transforms import Transforms
from graspless.ros.workers import Alarm
from graspless.tasks.shapes import Pose, pose_matrix


def moved(child, parent, X, stamp=0.0):
    each, pose = TransformStamped(child_frame_id=child), pose_of(X)
    each.header.frame_id, each.header.stamp = parent, time_of(stamp)
    each.transform.rotation = pose.orientation
    p = each.transform.translation
    p.x, p.y, p.z = pose.position.x, pose.position.y, pose.position.z
    return TFMessage(transforms=[each])


def some_pose(rng):
    X = frames.from_rpy(rng.uniform(-3, 3, 3).tolist())
    X[:3, 3] = rng.uniform(-1, 1, 3)
    return X


def test_frames_are_chained_through_a_common_ancestor():
    rng = np.random.default_rng(1)
    X_WA, X_AB, X_WC_ = (some_pose(rng) for _ in range(3))
    transforms = Transforms()
    for child, parent, X in (("a", "w", X_WA), ("b", "a", X_AB), ("c", "w", X_WC_)):
        transforms.hear(moved(child, parent, X), is_static=True)
    np.testing.assert_allclose(transforms.lookup("w", "b"), X_WA @ X_AB, atol=1e-12)
    X_CB = np.linalg.inv(X_WC_) @ X_WA @ X_AB
    np.testing.assert_allclose(transforms.lookup("/c", "b"), X_CB, atol=1e-12)
    np.testing.assert_allclose(transforms.lookup("b", "b"), np.eye(4))


def test_frames_are_interpolated_and_never_extrapolated():
    transforms = Transforms()
    for t in (1.0, 3.0, 2.0):  # out of order
        transforms.hear(moved("a", "w", frames.translation([t, 0, 0])), False)
        transforms.hear(moved("b", "w", frames.translation([t, 0, 0]), t), False)
    assert transforms.lookup("w", "b", 1.25)[0, 3] == pytest.approx(1.25)
    assert transforms.lookup("w", "b", 2.5)[0, 3] == pytest.approx(2.5)
    assert transforms.lookup("w", "b")[0, 3] == 3.0
    for t in (0.9, 3.1):
        with pytest.raises(RefusedError, match="than what tf knows"):
            transforms.lookup("w", "b", t)


def test_frames_above_the_common_one_need_not_be_known():
    transforms = Transforms()
    transforms.hear(moved("base", "odom", np.eye(4), 1.0), False)
    for child in ("camera", "arm"):
        transforms.hear(moved(child, "base", frames.translation([0, 0, 0.5])), True)
    np.testing.assert_allclose(transforms.lookup("arm", "camera", 7.0), np.eye(4))
    np.testing.assert_allclose(transforms.lookup("base", "camera", 7.0)[2, 3], 0.5)
    with pytest.raises(RefusedError, match="newer than what tf knows of 'base'"):
        transforms.lookup("odom", "camera", 7.0)


def test_frames_that_are_none():
    transforms = Transforms()
    bad = moved("a", "w", np.eye(4))
    bad.transforms[0].transform.translation.x = float("nan")
    transforms.hear(bad, True)
    bad = moved("a", "w", np.eye(4))
    bad.transforms[0].transform.rotation.w = 0.0
    transforms.hear(bad, True)
    transforms.hear(moved("a", "a", np.eye(4)), True)
    assert transforms.refused == 3
    with pytest.raises(RefusedError, match="does not connect"):
        transforms.lookup("w", "a")
    with pytest.raises(RefusedError, match="names no frame"):
        transforms.lookup("w", "")
    transforms.hear(moved("a", "b", np.eye(4)), True)
    transforms.hear(moved("b", "a", np.eye(4)), True)
    with pytest.raises(RefusedError, match="loop"):
        transforms.lookup("w", "a")


def test_a_robot_on_a_planar_joint_is_where_tf_says():
    urdf = """<robot name="cart"><link name="odom"/><link name="base"/>
      <joint name="drive" type="planar"><parent link="odom"/><child link="base"/>
        <origin xyz="0.1 0 0.2" rpy="0 0 1"/></joint>%s</robot>"""
    X_WB, X_BC = (some_pose(np.random.default_rng(k)) for k in (1, 2))
    transforms = Transforms()
    transforms.hear(moved("odom", "world", X_WB), True)
    transforms.hear(moved("base", "odom", X_BC), True)
    fields = robot_fields(Description(urdf % "", ""), transforms, Settings())
    cart = Robot.from_urdf(urdf % "", X_WB=pose_matrix(Pose(**fields["pose"])))
    np.testing.assert_allclose(cart.pose(cart.frame("base"), []), X_WB @ X_BC, atol=1e-9)
    other = '<link name="other"/><joint name="fly" type="floating"><parent link="odom"/><child link="other"/></joint>'
    with pytest.raises(RefusedError, match="has 2 planar or floating joints, not one: drive, fly"):
        robot_fields(Description(urdf % other, ""), transforms, Settings())


def test_joints_ignore_states_that_are_out_of_order():
    joints = Joints(lambda: 10.0)

    def hear(t, q):
        state = JointState(name=["j"], position=[q])
        state.header.stamp = time_of(t)
        joints.hear(state)

    hear(9.9, 1.0)
    hear(9.8, 2.0)
    assert joints.positions(["j"], 1.0).tolist() == [1.0]
    assert joints.out_of_order == 1
    hear(12.0, 3.0)
    with pytest.raises(RefusedError, match="ahead of the clock"):
        joints.positions(["j"], 1.0)
    with pytest.raises(RefusedError, match="was heard of k"):
        joints.positions(["j", "k"], 1.0)


def test_joints_wait_a_moment_for_a_clock_that_comes_after_the_state():
    times = iter([10.0, 10.0, 10.0, 11.0])
    joints = Joints(lambda: next(times))
    state = JointState(name=["j"], position=[1.0])
    state.header.stamp = time_of(11.0)
    joints.hear(state)
    assert joints.positions(["j"], 1.0).tolist() == [1.0]
    assert next(times, None) is None


def test_a_jump_of_time_is_why_joints_are_not_known():
    class Time:
        t, jumps = 10.0, 0

        def now(self):
            return self.t

    clock = Time()
    joints, timer = Joints(clock.now), Timer(clock)
    state = JointState(name=["j"], position=[1.0])
    state.header.stamp = time_of(10.0)
    joints.hear(state)
    assert positions(joints, ["j"], 1.0, timer).tolist() == [1.0]
    with pytest.raises(RefusedError, match="was heard of k"):
        positions(joints, ["k"], 1.0, timer)
    clock.t = 5.0
    with pytest.raises(HaltedError, match="time has jumped back"):
        positions(joints, ["j"], 1.0, timer)
    clock.t, clock.jumps = 11.0, 1  # there and back between two looks
    with pytest.raises(HaltedError, match="time has jumped back"):
        timer.elapsed()


def test_a_late_state_from_before_a_jump_hides_no_newer_ones():
    joints = Joints(lambda: 10.0)
    for t, q in ((110.0, 1.0), (9.95, 2.0)):
        state = JointState(name=["j"], position=[q])
        state.header.stamp = time_of(t)
        joints.hear(state)
    assert joints.positions(["j"], 1.0).tolist() == [2.0]
    assert joints.out_of_order == 0


def picture(encoding="32FC1", stamp=0.0, frame="camera"):
    """The demo's scene as messages."""
    bodies = [perception.Body([_shape(block)], frames.translation(block.center)) for block in SCENE]
    found = perception.render(bodies, X_WC, perception.Camera(320, 240, np.deg2rad(60)))
    depth = found.depth.astype("<f4")
    if encoding == "16UC1":
        depth = np.round(1000 * depth).astype("<u2")
    image = Image(encoding=encoding, height=240, width=320, step=320 * depth.itemsize)
    image.data = array("B", depth.tobytes())
    info = CameraInfo(height=240, width=320, k=found.K.ravel().tolist())
    for message in (image, info):
        message.header.frame_id, message.header.stamp = frame, time_of(stamp)
    return image, info, found


def test_depths_have_their_units():
    image, _, found = picture()
    np.testing.assert_array_equal(depth_of(image), found.depth)
    image, _, found = picture("16UC1")
    np.testing.assert_allclose(depth_of(image), found.depth, atol=0.0006)
    image.encoding = "rgb8"
    with pytest.raises(RefusedError, match="rgb8"):
        depth_of(image)
    image.encoding, image.width = "16UC1", 10**6
    with pytest.raises(RefusedError, match="too few"):
        depth_of(image)


def test_rectified_images_have_the_matrix_p():
    image, info, found = picture()
    np.testing.assert_array_equal(camera_matrix_of(info, image, is_rectified=True), found.K)
    info.p = np.hstack([found.K + np.diag([5.0, 5.0, 0.0]), np.zeros((3, 1))]).ravel().tolist()
    info.d = [0.1, 0.0, 0.0, 0.0, 0.0]
    P = camera_matrix_of(info, image, is_rectified=True)
    np.testing.assert_array_equal(P, found.K + np.diag([5.0, 5.0, 0.0]))
    with pytest.raises(RefusedError, match="distorted"):
        camera_matrix_of(info, image, is_rectified=False)
    info.d = [0.0] * 5
    np.testing.assert_array_equal(camera_matrix_of(info, image, is_rectified=False), found.K)


def cloud_of(points, frame="camera", stamp=0.0):
    height, width, _ = points.shape
    cloud = PointCloud2(height=height, width=width, point_step=16, row_step=16 * width)
    cloud.fields = [
        PointField(name=name, offset=4 * k, datatype=PointField.FLOAT32, count=1)
        for k, name in enumerate("xyz")
    ]
    data = np.zeros((height, width, 4), dtype="<f4")
    data[..., :3] = points
    cloud.data = array("B", data.tobytes())
    cloud.header.frame_id, cloud.header.stamp = frame, time_of(stamp)
    return cloud


def test_clouds_have_points():
    points = np.random.default_rng(1).uniform(-1, 1, (3, 5, 3)).astype("f4")
    cloud = cloud_of(points)
    np.testing.assert_array_equal(points_of(cloud), points)
    cloud.fields = cloud.fields[:2]
    with pytest.raises(RefusedError, match="no field z"):
        points_of(cloud)
    cloud = cloud_of(points)
    cloud.data = cloud.data[:50]
    with pytest.raises(RefusedError, match="50 bytes"):
        points_of(cloud)


def test_poses_have_unit_quaternions():
    pose = pose_of(np.eye(4))
    pose.orientation.w = 0.5
    with pytest.raises(RefusedError, match="norm 0.5"):
        matrix_of(pose.position, pose.orientation, "it")


def see(bus, message, info=None):
    """Publishes until the node has seen it, with the clock of the robot."""
    stamp = time_of(bus.rig.t)
    message.header.stamp = stamp
    if info is not None:
        info.header.stamp = stamp
        bus.infos.publish(info)
    (bus.images if info is not None or isinstance(message, Image) else bus.clouds).publish(message)


def pick(bus, message=None, info=None, **given):
    """Picks the bar while messages come."""
    given.setdefault("robot", "wam_t42")
    bus.node.camera.forget()
    goal = PickObject.Goal(**given)
    if not goal.name and not goal.at.header.frame_id:
        goal.at.header.frame_id = "world"
        goal.at.point.x, goal.at.point.y, goal.at.point.z = SCENE[-1].center
    handle = bus.send(goal)
    future = handle.get_result_async()
    while not future.done():
        if message is not None:
            see(bus, message, info)
        bus.settle(0.02)
    return future.result().result


@pytest.fixture(scope="module")
def image():
    return picture()[:2]


@pytest.fixture
def camera(bus):
    bus.place("camera", X_WC)
    return bus


def test_picks_an_object_of_an_image(camera, image):
    result = pick(camera, *image)
    assert result.motion.status == "solved", result.motion.reason
    assert result.strategy == "pinch"
    assert len(result.objects) == len(result.poses.poses) == 2
    place = result.poses.poses[list(result.objects).index(result.name)].position
    assert abs(place.x - 0.62) < 0.01
    assert abs(place.y) < 0.01
    assert [attempt.status for attempt in result.attempts][0] == "solved"


def test_puts_an_object_down_beside_what_the_camera_does_not_see(camera, image):
    wall = "[{name: wall, box: [0.02, 0.4, 0.6], pose: {position: [0.9, 0, 0.3]}}]"
    place = "{pose: {x: 0.6, y: 0.2}}"
    result = pick(camera, *image, obstacles=wall, place=place)
    assert result.motion.status == "solved", result.motion.reason
    plan = json.loads(result.motion.plan)
    last = plan["stages"][-1]
    np.testing.assert_allclose(last["segments"][-1]["object_poses"][-1][:2], [0.6, 0.2], atol=0.02)
    for stage in plan["stages"]:
        assert "wall" in [obstacle["name"] for obstacle in stage["task"]["obstacles"]]


@pytest.mark.parametrize(
    ("given", "reason"),
    [
        ({"place": "{pose: [0.6}"}, "place: not valid YAML"),
        ({"place": "null"}, "place: is empty"),
        ({"place": "{pose: {x: 0.6}}"}, "place: pose.y: missing"),
        ({"obstacles": "{name: wall}"}, "obstacles"),
        ({"obstacles": "[{name: wall, box: [1, 1]}]"}, "obstacles[0].box"),
    ],
)
def test_fields_in_yaml_are_refused_by_name(camera, image, given, reason):
    result = pick(camera, *image, **given)
    assert result.motion.status == "refused"
    assert reason in result.motion.reason


@pytest.mark.parametrize("topic", ["depth/image_rect_raw", "depth/image_raw"])
def test_the_name_of_the_topic_says_whether_images_are_rectified(camera, topic):
    image, info, found = picture()
    info.p, info.d = np.hstack([found.K, np.zeros((3, 1))]).ravel().tolist(), [0.1]
    node = camera.another_node(f"eyes_{topic[-3:]}", f"depth/image_rect:={topic}")
    node.camera.hear("image", image)
    node.camera.hear("info", info)
    is_raw = topic.endswith("image_raw")
    with pytest.raises(RefusedError, match="distorted") if is_raw else nullcontext():
        seen = node.camera.look("image", 0.0, 1.0, PATIENCE, Alarm())
        np.testing.assert_array_equal(seen.K, found.K)


@pytest.mark.parametrize("is_organized", [True, False])
def test_picks_an_object_of_a_cloud(camera, is_organized):
    _, _, found = picture()
    rows, columns = np.indices(found.depth.shape)
    rays = [(columns - found.K[0, 2]) / found.K[0, 0], (rows - found.K[1, 2]) / found.K[1, 1]]
    points = np.stack([rays[0], rays[1], np.ones(rows.shape)], axis=-1) * found.depth[..., None]
    points[found.depth == 0] = np.nan
    points[0, 0] = 0.0  # no measurement either
    points = points if is_organized else points.reshape(1, -1, 3)
    result = pick(camera, cloud_of(points), source="cloud")
    assert result.motion.status == "solved", result.motion.reason


def test_says_why_nothing_was_picked(camera, image):
    result = pick(camera, *image, strategies=["slide"])
    assert result.motion.status == "not_found"
    assert "slide" in result.motion.reason
    result = pick(camera, *image, name="object_9")
    assert result.motion.status == "refused"
    assert "object_0" in result.motion.reason
    goal = PickObject.Goal().at
    goal.header.frame_id = "world"
    goal.point.z = 3.0
    result = pick(camera, *image, at=goal)
    assert "cm away" in result.motion.reason
    goal.header.frame_id = "moon"
    result = pick(camera, *image, at=goal)
    assert "moon" in result.motion.reason
    goal.header.frame_id, goal.point.x = "world", float("nan")
    assert "finite" in pick(camera, *image, at=goal).motion.reason


def test_the_mass_and_the_force_of_the_hand_are_part_of_the_goal(camera, image):
    result = pick(camera, *image, mass=0.35, grip_force=12.5)
    assert result.motion.status == "solved", result.motion.reason
    given = json.loads(result.motion.plan)["task"]["stages"][0]
    assert (given["object"]["mass"], given["options"]["grip_force"]) == (0.35, 12.5)
    result = pick(camera, *image, mass=-0.3)
    assert result.motion.status == "refused"
    assert "mass: -0.3: should be at least 0" in result.motion.reason


def test_refuses_robots_that_nobody_knows(camera, image):
    result = pick(camera, *image, robot="no_such_robot")
    assert result.motion.status == "refused"
    assert "no_such_robot" in result.motion.reason
    result = pick(camera, *image, robot="robot_description")
    assert "no robot_description was received" in result.motion.reason


def test_refuses_images_that_cannot_be_trusted(camera, image):
    good, info = image
    assert "no depth image came" in pick(camera).motion.reason
    assert "without its camera info" in pick(camera, good).motion.reason
    assert "source" in pick(camera, good, info, source="nose").motion.reason
    other = picture(frame="elsewhere")
    assert "'elsewhere'" in pick(camera, *other[:2]).motion.reason
    assert "frame" in pick(camera, good, other[1]).motion.reason
    small = CameraInfo(height=10, width=10, k=info.k, header=info.header)
    assert "10 x 10" in pick(camera, good, small).motion.reason
    bent = CameraInfo(height=240, width=320, k=info.k, d=[0.1], header=info.header)
    assert "not calibrated: p has" in pick(camera, good, bent).motion.reason
    blind = CameraInfo(height=240, width=320, header=info.header)
    assert "not calibrated: k has" in pick(camera, good, blind).motion.reason


def test_an_empty_image_is_a_status(camera):
    good, info, _ = picture()
    good.data = array("B", bytes(len(good.data)))
    result = pick(camera, good, info)
    assert result.motion.status == "nothing_seen"
    assert result.motion.reason


def test_an_old_image_is_not_used(bus, image):
    bus.place("camera", X_WC)
    good, info = image
    see(bus, good, info)
    bus.settle(0.2)
    handle = bus.send(PickObject.Goal(name="object_0", robot="wam_t42"))
    motion = bus.result(handle)[1].motion
    assert motion.status == "refused"
    assert "the last is" in motion.reason


def test_waiting_for_an_image_can_be_cancelled(bus):
    handle = bus.send(PickObject.Goal(name="object_0", robot="wam_t42"))
    bus.wait(handle.cancel_goal_async())
    assert bus.result(handle)[1].motion.status == "canceled"


def test_picks_with_the_description_of_the_topic(camera, image):
    world = World("wam_t42", ())
    root = world.robot.frame_names[0]
    camera.node.description.hear(String(data=world.fields.urdf_text))
    camera.node.description.hear_semantic(String(data=world.fields.srdf_text))
    try:
        motion = pick(camera, *image, robot="robot_description").motion
        assert motion.status == "refused"
        assert f"does not connect the frames '{root}'" in motion.reason
        camera.place(root, np.eye(4))
        motion = pick(camera, *image, robot="robot_description").motion
        assert motion.status == "solved", motion.reason
    finally:
        camera.node.description.hear(String())
        camera.node.description.hear_semantic(String())
