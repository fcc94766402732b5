# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Depth images of known scenes: statistics of every fault of the camera."""

import numpy as np
import pytest

from graspless import perception
from graspless.perception import Noise
from pick_common import body

TABLE = body([4, 4, 0.1], 0, 0, -0.05)
SCENE = [TABLE, body([0.3, 0.2, 0.2], 0, 0, 0.1)]
X_WC = perception.look_at([-0.6, 0, 0.7], [0, 0, 0])


def test_without_noise_the_image_is_clean():
    frame = perception.render(SCENE, X_WC, noise=Noise.none())
    assert np.array_equal(frame.depth, frame.clean)
    assert set(np.unique(frame.labels)) == {0, 1}
    assert repr(frame) == "<Frame of 640 x 480 pixels>"


def test_deviation_grows_with_the_squared_depth():
    quiet = {"quantum": 0, "flying": 0, "dark_patches": 0}
    frame = perception.render([TABLE], X_WC, noise=Noise(**quiet))
    seen = frame.depth > 0
    error, z = (frame.depth - frame.clean)[seen], frame.clean[seen]
    for low, high in ((0.5, 0.7), (0.9, 1.1), (1.4, 1.6)):
        some = (z > low) & (z < high)
        expected = np.sqrt(np.mean((0.001 + 0.002 * z[some] ** 2) ** 2))
        assert np.std(error[some]) == pytest.approx(expected, rel=0.03)
        assert abs(np.mean(error[some])) < 4 * expected / np.sqrt(np.count_nonzero(some))


def test_depths_are_multiples_of_the_quantum():
    frame = perception.render(SCENE, X_WC, noise=Noise(quantum=0.005))
    steps = frame.depth / 0.005
    assert np.abs(steps - np.round(steps)).max() < 1e-3


def test_flying_pixels_lie_between_both_sides_of_a_jump():
    only = Noise(0, 0, 0, flying=0.5, grazing=np.pi / 2, dark_patches=0)
    frame = perception.render(SCENE, X_WC, noise=only)
    changed = np.abs(frame.depth - frame.clean) > 1e-6
    assert 200 < np.count_nonzero(changed) < 4000
    for v, u in np.argwhere(changed):
        around = frame.clean[max(v - 1, 0) : v + 2, max(u - 1, 0) : u + 2]
        assert around.min() - 1e-6 <= frame.depth[v, u] <= around.max() + 1e-6
        assert np.ptp(around) > only.jump


def test_grazing_rays_and_dark_patches_drop_out():
    low = perception.look_at([-1.5, 0, 0.15], [0, 0, 0])
    assert (perception.render([TABLE], X_WC, noise=Noise(dark_patches=0)).depth > 0).all()
    grazing = perception.render([TABLE], low, noise=Noise(dark_patches=0))
    hit = grazing.clean > 0
    share = [
        (grazing.depth[rows] > 0)[hit[rows]].mean() for rows in (slice(200, 300), slice(400, 480))
    ]
    assert share[0] < share[1]
    patches = Noise(0, 0, 0, flying=0, grazing=np.pi / 2, dark_patches=3, dark_radius=0.05)
    lost = perception.render([TABLE], X_WC, noise=patches).depth == 0
    assert 500 < np.count_nonzero(lost) < 30000


def test_the_same_seed_gives_the_same_image():
    images = [perception.render(SCENE, X_WC, seed=seed).depth for seed in (3, 3, 4)]
    assert np.array_equal(images[0], images[1])
    assert not np.array_equal(images[0], images[2])


def test_a_frame_is_saved_with_its_camera(tmp_path):
    frame = perception.render(SCENE, X_WC)
    frame.save(tmp_path / "frame.npz")
    with np.load(tmp_path / "frame.npz", allow_pickle=False) as saved:
        assert np.array_equal(saved["depth"], frame.depth)
        assert np.array_equal(saved["K"], frame.K)
        assert np.array_equal(saved["X_WC"], X_WC)


@pytest.mark.parametrize("field", ["constant", "flying", "grazing", "dark_patches", "dark_radius"])
def test_bad_noise_is_refused_by_name(field):
    with pytest.raises(ValueError, match=rf"noise.{field} is -1.*must lie in"):
        Noise(**{field: -1})


def test_a_camera_cannot_look_at_itself():
    with pytest.raises(ValueError, match="must be finite and differ from eye"):
        perception.look_at([0, 0, 1], [0, 0, 1])
    assert np.allclose(perception.look_at([0, 0, 1], [0, 0, 0])[:3, 2], [0, 0, -1])
