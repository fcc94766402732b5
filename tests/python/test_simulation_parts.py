# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slices of a robot's meshes, which MuJoCo tests in their place."""

import mujoco
import numpy as np
import pytest

from graspless.robot import Robot
from graspless.simulation.parts import slice_links, slices
from graspless.simulation.robots import robot_spec
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
    vertices, triangles = waisted()
    lines = [f"v {x} {y} {z}" for x, y, z in vertices]
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in triangles]
    (tmp_path / "waisted.obj").write_text("\n".join(lines))
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
