# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and replays: that something is on them, and that a replay needs nothing else."""

import os
import re
import shutil
import socket
import urllib.request
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh

import graspless
from browser_common import served
from graspless import Task, TaskError, cli, frames, geometry, planning, slide
from graspless._data import directory
from tasks_common import changed, last_positions, pixels, read_png, recording

pytest.importorskip("matplotlib")
pytest.importorskip("viser")

from matplotlib.colors import to_rgb  # noqa: E402
from matplotlib.path import Path  # noqa: E402

from graspless import view  # noqa: E402
from graspless.view import bodies, figures, raster, visuals  # noqa: E402
from graspless.view.film import spread, timed  # noqa: E402
from graspless.view.slide import bodies as slide_bodies  # noqa: E402
from graspless.view.slide import picture as pictures  # noqa: E402
from graspless.view.slide import stage  # noqa: E402
from graspless.view.slide.film import film  # noqa: E402

EXAMPLES = directory("examples")
OBSTACLE = to_rgb(pictures.OBSTACLE)
OBSTACLES = """obstacles:
  - {name: mug, cylinder: {radius: 0.04, length: 0.1}, pose: {position: [0.85, 0.2, 0.05]}}
  - {name: a/b, box: [0.1, 0.1, 0.1], pose: {position: [0.85, -0.2, 0.05]}}
  - {name: rod, capsule: {radius: 0.02, length: 0.1}, pose: {position: [1.2, 0.0, 0.0]}}
  - {name: ball, sphere: {radius: 0.03}, pose: {position: [1.2, 0.2, 0.0]}}
budget:"""


@pytest.fixture(scope="module")
def plan(tmp_path_factory):
    path = tmp_path_factory.mktemp("task") / "task.yaml"
    path.write_text(changed("budget:", OBSTACLES))
    plan = graspless.plan(path)
    assert plan, plan.reason
    return plan


@pytest.fixture(scope="module")
def html(plan, tmp_path_factory):
    path = tmp_path_factory.mktemp("html") / "a.html"
    view.write_html(plan, path)
    return path


