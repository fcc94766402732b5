# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slices of a robot's meshes, which MuJoCo tests in their place."""

import re
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
import yaml

from graspless import _data
from graspless.robot import Robot
from graspless.simulation.parts import slice_links, slices
from graspless.simulation.robots import robot_spec, set_positions
from graspless.simulation.slide.fingers import OTHER, SLIDING, whole_fingers
from graspless.simulation.slide.scene import build_scene
from graspless.simulation.variation import Variation
from graspless.tasks import read_task
from graspless.tasks.robots import Robot as Fields

scipy_spatial = pytest.importorskip("scipy.spatial")

INERTIAL = (
    '<inertial><mass value="1"/>'
    '<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>'
)
# Radius of a link of revolution, waisted between 0.1 and 0.3 m.
PROFILE = [(0.0, 0.06), (0.1, 0.06), (0.1, 0.02), (0.3, 0.02), (0.3, 0.06), (0.4, 0.06)]


def waisted(sides=12):
    """Vertices and triangles of a closed surface round the X axis."""
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = np.column_stack([np.cos(angles), np.sin(angles)])
    rows = [np.column_stack([np.full(sides, x), r * ring]) for x, r in PROFILE]
    vertices = np.vstack([*rows, [PROFILE[0][0], 0, 0], [PROFILE[-1][0], 0, 0]])
    triangles = []
    for row in range(len(PROFILE) - 1):
        for i in range(sides):
            a, b = row * sides + i, row * sides + (i + 1) % sides
            triangles += [(a, b, b + sides), (a, b + sides, a + sides)]
    last = (len(PROFILE) - 1) * sides
    for i in range(sides):
        triangles.append((i, len(vertices) - 2, (i + 1) % sides))
        triangles.append((last + i, last + (i + 1) % sides, len(vertices) - 1))
    return vertices, np.array(triangles)


def write_waisted(path):
    vertices, triangles = waisted()
    lines = [f"v {x} {y} {z}" for x, y, z in vertices]
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in triangles]
    path.write_text("\n".join(lines))


def contains(points, p, tolerance=1e-9):
    equations = scipy_spatial.ConvexHull(points).equations
    return bool((equations[:, :3] @ p + equations[:, 3] <= tolerance).all())


def test_slices_cover_a_surface_and_not_its_waist():
    vertices, triangles = waisted()
    parts = slices(vertices, triangles)
    assert len(parts) > 5
    weights = np.random.default_rng(0).dirichlet([1, 1, 1], size=len(triangles))
    for p in np.einsum("mk,mkd->md", weights, vertices[triangles]):
        assert any(contains(part, p) for part in parts)
    beside = np.array([0.2, 0.04, 0.0])  # beside the waist, within the hull of all
    assert contains(vertices, beside)
    assert not any(contains(part, beside) for part in parts)


def test_a_flat_surface_stays_whole():
    x, y = np.meshgrid(np.linspace(0, 0.3, 4), [0.0, 0.1])
    vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(8)])
    triangles = np.array([[(i, i + 1, i + 5), (i, i + 5, i + 4)] for i in range(3)]).reshape(-1, 3)
    (part,) = slices(vertices, triangles)
    np.testing.assert_array_equal(part, vertices)


@pytest.fixture
def touches(tmp_path):
    """Tells whether a ball at a place touches the waisted link, which is sliced or left whole."""
    write_waisted(tmp_path / "waisted.obj")
    link = '<collision><geometry><mesh filename="waisted.obj"/></geometry></collision>'
    urdf = (
        f'<robot name="r"><link name="base">{INERTIAL}</link><link name="bar">{INERTIAL}{link}</link>'
        '<joint name="turn" type="revolute"><parent link="base"/><child link="bar"/>'
        '<axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>'
    )
    robot = Robot.from_urdf(urdf, directory=str(tmp_path))

    def told(place, whole):
        spec = robot_spec(robot, Fields(urdf_text=urdf, directory=str(tmp_path)))
        slice_links(spec, robot, whole)
        spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.01, 0, 0], pos=place)
        model = spec.compile()
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        return bool(data.ncon)

    return told


def test_a_waisted_link_is_touched_where_its_mesh_is(touches):
    beside_waist, in_waist, in_end = [0.2, 0.045, 0], [0.2, 0.018, 0], [0.05, 0.055, 0]
    assert touches(beside_waist, whole=["bar"])  # by the hull
    assert not touches(beside_waist, whole=[])
    assert touches(in_waist, whole=[])
    assert touches(in_end, whole=[])


def world_of(robot):
    """The world of a box and a robot before anything is planned, with its problem."""
    document = yaml.safe_load((_data.directory("examples") / "25_pinch_box.yaml").read_text())
    document["robot"] = {"urdf": str(robot)}
    task = read_task(yaml.safe_dump(document), "box.yaml")
    segment = SimpleNamespace(object_poses=np.array([task.problem.X_WO_start]))
    plan = SimpleNamespace(task=task, segments=[segment])
    return build_scene(plan, Variation()).model, task.problem


def is_inside(model, problem, name, link, p_L):
    """Whether a point of a link is in a shape of one of its bodies that can touch."""
    data, q = mujoco.MjData(model), np.array(problem.robot.state(problem.hand.open))
    set_positions(model, data, problem.robot, q)
    p_W = (problem.robot.pose(link, q) @ [*p_L, 1.0])[:3]
    for geom in np.flatnonzero(model.geom_bodyid == model.body(name).id):
        if model.geom_contype[geom] and model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_MESH:
            mesh = model.geom_dataid[geom]
            first, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
            p_G = data.geom_xmat[geom].reshape(3, 3).T @ (p_W - data.geom_xpos[geom])
            if contains(model.mesh_vert[first : first + count], p_G, 1e-6):
                return True
    return False


def test_a_finger_that_is_not_convex_is_sliced(tmp_path):
    write_waisted(tmp_path / "waisted.obj")
    for part in (".urdf", ".srdf", ".hand.yaml"):
        text = (_data.directory("urdf") / f"wam_t42{part}").read_text()
        mesh = (
            '<collision><origin rpy="0 -1.570796 0"/><geometry>'
            '<mesh filename="waisted.obj" scale="0.24 0.17 0.17"/></geometry></collision>'
        )
        for link in re.findall(r'<link name="(?:left|right)_finger">.*?</link>', text, re.S):
            shaped = re.sub(r"<collision>.*?</collision>", "", link, flags=re.S)
            text = text.replace(link, shaped.replace("</link>", f"{mesh}</link>"))
        (tmp_path / f"mine{part}").write_text(text)
    model, problem = world_of(tmp_path / "mine.urdf")
    assert whole_fingers(problem.robot, problem.hand) == set()
    for name, link in ((SLIDING, "left_finger"), (OTHER, "right_finger")):
        assert is_inside(model, problem, name, link, [0.0, 0.009, 0.01])
        assert is_inside(model, problem, name, link, [0.0, 0.002, 0.05])
        assert not is_inside(model, problem, name, link, [0.0, 0.007, 0.05])


def test_fingers_that_hold_with_convex_shapes_stay_whole():
    _, problem = world_of("wam_t42")
    assert whole_fingers(problem.robot, problem.hand) == {"left_finger", "right_finger"}
