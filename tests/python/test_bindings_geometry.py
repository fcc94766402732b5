# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points are rows in Python, and what is wrong is named."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from graspless import frames, geometry
from graspless.geometry import Band, Box, Capsule, Convex, Mesh, PlacedShape, Polygon, Sphere

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
NOT_RIGID = np.diag([1.0, 1, 2, 1])


def test_vertices_are_rows():
    polygon = Polygon([[0, 0], [2, 0], [2, 1], [1, 1], [0, 1]])
    assert polygon.vertices.shape == (5, 2)
    np.testing.assert_array_equal(polygon.vertices[2], [2, 1])
    assert polygon.area == pytest.approx(2)
    np.testing.assert_allclose(polygon.centroid, [1, 0.5])


def test_slices_and_integers_are_read_by_value():
    table = np.arange(24).reshape(4, 6)[:, ::2] % 7
    np.testing.assert_array_equal(Convex(table).vertices, table)
    np.testing.assert_array_equal(Convex(np.asfortranarray(table)).vertices, table)


def test_queries_of_a_point():
    polygon = Polygon(SQUARE)
    assert polygon.contains([0.5, 0.5])
    assert polygon.depth([0.5, 0.25]) == pytest.approx(0.25)
    assert polygon.depth([0.5, -0.25]) == pytest.approx(-0.25)
    edge = polygon.nearest_edge([0.5, 0.1])
    np.testing.assert_allclose(edge.inward, [0, 1], atol=1e-12)
    assert polygon.is_convex
    assert len(polygon) == 4
    assert sum(part.area for part in polygon.convex_parts()) == pytest.approx(1)


def test_band_samples_repeat_with_their_seed():
    band = Band(Polygon(SQUARE), 0.1)
    np.testing.assert_array_equal(band.sample(seed=3), band.sample(seed=3))
    assert band.sample(seed=3).shape == (2,)
    assert all(band.contains(band.sample(seed)) for seed in range(100))
    assert band.core[0].area == pytest.approx(0.64)
    assert band.exact


