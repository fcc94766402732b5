# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays of clasps and loops: that what they shall show is on them."""

import numpy as np
import pytest

import graspless
from clasp_common import purse, purse_plan
from graspless import geometry
from tasks_common import last_positions, pixels, read_png, recording

pytest.importorskip("matplotlib")
pytest.importorskip("viser")

from graspless import view  # noqa: E402
from graspless.view.bodies import OBJECT  # noqa: E402
from graspless.view.clasp import bodies, stage  # noqa: E402
from graspless.view.clasp.film import film, linking, linking_at  # noqa: E402
from graspless.view.surface import surface_part  # noqa: E402
from graspless.view.tubes import smooth, tube  # noqa: E402

plan = pytest.fixture(scope="module")(purse_plan)


def test_picture_shows_object_loop_curves_tree_and_linking(plan, tmp_path):
    view.write_png(plan, tmp_path / "a.png")
    picture = read_png(tmp_path / "a.png")
    assert picture.shape[1] == 1650
    for color in (OBJECT, bodies.CLASPED, bodies.CURVE, bodies.CHORD, bodies.PATH):
        assert len(pixels(picture, color)) > 100, color
    upper, lower = picture[60:440], picture[450:]
    assert len(pixels(upper, OBJECT)) > 1000
    assert len(pixels(lower[:, :550], bodies.CLASPED)) > 200  # the loop on the cloud
    close_up = lower[:, 550:1100]
    assert len(pixels(close_up, bodies.CURVE)) > 200


def test_plan_without_motion_is_drawn_as_it_starts(plan, tmp_path):
    failed = graspless.plan(plan.task, iterations=0)
    assert not failed
    view.write_png(failed, tmp_path / "a.png")
    view.write_html(failed, tmp_path / "a.html")
    assert len(pixels(read_png(tmp_path / "a.png"), OBJECT)) > 300


def test_moments_are_start_linked_and_clasped(plan):
    found = linking(plan)
    (start, _), (linked, _), (last, caption) = stage.moments(plan)
    assert (start, last) == (0, len(found) - 1)
    assert (found[linked:] > 0).all()
    assert (found[linked - 1] == 0).any()
    assert caption == "3  clasped"


def test_curves_run_from_finger_to_thumb(plan):
    shown = film(plan)
    hand, robot = plan.task.problem.hand, plan.task.problem.robot
    curves = bodies.finger_curves(plan.task, shown.link_poses[-1])
    names = list(robot.frame_names)
    for curve, finger in zip(curves, hand.fingers, strict=True):
        for corner, node in ((curve[0], finger.nodes[-1]), (curve[-1], hand.thumb.nodes[-1])):
            X_WL = shown.link_poses[-1, names.index(node.link)]
            np.testing.assert_allclose(corner, X_WL[:3, :3] @ node.p_L + X_WL[:3, 3])
    loop = plan.task.problem.object.loops.found[plan.loop].points
    X_WO = np.asarray(plan.task.problem.X_WO)
    ring = loop @ X_WO[:3, :3].T + X_WO[:3, 3]
    drawn = [abs(geometry.virtual_linking(ring, curve)) for curve in curves]
    np.testing.assert_allclose(drawn, linking(plan)[-1], atol=1e-9)


def test_camera_sees_hand_and_object(plan):
    scene = stage.Scene(plan, film(plan))
    camera = stage.camera(scene, [0, len(scene.shown.times) - 1], (400, 300))
    for body, X_WB in scene.solid(0):
        for part in body.parts:
            seen = camera.project(part.vertices @ X_WB[:3, :3].T + X_WB[:3, 3], 400, 300)[:, :2]
            assert seen.min() > 0
            assert (seen < [400, 300]).all()


