# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays of fingertip plans: that what they shall show is on them."""

import numpy as np
import pytest

import graspless
from fingertip_common import TUMBLE, changed
from graspless.tasks import read_task
from tasks_common import last_positions, pixels, read_png, recording

pytest.importorskip("matplotlib")
pytest.importorskip("viser")

from graspless import view  # noqa: E402
from graspless.view.bodies import OBJECT  # noqa: E402
from graspless.view.fingertip import bodies, carried, stage  # noqa: E402
from graspless.view.fingertip.film import film  # noqa: E402
from graspless.view.fingertip.moments import measure, moments, progress  # noqa: E402

SHORT = changed("segments: 30", "segments: 10", TUMBLE)


@pytest.fixture(scope="module")
def plan():
    plan = graspless.plan(read_task(SHORT, "task.yaml"))
    assert plan, plan.reason
    assert plan.regrasps == 1
    return plan


@pytest.fixture(scope="module")
def picture(plan, tmp_path_factory):
    path = tmp_path_factory.mktemp("png") / "a.png"
    view.write_png(plan, path)
    return read_png(path)


def test_picture_shows_object_fingers_forces_floor_and_walls(picture):
    assert picture.shape[1] == 1650
    for color in (OBJECT, bodies.FLOOR, bodies.POSITION, bodies.FORCE, bodies.ARROW):
        assert len(pixels(picture, color)) > 300, color
    panels = picture[60:330]
    assert len(pixels(panels, bodies.FORCE)) > 150
    assert len(pixels(panels, bodies.POSITION)) > 150
    assert len(pixels(panels, bodies.ARROW)) > 150


def test_curves_show_both_indices_and_the_limit(picture):
    lower = picture[-300:]
    for color in ((0x1F, 0x5F, 0x8B), (0xD9, 0x8A, 0x1F), (0xB3, 0x26, 0x1E)):
        assert len(pixels(lower, np.array(color) / 255)) > 100, color


def test_moments_are_start_regrasp_and_goal(plan):
    shown = moments(plan)
    captions = [moment.caption for moment in shown]
    assert captions[0] == "start"
    assert captions[-1] == "goal"
    before = next(k for k, caption in enumerate(captions) if caption.startswith("before regrasp"))
    assert captions[before + 1].startswith("after regrasp")
    assert captions[before].rpartition(", ")[2] == captions[before + 1].rpartition(", ")[2]
    np.testing.assert_allclose(shown[before].X_WO, shown[before + 1].X_WO, atol=1e-12)
    moved = np.linalg.norm(shown[before].centers - shown[before + 1].centers, axis=1) > 1e-6
    assert np.flatnonzero(moved).tolist() == [plan.segments[1].finger]
    radius = plan.task.problem.fingers.radius
    for moment in shown:
        assert moment.centers_W[:, 2].min() > radius - 1e-9  # above the floor


def test_degrees_along_the_way(plan):
    each, unit = measure(plan.segments)
    assert unit == "tumble [degrees]"
    assert each * 10 == pytest.approx(90)
    along = np.concatenate(progress(plan.segments)) * each
    assert along[0] == pytest.approx(1.5)
    assert (np.diff(along) >= 0).all()
    assert along[-1] == pytest.approx(88.5)


def test_forces_point_on_to_the_fingertips(plan):
    moment = moments(plan)[0]
    largest = np.linalg.norm(moment.forces, axis=1).max()
    ends = bodies.arrow_ends(plan.task, moment, largest)
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    size = plan.task.problem.object.size
    assert lengths.max() == pytest.approx(bodies.LONGEST_ARROW * size)
    to_center = moment.centers_W - ends[:, 1]
    radius = plan.task.problem.fingers.radius
    np.testing.assert_allclose(np.linalg.norm(to_center, axis=1), radius)
    along = np.einsum("ki,ki->k", to_center, moment.forces_W)
    assert (along > 0).all()


def test_camera_looks_over_no_wall_from_behind(plan):
    shown = moments(plan)
    points = stage.swept(plan.task, shown)
    camera = stage.camera(plan.task, shown, points, (400, 300))
    toward = camera.eye - camera.target
    for wall in plan.task.problem.planes[1:]:
        assert np.asarray(wall.n_W) @ toward > 0
    seen = camera.project(points, 400, 300)
    assert (seen[:, :2] >= 0).all()
    assert (seen[:, 0] <= 400).all()
    assert (seen[:, 1] <= 300).all()


def test_floor_ends_at_the_walls(plan):
    points = stage.swept(plan.task, moments(plan))
    floor = bodies.floor_body(plan.task, points).parts[0].vertices
    for wall in plan.task.problem.planes[1:]:
        assert (floor @ np.asarray(wall.n_W)).min() > wall.offset - 0.01
    assert floor[:, 2].max() == pytest.approx(0.0)
    assert len(bodies.wall_bodies(plan.task, points)) == 2


def test_film_goes_round_the_object(plan):
    shown = film(plan, 20.0)
    assert 60 < len(shown) <= 20 * 30 + 2
    np.testing.assert_allclose(shown[0].X_WO, plan.segments[0].X_WO[0], atol=1e-9)
    np.testing.assert_allclose(shown[-1].X_WO, plan.segments[-1].X_WO[-1], atol=1e-9)
    steps = np.linalg.norm(np.diff([m.centers for m in shown], axis=0), axis=2)
    assert steps.max() < 0.03  # no finger jumps
    finger = plan.segments[1].finger
    free = [moment for moment in shown if moment.modes[finger] == "free"]
    assert free
    for moment in free[1:-1]:  # outside of the object, in its frame
        outside = np.abs(moment.centers[finger]) - [0.025, 0.025, 0.05]
        assert outside.max() > 0


def test_replay_shows_fingers_forces_and_walls(plan, tmp_path):
    view.write_html(plan, tmp_path / "a.html")
    text = (tmp_path / "a.html").read_text()
    assert len(text) < 2_000_000
    assert "<title>graspless: block, solved</title>" in text
    messages = recording(text)["messages"]
    named = {message["name"] for _, message in messages if "name" in message}
    assert {"/object", "/floor", "/walls/behind", "/walls/beside", "/forces"} <= named
    assert {"/fingers/0/position", "/fingers/0/force", "/fingers/1/free"} <= named
    last = last_positions(messages)
    goal = moments(plan)[-1]
    np.testing.assert_allclose(last["/object"], goal.X_WO[:3, 3], atol=2e-6)
    np.testing.assert_allclose(last["/fingers/0"], goal.centers_W[0], atol=2e-6)


def test_plan_without_motion_is_drawn_as_it_starts(plan, tmp_path):
    failed = graspless.plan(plan.task, seconds=1e-6)
    assert not failed
    assert not failed.segments
    view.write_png(failed, tmp_path / "a.png")
    assert len(pixels(read_png(tmp_path / "a.png"), OBJECT)) > 300
    view.write_html(failed, tmp_path / "a.html")


def test_the_arm_is_not_between_the_object_and_the_viewer():
    arm = carried._along(np.array([[0.0, -0.8, 0.0], [0.0, -0.8, 0.4], [0.0, 0.0, 0.2]]))
    before = np.array([0.0, -0.9, 0.4])
    shown = carried._unhidden([arm], before, 0.1)
    assert carried._clearance(arm, before, 0.1) < 0.2
    assert carried._clearance(arm, shown, 0.1) == carried.CLEAR
    np.testing.assert_array_equal(carried._unhidden([arm], -before, 0.1), -before)