def test_grid_and_outline_are_rows():
    grid = geometry.sample_grid(Polygon(SQUARE), 0.05)
    assert grid.shape[1] == 2
    assert geometry.outline(grid).area == pytest.approx(1, abs=0.2)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Polygon([[0, 0, 0]]), r"polygon has shape \(1, 3\); it must have shape \(N, 2\)"),
        (lambda: Polygon([[0, 0], [1, 1], [1, 0], [0, 1]], what="table"), "table"),
        (lambda: Polygon([[0, 0], [1, 0], [1, np.nan]], what="table"), "table"),
        (lambda: Box([1, 2]), r"box size has shape \(2,\)"),
        (lambda: Box([1, 2, -3]), "box.*-3"),
        (lambda: Box([1, 2, np.inf]), "box size.*not finite"),
        (lambda: Sphere(0), "sphere"),
        (lambda: Capsule(0.1, np.nan), "capsule"),
        (lambda: Convex(np.zeros((4, 3))), "convex"),
        (lambda: Mesh(np.eye(3), [[0, 1, 3]]), "mesh"),
        (
            lambda: Mesh(np.eye(3), np.array([[0, 1, 2]], np.uint64) + np.uint64(2**32)),
            r"mesh triangles\[0\]\[0\] is 4294967296; it must be the index of a vertex, from 0",
        ),
        (lambda: Mesh(np.eye(3), [[0, 1, 1.4]]), r"mesh triangles\[0\]\[2\] is 1.4;"),
        (lambda: Mesh(np.eye(3), [[0, 1, -1]]), r"mesh triangles\[0\]\[2\] is -1;"),
        (lambda: Mesh(np.eye(3), [[0, 1, np.nan]]), r"mesh triangles\[0\]\[2\] is nan;"),
        (lambda: PlacedShape(Sphere(1), NOT_RIGID), "X_BG is not a rigid transform"),
        (lambda: PlacedShape(Sphere(1), np.eye(3)), r"X_BG has shape \(3, 3\)"),
        (lambda: Band(Polygon(SQUARE), -1), "width"),
        (lambda: geometry.read_mesh("nowhere.stl"), "nowhere.stl"),
        (lambda: geometry.read_mesh("nowhere.stl", scale=[1, 2]), "scale"),
        (lambda: Polygon(SQUARE).edge(4), "index is 4.*0 to 3"),
    ],
)
def test_bad_input_is_a_value_error_that_names_it(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@pytest.mark.parametrize("first", range(6))
def test_faces_that_are_not_convex_are_filled_alone(first, tmp_path):
    """A prism on an L, whose faces begin at any corner: area, and no surface across the notch."""
    ell = [(0, 0), (0.1, 0), (0.1, 0.04), (0.04, 0.04), (0.04, 0.1), (0, 0.1)]
    ell = ell[first:] + ell[:first]
    corners = [(x, y, z) for z in (0, 0.02) for x, y in ell]
    faces = [range(6, 0, -1), range(7, 13)]
    faces += [(i + 1, (i + 1) % 6 + 1, (i + 1) % 6 + 7, i + 7) for i in range(6)]
    lines = [f"v {x} {y} {z}" for x, y, z in corners]
    lines += ["f " + " ".join(map(str, face)) for face in faces]
    (tmp_path / "ell.obj").write_text("\n".join(lines) + "\n")
    mesh = geometry.read_mesh(tmp_path / "ell.obj")
    a, b, c = (np.asarray(mesh.vertices)[np.asarray(mesh.triangles)[:, k]] for k in range(3))
    assert np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2 == pytest.approx(0.0208)
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 == pytest.approx(0.0064 * 0.02)


def test_more_pieces_of_surface_than_points_are_sampled():
    corners = np.random.default_rng(1).uniform(-1, 1, (20_000, 1, 3))
    corners = np.repeat(corners, 3, axis=1) + [[0, 0, 0], [1e-3, 0, 0], [0, 1e-3, 0]]
    dust = Mesh(corners.reshape(-1, 3), np.arange(60_000).reshape(-1, 3))
    assert geometry.sample_surface([PlacedShape(dust)], 1000).shape == (1000, 3)


def test_poses_come_back_bit_by_bit():
    angle = 0.3
    X = np.eye(4)
    X[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    X[:3, 3] = 0.1, 0.2, 0.3
    np.testing.assert_array_equal(PlacedShape(Sphere(1), X).X_BG, X)


def test_shapes_keep_what_they_were_given():
    mesh = Mesh([[0, 0, 0], [1, 0, 0], [0, 2, 0]], [[0, 1, 2]])
    np.testing.assert_array_equal(mesh.vertices[2], [0, 2, 0])
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 2]])
    placed = PlacedShape(Box([1, 2, 3]))
    np.testing.assert_array_equal(placed.shape.size, [1, 2, 3])
    np.testing.assert_array_equal(placed.X_BG, np.eye(4))
    assert repr(Box([1, 2, 3])) == "Box(size=array([1., 2., 3.]))"


def test_rotations_are_those_of_scipy():
    rng = np.random.default_rng(1)
    turns = rng.normal(size=(200, 3))
    turns[:60] *= np.pi / np.linalg.norm(turns[:60], axis=1, keepdims=True)  # half turns
    turns[60:63] = np.pi * np.eye(3)
    turns[63] = 0
    oracle = Rotation.from_rotvec(turns)
    X = np.tile(np.eye(4), (200, 1, 1))
    X[:, :3, :3] = oracle.as_matrix()
    wxyz = frames.to_quaternion(X)
    np.testing.assert_allclose(np.linalg.norm(wxyz, axis=1), 1, rtol=1e-14)
    assert (np.sum(wxyz * np.roll(oracle.as_quat(), 1, axis=1), axis=1) ** 2 > 1 - 1e-14).all()
    first = np.argmax(np.abs(wxyz) > 1e-12, axis=1)
    assert (wxyz[np.arange(200), first] > 0).all()
    np.testing.assert_allclose(frames.from_quaternion(wxyz), X, atol=1e-14)
    for length in (-3, 1e-200, 1e200):
        np.testing.assert_allclose(frames.from_quaternion(length * wxyz[7]), X[7], atol=1e-14)
    np.testing.assert_array_equal(frames.to_quaternion(X[7]), wxyz[7])