def test_picture_shows_robot_table_object_trail_and_obstacles(plan, tmp_path):
    view.write_png(plan, tmp_path / "a.png")
    picture = read_png(tmp_path / "a.png")
    assert picture.shape[0] > 500
    assert picture.shape[1] > 1000
    for color in (bodies.TABLE, bodies.OBJECT, bodies.TRAIL, bodies.OBSTACLE):
        assert len(pixels(picture, color)) > 300, color
    panels = picture[:, picture.shape[1] // 2 :]
    assert np.count_nonzero(panels[..., :3].min(axis=2) < 0.95) > 0.1 * panels[..., 0].size


def test_plan_without_motion_is_drawn_as_it_starts(plan, tmp_path):
    failed = graspless.plan(plan.task, iterations=0)
    assert not failed
    view.write_png(failed, tmp_path / "a.png")
    view.write_html(failed, tmp_path / "a.html")
    assert len(pixels(read_png(tmp_path / "a.png"), bodies.OBJECT)) > 300


def test_title_of_a_failure_fits_on_the_page(plan):
    status, reason = slide.Status.interrupted, f"first {50 * 'one '}; second"
    failed = SimpleNamespace(task=plan.task, status=status, reason=reason)
    title = figures.failure(failed)
    assert title.startswith("card: interrupted: first one")
    assert title.endswith(" one …")
    text = figures.panels(title, []).texts[0]
    assert text.get_window_extent().x1 < text.figure.bbox.x1


def test_overhang_is_written_beside_the_lines_of_the_table():
    found = graspless.plan(EXAMPLES / "03_tilted_l_table.yaml")
    axes = pictures.draw(found).axes[0]
    (text,) = (text for text in axes.texts if text.get_text().startswith("overhang"))
    table = Path(np.asarray(found.task.problem.support.polygon.vertices), closed=True)
    drawn = axes.transData.transform_path(table)
    assert not drawn.intersects_bbox(text.get_window_extent(), filled=False)


def test_every_part_of_an_obstacle_is_drawn_from_above(plan):
    def at(x):
        return geometry.PlacedShape(geometry.Box([0.05, 0.05, 0.05]), frames.translation([x, 0, 0]))

    given = plan.task.problem
    gate = slide.Obstacle("gate", [at(0.4), at(0.9)], frames.translation([0.0, -0.2, 0.3]))
    gone = slide.Obstacle("gone", [at(0.4)], frames.translation([0.0, 5.0, 0.3]))
    problem = slide.Problem(
        given.robot,
        given.hand,
        given.object,
        given.support,
        given.X_WO_start,
        given.q_home,
        [gate, gone],
    )
    axes = pictures.draw(slide.plan(problem, budget=planning.Budget(iterations=0))).axes[0]
    drawn = [patch.get_xy()[:, 0] for patch in axes.patches if patch.get_fc()[:3] == OBSTACLE]
    spans = sorted([x.min(), x.max()] for x in drawn)
    np.testing.assert_allclose(spans, [[0.375, 0.425], [0.375, 0.425], [0.875, 0.925]], atol=1e-9)
    assert [text.get_text() for text in axes.texts] == ["gate"]


def test_replay_is_small_and_whole(html):
    text = html.read_text()
    assert len(text) < 2_000_000
    assert "__VISER_EMBED_DATA__" in text
    assert "<title>graspless: card, solved</title>" in text
    # Nothing is loaded from elsewhere: no source or style sheet but data and parts of the file.
    head = re.sub(r"<script.*?</script>", "", text, flags=re.DOTALL)
    assert not re.findall(r"<(?:script|link|img|iframe)[^>]*(?:src|href)=\"(?!data:)[^\"]+", head)
    assert not re.findall(r"<script[^>]*\bsrc=", text)
    assert not re.findall(r"@import|url\(\s*[\"']?https?:", text)


def test_replay_moves_every_body(plan, html):
    recorded = recording(html.read_text())
    shown = timed(film(plan))
    assert recorded["durationSeconds"] == pytest.approx(shown.times[-1] + 1.5, abs=0.1)
    messages = recorded["messages"]
    named = {message["name"] for _, message in messages if "name" in message}
    assert {"/table", "/object", "/trail", "/contact", "/goal"} <= named
    assert {"/obstacles/mug", "/obstacles/a_b"} <= named
    last = last_positions(messages)
    X_WO = shown.object_poses[-1]
    np.testing.assert_allclose(last["/object"], X_WO[:3, 3], atol=2e-6)
    robot = plan.task.problem.robot
    ends = robot.forward(shown.positions[-1])
    np.testing.assert_allclose(
        last["/robot/hand_base"], ends[robot.frame("hand_base")][:3, 3], atol=2e-6
    )


def test_film_passes_every_row_in_time(plan):
    shown = film(plan)
    assert len(shown.times) == sum(map(len, plan.segments))
    assert (np.diff(shown.times) >= 0).all()
    assert shown.times[-1] <= 30
    even = shown.resampled(20)
    np.testing.assert_allclose(np.diff(even.times), np.diff(even.times)[0])
    np.testing.assert_allclose(even.positions[[0, -1]], shown.positions[[0, -1]])
    np.testing.assert_allclose(even.object_poses[[0, -1]], shown.object_poses[[0, -1]], atol=1e-12)


def test_every_link_of_the_robot_has_its_shapes(plan):
    found = {body.name: body.parts for body in bodies.robot(plan.task)}
    for index, _ in plan.task.problem.robot.shapes:
        assert found[plan.task.problem.robot.frame_names[index]]


def test_prisms_and_shapes_face_outward(plan):
    import trimesh

    task = plan.task
    parts = slide_bodies.object_body(task).parts + slide_bodies.table_body(task).parts
    parts += [part for body, _ in bodies.obstacles(task) for part in body.parts]
    for part in parts:
        mesh = trimesh.Trimesh(part.vertices, part.triangles)
        assert mesh.volume > 0


def test_robot_without_visuals_is_drawn_by_its_collision_shapes(plan, tmp_path):
    text = re.sub(r"<visual>.*?</visual>", "", plan.task.fields.robot.urdf_text)
    (tmp_path / "bare.urdf").write_text(text)
    from graspless._data import directory

    for suffix in (".srdf", ".hand.yaml"):
        shutil.copy(directory("urdf") / f"wam_t42{suffix}", tmp_path / f"bare{suffix}")
    (tmp_path / "task.yaml").write_text(changed("wam_t42", "bare.urdf"))
    task = graspless.load_task(tmp_path / "task.yaml")
    assert sum(len(body.parts) for body in bodies.robot(task)) == len(task.problem.robot.shapes)


@pytest.mark.parametrize(
    ("mesh", "why"),
    [
        ("none.stl", "none.stl: no such file"),
        ("package://nopkg/x.dae", "package://nopkg/x.dae: robot.packages has no nopkg"),
        ("broken.dae", "broken.dae: cannot be read"),
        ("broken.nonsense", "broken.nonsense: unknown kind of mesh"),
        ("empty.obj", "empty.obj: "),
    ],
)
def test_visual_mesh_that_cannot_be_read_is_warned_of_once(plan, tmp_path, mesh, why):
    visual = f"<visual><geometry><mesh filename='{mesh}'/></geometry></visual>"
    for name in ("broken.dae", "broken.nonsense", "empty.obj"):
        (tmp_path / name).write_text("")
    robot = plan.task.fields.robot
    text = re.sub(r"<visual>.*?</visual>", visual, robot.urdf_text, count=1, flags=re.DOTALL)
    robot = robot.model_copy(update={"urdf_text": text, "directory": str(tmp_path)})
    fields = plan.task.fields.model_copy(update={"robot": robot})
    given = plan.task
    task = Task(given.problem, given.options, given.budget, fields=fields)
    visuals._warned.clear()
    with pytest.warns(UserWarning, match=re.escape(why)) as caught:
        found = [bodies.robot(task) for _ in range(2)][0]
    assert len(caught) == 1
    assert "\n" not in str(caught[0].message)
    name = str(caught[0].message).partition(":")[0]
    shapes = [i for i, _ in task.problem.robot.shapes]
    index = list(task.problem.robot.frame_names).index(name)
    assert len(found[index].parts) == shapes.count(index)


@pytest.mark.parametrize("port", [-1, 0, 65536, 99999])
def test_port_that_is_none(plan, port):
    with pytest.raises(TaskError, match=f"--port: {port}: should be from 1 to 65535"):
        view.serve(plan, port)


def test_busy_port(plan):
    with socket.socket() as busy:
        busy.bind(("127.0.0.1", 0))
        busy.listen()
        port = busy.getsockname()[1]
        with pytest.raises(TaskError, match=f"--port: {port}: cannot be served: Address already"):
            view.serve(plan, port)


def cube(color):
    import trimesh

    mesh = trimesh.creation.box([1, 1, 1])
    return bodies.Body("", [bodies.Part(mesh.vertices, mesh.faces, color)])


def test_raster_hides_what_is_behind():
    camera = raster.Camera(np.array([6.0, 0.0, 0.1]), np.zeros(3), angle=0.5)
    red, blue = cube((1.0, 0.0, 0.0)), cube((0.0, 0.0, 1.0))
    placed = [(red, np.eye(4)), (blue, frames.translation([-2.0, 0.6, 0.0]))]
    for order in (placed, placed[::-1]):
        picture = raster.render(order, camera, 120, 90)
        assert picture.shape == (90, 120, 4)
        middle = picture[45, 60]
        assert middle[0] > 0.3
        assert middle[2] < 0.05
        seen = np.flatnonzero(picture[45, :, 2] > 0.3)
        assert len(seen) > 5  # the far cube looks out on the right, at +y
        assert seen.min() > 60
        assert picture[2, 2, 3] == 0


def test_an_obstacle_before_the_object_lets_it_through():
    camera = raster.Camera(np.array([6.0, 0.0, 0.1]), np.zeros(3), angle=0.5)
    red, blue = cube((1.0, 0.0, 0.0)), cube((0.0, 0.0, 1.0))
    alone = raster.render([(red, np.eye(4))], camera, 120, 90)
    for x, y, hides in (
        (2.0, 0.0, True),
        (2.0, 1.2, False),
        (-2.0, 0.0, False),
        (8.0, 0.0, False),  # behind the viewer
    ):
        beside, placed = [(blue, frames.translation([x, y, 0.0]))], [(red, np.eye(4))]
        picture = raster.render_past(beside, placed, np.zeros(3), camera, 120, 90)
        whole = raster.render([*placed, *beside], camera, 120, 90)
        assert (whole[45, 60, 0] < 0.1) == hides
        assert np.array_equal(picture, whole) != hides
        assert picture[45, 60, 0] > 0.8 * alone[45, 60, 0]


def test_camera_fits_every_point():
    points = np.random.default_rng(1).normal(size=(200, 3)) + [3.0, 1.0, 0.5]
    camera = raster.Camera(np.array([10.0, -3.0, 4.0]), np.zeros(3)).fitted(points, 400, 300)
    seen = camera.project(points, 400, 300)
    assert seen[:, :2].min() > 0
    assert (seen[:, :2] < [400, 300]).all()
    assert max(np.ptp(seen[:, 0]) / 400, np.ptp(seen[:, 1]) / 300) > 0.85


def test_camera_of_a_replay_sees_every_pose_of_the_robot(plan):
    shown = film(plan)
    camera = stage.camera(shown, 4, 3, spread(shown))
    assert spread(shown)[-1] == len(shown.times) - 1
    robot = bodies.robot(plan.task)
    for row in range(len(shown.times)):
        for body, X_WB in zip(robot, shown.link_poses[row], strict=True):
            for part in body.parts:
                p = part.vertices @ X_WB[:3, :3].T + X_WB[:3, 3]
                seen = camera.project(p, 400, 300)[:, :2]
                assert seen.min() > 0
                assert (seen < [400, 300]).all()


def test_unwritable_pictures(plan, tmp_path):
    for write in (view.write_png, view.write_html):
        with pytest.raises(TaskError, match="cannot be written"):
            write(plan, tmp_path / "none" / "a")


def test_what_is_no_plan_is_told(plan, tmp_path):
    for given in (str(tmp_path / "plan.json"), plan.task, None):
        writes = (view.write_png, view.write_html)
        takes = [view.figure, view.show, view.html, view.serve]
        for use in [*takes, *(partial(write, path=tmp_path / "a") for write in writes)]:
            with pytest.raises(
                TaskError, match=r"plan: .*: should be a graspless\.Plan; .*load_plan"
            ):
                use(given)
    assert not any(tmp_path.iterdir())


def test_viewer_serves_until_ctrl_c(plan, tmp_path):
    with served(plan, tmp_path) as address:
        page = urllib.request.urlopen(address, timeout=10).read()
        assert b"<html" in page


def test_the_contact_on_a_bowl_is_on_its_bottom(bowl_problem):
    plan = slide.plan(bowl_problem)
    assert plan, plan.reason
    shown = film(plan)
    marked = np.concatenate([part.vertices for part in slide_bodies.contact_body(shown).parts])
    assert np.abs(marked[:, 2] - bowl_problem.object.top).max() < 0.003
    trail = np.concatenate([part.vertices for part in slide_bodies.trail_body(shown).parts])
    assert np.abs(trail[:, 2] - bowl_problem.object.top).max() < 0.003


def test_a_carry_without_obstacles_is_drawn(tmp_path):
    text = """kind: carry
robot: {urdf: wam_t42, home: {wam_joint_2: 0.7, wam_joint_4: 1.6, wam_joint_6: 0.84}}
frame: grasp
object: {name: bar, box: [0.02, 0.02, 0.10]}
pose: {position: [0.65, 0.0, 0.29]}
offset: [0.0, 0.1, 0.05]
"""
    (tmp_path / "carry.yaml").write_text(text)
    plan = graspless.plan(tmp_path / "carry.yaml")
    assert plan, plan.reason
    plan.save(tmp_path / "plan.json")
    png, html = tmp_path / "carry.png", tmp_path / "carry.html"
    given = ["--png", str(png), "--html", str(html)]
    assert cli.main(["view", str(tmp_path / "plan.json"), *given]) == 0
    assert len(pixels(read_png(png), bodies.OBJECT)) > 300
    messages = recording(html.read_text())["messages"]
    assert {"/robot", "/object", "/goal"} <= {m["name"] for _, m in messages if "name" in m}


def test_visual_meshes_are_read_once_for_each_change_of_their_file(tmp_path):
    robot = SimpleNamespace(packages={}, directory=str(tmp_path))
    path = tmp_path / "a.stl"
    trimesh.creation.box([1, 1, 1]).export(path)
    visuals.read_visual("a.stl", robot).apply_scale(2)  # is the caller's own
    np.testing.assert_allclose(visuals.read_visual("a.stl", robot).extents, 1)
    trimesh.creation.box([3, 3, 3]).export(path)
    os.utime(path, ns=(1, 1))
    np.testing.assert_allclose(visuals.read_visual("a.stl", robot).extents, 3)
