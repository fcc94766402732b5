# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Depth images and clouds of other libraries: small stand-ins, and the libraries if installed."""

from types import SimpleNamespace

import numpy as np
import pytest

import graspless
from graspless import geometry, perception
from pick_common import body

BODIES = [
    body([0.7, 0.6, 0.04], 0, 0, 0.38),
    body([0.12, 0.08, 0.02], -0.1, 0.1, 0.41),
]
X_WC = perception.look_at([-0.7, 0, 1.05], [0, 0, 0.4])
FRAME = perception.render(BODIES, X_WC, noise=perception.Noise(constant=5e-4, quadratic=0))
MILLIMETRES = np.round(1000 * FRAME.depth).astype(np.uint16)


def points_of(frame):
    v, u = np.indices(frame.depth.shape)
    rays = np.stack([u, v, np.ones_like(u)], axis=-1) @ np.linalg.inv(frame.K).T
    return rays * frame.depth[..., None]


def message_of(points, order="<", padding=4):
    """A PointCloud2 with x, y, z and an intensity, and unused bytes at the end of each row."""
    height, width = points.shape[:2]
    kind = np.dtype({"names": list("xyzi"), "formats": [order + "f4"] * 4, "itemsize": 20})
    rows = np.zeros((height, width), kind)
    for k, axis in enumerate("xyz"):
        rows[axis] = points[..., k]
    data = np.zeros((height, 20 * width + padding), np.uint8)
    data[:, : 20 * width] = rows.view(np.uint8).reshape(height, -1)
    fields = [
        SimpleNamespace(name=axis, offset=4 * k, datatype=7, count=1)
        for k, axis in enumerate("xyzi")
    ]
    return SimpleNamespace(
        fields=fields,
        is_bigendian=order == ">",
        height=height,
        width=width,
        point_step=20,
        row_step=20 * width + padding,
        data=data.tobytes(),
    )


class RealSenseFrame:
    """The part of a depth_frame that is read."""

    def __init__(self, coeffs=(0, 0, 0, 0, 0)):
        K = FRAME.K
        self.intrinsics = SimpleNamespace(
            fx=K[0, 0], fy=K[1, 1], ppx=K[0, 2], ppy=K[1, 2], coeffs=list(coeffs)
        )

    def get_data(self):
        return MILLIMETRES

    def get_units(self):
        return 0.001

    def get_profile(self):
        return self

    def as_video_stream_profile(self):
        return self

    def get_intrinsics(self):
        return self.intrinsics


def expect_the_box(scene):
    assert scene, scene.reason
    (thing,) = scene.objects
    assert thing.thickness == pytest.approx(0.02, abs=0.001)
    assert np.linalg.norm(thing.X_WO[:3, 3] - [-0.1, 0.1, 0.4]) < 0.004


def rgbd(depth):
    return SimpleNamespace(depth=depth, color=np.zeros((480, 640, 3), np.uint8))


def seen_points():
    points = points_of(FRAME)
    return points[FRAME.depth > 0]


CLOUD = SimpleNamespace(points=seen_points(), colors=[])
INTRINSIC = SimpleNamespace(intrinsic_matrix=FRAME.K)


@pytest.mark.parametrize(
    ("source", "K"),
    [
        (RealSenseFrame(), None),
        (SimpleNamespace(get_depth_frame=RealSenseFrame), None),
        (rgbd(FRAME.depth), FRAME.K),
        (rgbd(FRAME.depth), INTRINSIC),
        (rgbd(0.001 * MILLIMETRES), RealSenseFrame().intrinsics),
        (CLOUD, None),
        (message_of(points_of(FRAME)), None),
        (message_of(points_of(FRAME), order=">", padding=0), None),
        (message_of(seen_points()[None]), None),
    ],
)
def test_all_give_the_scene(source, K):
    expect_the_box(graspless.perceive(source, K, X_WC))


def test_depth_images_are_those_of_the_array():
    own = graspless.perceive(0.001 * MILLIMETRES, FRAME.K, X_WC)
    for source in (RealSenseFrame(), rgbd(0.001 * MILLIMETRES)):
        other = graspless.perceive(source, FRAME.K, X_WC)
        assert np.array_equal(other.objects[0].outline, own.objects[0].outline)


def test_points_that_are_no_measurement_do_not_count():
    points = seen_points()
    broken = [[np.nan] * 3, [0, 0, 0], [0, 0, -1.0], [np.inf, 0, 1]]
    spoilt = SimpleNamespace(points=np.concatenate([broken, points]))
    expected = graspless.perceive(CLOUD, None, X_WC)
    found = graspless.perceive(spoilt, None, X_WC)
    assert np.array_equal(found.objects[0].outline, expected.objects[0].outline)