def test_replay_has_loops_cloud_tree_and_tells_the_linking(plan, tmp_path):
    view.write_html(plan, tmp_path / "a.html")
    text = (tmp_path / "a.html").read_text()
    assert len(text) < 3_000_000
    assert "<title>graspless: purse, solved</title>" in text
    messages = recording(text)["messages"]
    named = {message["name"] for _, message in messages if "name" in message}
    assert {"/object", "/cloud", "/loops/loop 0", "/target", "/curves", "/tree"} <= named
    ends = "  ".join(f"{value:.2f}" for value in linking(plan)[-1])
    told = [m["updates"]["text"] for _, m in messages if "text" in m.get("updates", {})]
    assert told[-1] == f"close: virtual linking {ends}"
    shown = film(plan)
    robot = plan.task.problem.robot
    palm = shown.link_poses[-1, robot.frame(plan.task.problem.hand.frame), :3, 3]
    name = f"/robot/{plan.task.problem.hand.frame}"
    np.testing.assert_allclose(last_positions(messages)[name], palm, atol=2e-6)


def test_linking_of_a_moment_is_that_of_the_row_before(plan):
    shown = film(plan)
    at_rows = linking_at(plan, shown, shown.times)
    later = shown.times[:-1] < shown.times[1:]
    np.testing.assert_array_equal(at_rows[:-1][later], linking(plan)[:-1][later])


def test_surface_of_a_complex_is_its_outside():
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1.0]])
    sides = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]
    import trimesh

    one = surface_part(corners, sides, OBJECT)
    assert trimesh.Trimesh(one.vertices, one.triangles).volume == pytest.approx(1 / 6)
    two = surface_part(corners, [*sides, [1, 2, 4], [1, 3, 4], [2, 3, 4]], OBJECT)
    mesh = trimesh.Trimesh(two.vertices, two.triangles)
    assert len(two.triangles) == 6  # the wall between is not seen
    assert mesh.volume == pytest.approx(1 / 6 + 1 / 3)
    sheet = surface_part(corners, [[0, 1, 2]], OBJECT)
    assert len(sheet.triangles) == 2  # of either side


def test_surface_of_a_ring_faces_outward():
    import trimesh

    torus = trimesh.creation.torus(0.1, 0.015)
    shape = geometry.PlacedShape(geometry.Mesh(torus.vertices, torus.faces))
    cloud = geometry.sample_surface([shape], 800)
    found = geometry.Filtration(cloud).complex(0.035)  # so long that the inside is filled
    part = surface_part(found.points, found.triangles, OBJECT)
    assert len(part.triangles) < len(found.triangles)
    mesh = trimesh.Trimesh(part.vertices, part.triangles)
    assert mesh.volume == pytest.approx(torus.volume, rel=0.15)


def test_tubes_have_their_radius():
    import trimesh

    line = np.array([[0, 0, 0], [1, 0, 0.0]])
    part = tube(line, 0.1, OBJECT)
    np.testing.assert_allclose(np.linalg.norm(part.vertices[:, 1:], axis=1), 0.1)
    angles = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    ring = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(40)])
    closed = tube(ring, 0.1, OBJECT, closed=True)
    mesh = trimesh.Trimesh(closed.vertices, closed.triangles)
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(2 * np.pi**2 * 0.01, rel=0.1)
    assert not len(tube(line[:1], 0.1, OBJECT).triangles)
    zigzag = line[0] + np.column_stack([np.arange(20), np.resize([0, 0.1], 20), np.zeros(20)])
    assert np.ptp(smooth(zigzag)[3:-3, 1]) < 0.02


def test_the_legend_of_loops_is_beside_the_points(monkeypatch, plan):
    from graspless.view import loops

    drawn = []
    monkeypatch.setattr(loops, "as_png", drawn.append)
    thing = plan.task.problem.object
    loops.draw(thing.points, thing.loops)
    cloud, betti = drawn[0].axes
    renderer = drawn[0].canvas.get_renderer()
    legend = cloud.get_legend().get_window_extent(renderer)
    assert legend.x0 >= cloud.get_window_extent(renderer).x1
    assert legend.x1 <= betti.get_tightbbox(renderer).x0


def test_loops_are_drawn_with_their_betti_curve(tmp_path):
    thing = purse()
    view.write_loops_png(thing.points, thing.loops, tmp_path / "a.png")
    picture = read_png(tmp_path / "a.png")
    assert picture.shape[1] > 1300
    ball = np.random.default_rng(1).normal(size=(300, 3))
    ball /= 10 * np.linalg.norm(ball, axis=1, keepdims=True)
    view.write_loops_png(ball, geometry.shortest_loops(ball), tmp_path / "b.png")
