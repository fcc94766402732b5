# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Perception from clouds that a voxel grid has thinned."""

import warnings

import numpy as np
import pytest

from graspless import frames, perception
from graspless.perception import sparse
from pick_common import body

BODIES = [
    body([0.7, 0.7, 0.04], 0.65, 0, -0.02),
    body([6, 6, 0.02], 0.65, 0, -0.76),
    body([0.1, 0.06, 0.05], 0.65, 0.05, 0.025),
    body([0.09, 0.06, 0.004], 0.595, -0.17, 0.002),
]
X_WC = perception.look_at([0.1, 0, 0.8], [0.65, 0, 0])
EYE = X_WC[:3, 3]


def cloud_of(seed):
    noise = perception.Noise(quadratic=0, dark_patches=0)
    frame = perception.render(BODIES, X_WC, noise=noise, seed=seed)
    rows, columns = np.nonzero(frame.depth)
    rays = np.stack([columns, rows, np.ones_like(rows)], axis=1) @ np.linalg.inv(frame.K).T
    return frames.transform(X_WC, rays * frame.depth[rows, columns][:, None])


@pytest.fixture(scope="module")
def cloud():
    return cloud_of(1)


def voxels(points, size):
    """The mean of the points in each voxel."""
    _, index = np.unique(np.floor(points / size), axis=0, return_inverse=True)
    index = index.ravel()
    sums = [np.bincount(index, points[:, axis]) for axis in range(3)]
    return np.stack(sums, axis=1) / np.bincount(index)[:, None]


def thing_at(scene, x, y):
    (thing,) = (o for o in scene.objects if np.hypot(*(o.X_WO[:2, 3] - [x, y])) < 0.03)
    return np.ptp(thing.outline, axis=0), thing.thickness


@pytest.mark.parametrize("millimetres", [5, 8])
def test_a_voxel_grid_with_a_floor_shows_table_box_and_card(millimetres):
    boxes, cards = [], []
    for seed in range(1, 9):
        thinned = voxels(cloud_of(seed), 0.001 * millimetres)
        with pytest.warns(UserWarning, match=r"points are about .* mm apart .* the raw cloud, or"):
            view = perception.view_of_cloud(thinned, EYE)
        scene = perception.perceive_views([view])
        (table,) = (s for s in scene.supports if abs(s.X_WS[2, 3]) < 0.01)
        assert np.ptp(table.polygon, axis=0) == pytest.approx([0.7, 0.7], abs=0.03)
        size, thickness = thing_at(scene, 0.65, 0.05)
        boxes.append(size)
        assert thickness == pytest.approx(0.05, abs=0.002)
        size, thickness = thing_at(scene, 0.595, -0.17)
        cards.append(size)
        assert thickness == pytest.approx(0.004, abs=0.001)
    assert np.mean(boxes, axis=0) == pytest.approx([0.1, 0.06], abs=0.04)
    assert np.mean(cards, axis=0) == pytest.approx([0.09, 0.06], abs=0.04)


def test_a_dense_cloud_keeps_its_own_depths_in_as_many_pixels_as_points(cloud):
    for points in (cloud, cloud[::3]):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            view = perception.view_of_cloud(points, EYE)
        p_CP = (points - EYE) @ view.X_WC[:3, :3]
        columns, rows, _ = np.rint((p_CP / p_CP[:, 2:]) @ view.K.T).astype(int).T
        count, nearest, farthest = (np.full(view.depth.shape, v) for v in (0, np.inf, 0.0))
        np.add.at(count, (rows, columns), 1)
        np.minimum.at(nearest, (rows, columns), p_CP[:, 2])
        np.maximum.at(farthest, (rows, columns), p_CP[:, 2])
        assert np.array_equal(view.depth > 0, count > 0)
        lone, several = count == 1, count > 1
        assert np.array_equal(view.depth[lone], nearest[lone].astype(np.float32))
        assert (view.depth[several] >= nearest[several].astype(np.float32)).all()
        assert (view.depth[several] <= farthest[several].astype(np.float32)).all()
        assert view.depth.size == pytest.approx(len(points), rel=0.02)


def test_points_anywhere_in_their_pixels_give_the_plane_at_the_centres():
    rng = np.random.default_rng(1)
    rows, columns = np.nonzero(rng.random((60, 80)) < 0.5)
    uv = np.stack([columns, rows], axis=1) + rng.uniform(-0.5, 0.5, (len(rows), 2))
    points = sparse.nearest_points(uv, 1 / (1 + uv @ [0.002, 0.004]), [80, 60])
    assert sparse.gaps_of(points.depth).share > 0.4
    depth = sparse.resampled(points, sparse.bridged(points.depth, 0.004), 0.004)
    row, column = np.mgrid[2:58, 2:78]
    seen = depth[2:58, 2:78]
    assert np.mean(seen > 0) > 0.99
    off = seen[seen > 0] - 1 / (1 + 0.002 * column + 0.004 * row)[seen > 0]
    assert np.abs(off).max() < 5e-4  # points are up to 3e-3 off, where they are


def test_gaps_between_surfaces_are_not_bridged():
    depth = np.full((20, 20), np.inf)
    depth[:, :9], depth[:, 11:] = 1.0, 1.5
    assert np.array_equal(sparse.bridged(depth, 0.004), depth)
    depth[5, 4] = np.inf
    assert sparse.bridged(depth, 0.004)[5, 4] == pytest.approx(1.0)