def test_several_views_of_several_kinds():
    back = perception.look_at([0.7, 0.1, 1.05], [0, 0, 0.4])
    second = perception.render(BODIES, back, seed=2)
    views = [RealSenseFrame(), message_of(points_of(second))]
    both = graspless.perceive(views, X_WC=np.stack([X_WC, back]))
    expect_the_box(both)
    arrays = graspless.perceive(
        [0.001 * MILLIMETRES, second.depth], FRAME.K, np.stack([X_WC, back])
    )
    assert both.objects[0].outline.shape[0] > 3
    areas = [geometry.Polygon(s.objects[0].outline).area for s in (both, arrays)]
    assert areas[0] == pytest.approx(areas[1], rel=0.02)


@pytest.mark.parametrize(
    ("source", "K", "X", "words"),
    [
        (rgbd(FRAME.depth), None, X_WC, "K must be given: SimpleNamespace has no camera matrix"),
        (FRAME.depth, None, X_WC, "K must be given with a depth image"),
        (RealSenseFrame(), None, None, "X_WC must be given"),
        (RealSenseFrame((0.1, 0, 0, 0, 0)), None, X_WC, r"distorted image \(coeffs \[0.1, 0, 0"),
        (SimpleNamespace(get_depth_frame=lambda: None), None, X_WC, "has no depth frame"),
        (SimpleNamespace(points=np.ones((5, 3))), None, X_WC, r"shape \(5, 3\)"),
        (SimpleNamespace(points=np.ones((5, 2))), None, X_WC, r"shape \(5, 2\); it must be"),
        ([RealSenseFrame(), "image"], None, np.stack([X_WC] * 2), r"depth\[1\] is of type str"),
        ([RealSenseFrame()] * 2, None, X_WC, r"X_WC has shape \(4, 4\)"),
        (RealSenseFrame(), 2 * FRAME.K, X_WC, "K is not that of a pinhole camera"),
    ],
)
def test_bad_sources_are_refused_by_name(source, K, X, words):
    with pytest.raises(ValueError, match=words):
        graspless.perceive(source, K, X)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"fields": []}, "has no field x, y, z"),
        ({"data": b"12"}, "has 2 bytes, not 480 rows of 640"),
        ({"row_step": 8}, "not 480 rows of 640"),
        ({"height": 0}, "not 0 rows of 640"),
        ({"point_step": 8}, "rows of 640"),
    ],
)
def test_bad_messages_are_refused(change, words):
    message = message_of(points_of(FRAME))
    vars(message).update(change)
    with pytest.raises(ValueError, match=words):
        graspless.perceive(message, None, X_WC)


def test_messages_with_coordinates_of_unknown_type_are_refused():
    message = message_of(points_of(FRAME))
    message.fields[1].datatype = 9
    with pytest.raises(ValueError, match="coordinates of an unknown type"):
        graspless.perceive(message, None, X_WC)


def test_open3d():
    open3d = pytest.importorskip("open3d", exc_type=ImportError)
    color = np.zeros((480, 640, 3), np.uint8)
    legacy = open3d.geometry.RGBDImage.create_from_color_and_depth(
        open3d.geometry.Image(color), open3d.geometry.Image(MILLIMETRES)
    )
    tensor = open3d.t.geometry.RGBDImage(
        open3d.t.geometry.Image(color), open3d.t.geometry.Image(FRAME.depth[..., None])
    )
    K = FRAME.K
    camera = open3d.camera.PinholeCameraIntrinsic(640, 480, K[0, 0], K[1, 1], K[0, 2], K[1, 2])
    for image in (legacy, tensor):
        expect_the_box(graspless.perceive(image, camera, X_WC))
    points = seen_points()
    clouds = [
        open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points)),
        open3d.t.geometry.PointCloud(points.astype(np.float32)),
    ]
    for cloud in clouds:
        expect_the_box(graspless.perceive(cloud, X_WC=X_WC))


def test_pyrealsense2():
    rs = pytest.importorskip("pyrealsense2", exc_type=ImportError)
    sensor = rs.software_device().add_sensor("Depth")
    stream, intrinsics, K = rs.video_stream(), rs.intrinsics(), FRAME.K
    intrinsics.width, intrinsics.height, intrinsics.coeffs = 640, 480, [0] * 5
    intrinsics.fx, intrinsics.fy, intrinsics.ppx, intrinsics.ppy = K[[0, 1, 0, 1], [0, 1, 2, 2]]
    intrinsics.model = rs.distortion.brown_conrady
    stream.type, stream.fmt, stream.bpp = rs.stream.depth, rs.format.z16, 2
    stream.width, stream.height, stream.fps, stream.intrinsics = 640, 480, 30, intrinsics
    profile = sensor.add_video_stream(stream)
    sensor.add_read_only_option(rs.option.depth_units, 0.001)
    queue = rs.syncer()
    sensor.open(profile)
    sensor.start(queue)
    image = rs.software_video_frame()
    image.pixels, image.stride, image.bpp = MILLIMETRES, 1280, 2
    image.timestamp, image.frame_number = 1.0, 1
    image.profile = profile.as_video_stream_profile()
    image.domain = rs.timestamp_domain.hardware_clock
    sensor.on_video_frame(image)
    frameset = queue.wait_for_frames()
    for source in (frameset, frameset.get_depth_frame()):
        expect_the_box(graspless.perceive(source, X_WC=X_WC))
